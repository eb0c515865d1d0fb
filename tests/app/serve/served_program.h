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

/// `vitrine serve` in a folder of its own, as a child process.
class ServedProgram {
public:
    /// Returns once it serves. Throws std::runtime_error, with what it said, when it ends instead.
    explicit ServedProgram(const Environment& changes = {}, const std::vector<std::string>& options = {});
    /// At a path of the caller's.
    explicit ServedProgram(std::string socket, const Environment& changes = {});
    ~ServedProgram();
    ServedProgram(const ServedProgram&) = delete;
    ServedProgram& operator=(const ServedProgram&) = delete;

    [[nodiscard]] const std::string& socket() const { return socket_; }
    [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
    /// What it has said on standard error so far.
    [[nodiscard]] std::string log() const { return bytesOf(folder_ / "err"); }
    [[nodiscard]] pid_t id() const { return child_; }
    /// Sends the signal and waits; the exit code as Ended has it.
    int end(int signal);
    /// Whether it still runs.
    [[nodiscard]] bool alive() const;

private:
    void start(const Environment& changes, const std::vector<std::string>& options = {});

    TemporaryFolder folder_;
    std::string socket_;
    pid_t child_ = -1;
};

/// A connection to it. What does not come within a minute is a failure of the test, by an exception.
class RpcClient {
public:
    explicit RpcClient(const std::string& socket);

    /// Sends the bytes as they are; false when the other end is closed.
    bool send(std::string_view bytes);
    /// As many as are taken at once.
    std::size_t sendSome(std::string_view bytes);
    /// No more will be sent.
    void endInput();
    /// The next line without its end; nothing: the other end was closed.
    [[nodiscard]] std::optional<std::string> readLine();
    /// The next line as JSON. Throws std::runtime_error when none comes.
    [[nodiscard]] render::Json read();
    /// Sends one line and returns the answer to it; events that come before it go to `events`.
    [[nodiscard]] render::Json ask(const std::string& line);
    /// The answer to a request: an object with "result" or "error".
    [[nodiscard]] render::Json call(const std::string& method, const render::Json& params = render::Json::object());
    /// Its result; throws std::runtime_error with the message of an error.
    [[nodiscard]] render::Json result(const std::string& method, const render::Json& params = render::Json::object());

    std::deque<render::Json> events;

private:
    render::Descriptor socket_;
    std::string input_;
    int lastId_ = 0;
};

/// A request as a line.
[[nodiscard]] std::string requestLine(const render::Json& id, const std::string& method, const render::Json& params);

}  // namespace vitrine::test
