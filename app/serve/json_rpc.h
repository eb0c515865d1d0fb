#pragma once

#include "render/failure.h"
#include "render/files/strict_json.h"

#include <exception>
#include <stdexcept>
#include <string>

namespace vitrine::app {

/// Error codes of JSON-RPC 2.0 and of this service. A Failure with ErrorKind::usage is `params`. Any other Failure is
/// `ofFailure` minus its exit code: -32005 for a file that was not read or written.
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

/// Limits of one line.
inline constexpr render::JsonLimits rpcLimits{
    .bytes = 1U << 20U, .depth = 32, .nodes = 10'000, .stringBytes = 1U << 20U};

/// Request of JSON-RPC.
struct RpcRequest {
    render::Json id;          ///< Text, number or null.
    bool wantsAnswer = true;  ///< The request has an id. false: it is a notification.
    std::string method;
    render::Json params = render::Json::object();  ///< Parameters by name.
    std::size_t bytes = 0;                         ///< Size of its line.
};

/// Error in a request; `what()` is one sentence.
class RpcFailure : public std::runtime_error {
public:
    RpcFailure(RpcCode code, const std::string& message, render::Json id = nullptr)
        : std::runtime_error(message), code_(code), id_(std::move(id))
    {
    }
    [[nodiscard]] RpcCode code() const { return code_; }
    [[nodiscard]] const render::Json& id() const { return id_; }  ///< Id of the request, as far as it could be read.

private:
    RpcCode code_;
    render::Json id_;
};

/// Parses a line, without its end. Throws RpcFailure, with the request's id if it can be found. Batches are refused.
[[nodiscard]] RpcRequest parseRequest(const std::string& line);

// Return one line of JSON each, with its end. Bytes that are not UTF-8, as in file names, are replaced.

[[nodiscard]] std::string answerLine(const render::Json& id, const render::Json& result);
[[nodiscard]] std::string errorLine(const render::Json& id, RpcCode, const std::string& message);
/// Returns the line for an exception that a request caused. "data" has the kind and exit code of a Failure.
[[nodiscard]] std::string errorLine(const render::Json& id, const std::exception&);
[[nodiscard]] std::string eventLine(const std::string& method, const render::Json& params);

/// Converts options in a message of the command line to the names of params: "--max-error" becomes "max_error". Text
/// within `backquotes` is left alone.
[[nodiscard]] std::string withoutDashes(const std::string& message);

}  // namespace vitrine::app
