#pragma once

#include "render/failure.h"
#include "render/files/strict_json.h"

#include <exception>
#include <stdexcept>
#include <string>

namespace vitrine::app {

/// Of the errors that JSON-RPC 2.0 names, and of ours. A Failure is `params` where the asker is to blame
/// (Blame::usage), else `ofFailure` less its exit code: -32005 for a file that was not read or not written.
enum class RpcCode : int {
    parse = -32700,
    request = -32600,
    method = -32601,
    params = -32602,
    internal = -32603,
    ofFailure = -32000,
    canceled = -32010,
    dropped = -32011,  ///< The connection ends.
};

/// What one line may be at most.
inline constexpr render::JsonLimits rpcLimits{
    .bytes = 1U << 20U, .depth = 32, .nodes = 10'000, .stringBytes = 1U << 20U};

/// One request.
struct RpcRequest {
    render::Json id;          ///< A text, a number or null.
    bool wantsAnswer = true;  ///< It has an id; false: it is a notification.
    std::string method;
    render::Json params = render::Json::object();  ///< By name.
    std::size_t bytes = 0;                         ///< Of its line.
};

/// What is wrong with a request, in one sentence.
class RpcFailure : public std::runtime_error {
public:
    RpcFailure(RpcCode code, const std::string& message, render::Json id = nullptr)
        : std::runtime_error(message), code_(code), id_(std::move(id))
    {
    }
    [[nodiscard]] RpcCode code() const { return code_; }
    [[nodiscard]] const render::Json& id() const { return id_; }  ///< Of the request, as far as it was understood.

private:
    RpcCode code_;
    render::Json id_;
};

/// Reads a line without its end. Throws RpcFailure, with the id also where the line is not read but its id can be. One
/// request a line: batches are refused.
[[nodiscard]] RpcRequest parseRequest(const std::string& line);

// One line of JSON each, with its end. What is no UTF-8, as names of files may be, is replaced.

[[nodiscard]] std::string answerLine(const render::Json& id, const render::Json& result);
[[nodiscard]] std::string errorLine(const render::Json& id, RpcCode, const std::string& message);
/// Of whatever was thrown while the request was served; "data" has blame and exit code of a Failure.
[[nodiscard]] std::string errorLine(const render::Json& id, const std::exception&);
[[nodiscard]] std::string eventLine(const std::string& method, const render::Json& params);

/// A message of the command line with its options as params are written: "--max-error" becomes "max_error", but not
/// within `backquotes`.
[[nodiscard]] std::string withoutDashes(const std::string& message);

}  // namespace vitrine::app
