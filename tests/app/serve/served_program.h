#pragma once

#include "render/files/descriptor.h"
#include "render/files/strict_json.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <sys/types.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::test {

/// Child process that runs `vitrine serve` in a folder of its own.
class ServedProgram {
public:
    /// Returns once the server is ready. Throws std::runtime_error with its output if it ends instead.
    explicit ServedProgram(const Environment& changes = {}, const std::vector<std::string>& options = {});
    /// The same with a socket at this path.
    explicit ServedProgram(std::string socket, const Environment& changes = {});
    ~ServedProgram();
    ServedProgram(const ServedProgram&) = delete;
    ServedProgram& operator=(const ServedProgram&) = delete;

    [[nodiscard]] const std::string& socket() const { return socket_; }
    [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
    /// Returns its standard error so far.
    [[nodiscard]] std::string log() const { return bytesOf(folder_ / "err"); }
    [[nodiscard]] pid_t id() const { return child_; }
    /// Sends the signal and waits. Returns the exit code as in Ended.
    int end(int signal);
    /// Returns whether the process is running.
    [[nodiscard]] bool alive() const;

private:
    void start(const Environment& changes, const std::vector<std::string>& options = {});

    TemporaryFolder folder_;
    std::string socket_;
    pid_t child_ = -1;
};

/// Connection to the server. Waiting for more than a minute throws an exception, which fails the test.
class RpcClient {
public:
    explicit RpcClient(const std::string& socket);

    /// Sends the bytes unchanged. Returns false if the other end is closed.
    bool send(std::string_view bytes);
    /// Sends as many bytes as the socket accepts. Returns their number.
    std::size_t sendSome(std::string_view bytes);
    /// Closes the sending side.
    void endInput();
    /// Returns the next line without its end; nullopt if the other end was closed.
    [[nodiscard]] std::optional<std::string> readLine();
    /// Returns the next line as JSON. Throws std::runtime_error if there is none.
    [[nodiscard]] render::Json read();
    /// Sends a line and returns the answer. Events that arrive before it are added to `events`.
    [[nodiscard]] render::Json ask(const std::string& line);
    /// Returns the answer to a request: an object with "result" or "error".
    [[nodiscard]] render::Json call(const std::string& method, const render::Json& params = render::Json::object());
    /// Returns the result of a request. Throws std::runtime_error with the message of an error.
    [[nodiscard]] render::Json result(const std::string& method, const render::Json& params = render::Json::object());

    std::deque<render::Json> events;

private:
    render::Descriptor socket_;
    std::string input_;
    int lastId_ = 0;
};

/// Returns a request as a line.
[[nodiscard]] std::string requestLine(const render::Json& id, const std::string& method, const render::Json& params);

}  // namespace vitrine::test
