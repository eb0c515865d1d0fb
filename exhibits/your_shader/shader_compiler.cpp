#include "exhibits/your_shader/shader_compiler.h"

#include "render/failure.h"
#include "render/files/number_text.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
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
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return {};
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
        return message(
            "The shader could not be read: the GLSL compiler needs more than {1} s of processor time for it; make it "
            "shorter.",
            mostProcessorSeconds);
    if (WIFEXITED(status) && WEXITSTATUS(status) == outOfMemoryCode)
        return message(
            "The shader could not be read: the GLSL compiler needs more than 512 MB for it; make it shorter.");
    return message(
        "The shader could not be read: the GLSL compiler failed on it; make it simpler, for example with fewer "
        "nested brackets.");
}

double ShaderCompiler::processorSeconds() const
{
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool ShaderCompiler::waitFor(short event)
{
    const auto look =
        std::clamp(limits_.longestStall / 4, std::chrono::milliseconds(1), std::chrono::milliseconds(1000));
    double used = processorSeconds();
    for (auto since = Clock::now();;) {
        pollfd descriptor{.fd = socket_, .events = event, .revents = 0};
        if (::poll(&descriptor, 1, static_cast<int>(look.count())) > 0) return true;
        const double now = processorSeconds();
        if (now == used && Clock::now() - since >= limits_.longestStall) return false;
        if (now != used) since = Clock::now();
        used = now;
    }
}

ShaderCompiler::End ShaderCompiler::send(const std::string& bytes)
{
    for (std::size_t at = 0; at < bytes.size();) {
        if (!waitFor(POLLOUT)) return End::hung;  // A process that hangs reads nothing.
        const ssize_t sent = ::send(socket_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent <= 0) return End::ended;
        at += static_cast<std::size_t>(sent);
    }
    return End::answered;
}

ShaderCompiler::End ShaderCompiler::receive(void* to, std::size_t size)
{
    for (auto* at = static_cast<char*>(to); size > 0;) {
        if (!waitFor(POLLIN)) return End::hung;
        const ssize_t got = ::read(socket_, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return End::ended;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return End::answered;
}

ShaderCompiler::End ShaderCompiler::tryOnce(const CompilerRequest& request, Result& result)
{
    if (process_ < 0) start();
    const double before = processorSeconds();
    const std::string bytes = packed(request);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    std::uint32_t length = 0;
    std::string answer;
    End end = send(std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes);
    if (end == End::answered) end = receive(&length, sizeof length);
    if (end == End::answered && length <= mostMessageBytes) {
        answer.resize(length);
        end = receive(answer.data(), length);
    }
    if (end == End::hung) stop();
    if (end == End::ended) result.problem = endOfProcess();
    if (end != End::answered) return end;
    result.processorSeconds = processorSeconds() - before;
    if (auto unpacked = unpackedAnswer(answer)) {
        result.answer = std::move(*unpacked);
        return end;
    }
    stop();
    result.problem =
        message("The shader could not be read: the GLSL compiler answered nonsense; install or build Vitrine again.");
    return end;
}

ShaderCompiler::Result ShaderCompiler::compile(const CompilerRequest& request)
{
    Result result;
    End end = End::hung;
    for (int i = 0; i < 2 && end != End::answered && result.problem.empty(); ++i) end = tryOnce(request, result);
    if (end == End::answered || !result.problem.empty()) return result;
    result.problem =
        end == End::hung
            ? message("The shader could not be read: the GLSL compiler hangs; it did nothing for {1} s, two times. "
                      "Save the file again to try it again.",
                      render::shortNumber(std::chrono::duration<double>(limits_.longestStall).count()))
            : message("The shader could not be read: another program, or the system for want of memory, ended the "
                      "GLSL compiler two times. Save the file again to try it again.");
    return result;
}

}  // namespace vitrine::guest
