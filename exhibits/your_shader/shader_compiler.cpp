#include "exhibits/your_shader/shader_compiler.h"

#include "render/failure.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

extern char** environ;  // NOLINT: POSIX declares it nowhere.

namespace vitrine::guest {
namespace {

using Clock = std::chrono::steady_clock;

std::filesystem::path compilerFile()
{
    namespace fs = std::filesystem;
    constexpr const char* name = "vitrine_shader_compiler";
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& place : {here / name, here.parent_path() / name, here.parent_path() / "lib" / "vitrine" / name,
                                  fs::path(VITRINE_SHADER_COMPILER_BUILT)})
        if (fs::exists(place, error)) return place;
    throw Failure(ErrorKind::file,
                  message("Cannot start {1}, which translates shaders: it is not beside the program; install or "
                          "build Vitrine again.",
                          name));
}

/// Waits until the socket can be read, or the time is over.
bool waitFor(int socket, Clock::time_point end)
{
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        pollfd descriptor{.fd = socket, .events = POLLIN, .revents = 0};
        const int ready = ::poll(&descriptor, 1, static_cast<int>(left));
        if (ready < 0 && errno == EINTR) continue;
        return ready > 0;
    }
}

bool send(int socket, const std::string& bytes)
{
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t sent = ::send(socket, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += static_cast<std::size_t>(sent);
    }
    return true;
}

enum class Received { all, ended, late };

Received receive(int socket, void* to, std::size_t size, Clock::time_point end)
{
    for (auto* at = static_cast<char*>(to); size > 0;) {
        if (!waitFor(socket, end)) return Received::late;
        const ssize_t got = ::read(socket, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return Received::ended;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return Received::all;
}

Message tooLong()
{
    return message("The shader could not be read: the GLSL compiler needs more than 2 s for it; make it shorter.");
}

}  // namespace

void ShaderCompiler::start()
{
    const std::filesystem::path file = compilerFile();
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        throw Failure(ErrorKind::file, message("Cannot start {1}: {2}", file, std::strerror(errno)));
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, sockets[1], STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, sockets[1], STDOUT_FILENO);
    // Messages that a crashing compiler writes to standard error are not shown to visitors.
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_RDWR, 0);
    std::string name = file.string();
    std::array<char*, 2> arguments{name.data(), nullptr};
    const int error = ::posix_spawn(&process_, name.c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(sockets[1]);
    socket_ = sockets[0];
    if (error == 0) return;
    process_ = -1;
    stop();
    throw Failure(ErrorKind::file, message("Cannot start {1}: {2}", file, std::strerror(error)));
}

void ShaderCompiler::stop()
{
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    process_ = -1;
}

Message ShaderCompiler::endOfProcess()
{
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    stop();
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) return tooLong();
    if (WIFEXITED(status) && WEXITSTATUS(status) == outOfMemoryCode)
        return message(
            "The shader could not be read: the GLSL compiler needs more than 512 MB for it; make it shorter.");
    return message(
        "The shader could not be read: the GLSL compiler failed on it; make it simpler, for example with fewer "
        "nested brackets.");
}

ShaderCompiler::Result ShaderCompiler::compile(const CompilerRequest& request, Clock::time_point end)
{
    if (process_ < 0) start();
    const std::string bytes = packed(request);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    if (!send(socket_, std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes))
        return {.answer = {}, .problem = endOfProcess()};
    std::uint32_t length = 0;
    std::string answer;
    Received received = receive(socket_, &length, sizeof length, end);
    if (received == Received::all && length <= mostMessageBytes) {
        answer.resize(length);
        received = receive(socket_, answer.data(), length, end);
    }
    if (received == Received::late) {
        stop();
        return {.answer = {},
                .problem =
                    message("The shader could not be read: the GLSL compiler did not answer in time; save the file "
                            "again when the computer is less busy.")};
    }
    if (received == Received::ended) return {.answer = {}, .problem = endOfProcess()};
    auto unpacked = unpackedAnswer(answer);
    if (unpacked) return {.answer = std::move(*unpacked), .problem = {}};
    stop();
    return {.answer = {},
            .problem = message(
                "The shader could not be read: the GLSL compiler answered nonsense; install or build Vitrine again.")};
}

}  // namespace vitrine::guest
