#include "tests/app/serve/served_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace vitrine::test {
namespace {

constexpr int minuteMilliseconds = 60'000;

/// Waits for events of a descriptor. Throws after a minute.
void waitFor(int descriptor, short events)
{
    pollfd polled{descriptor, events, 0};
    if (::poll(&polled, 1, minuteMilliseconds) <= 0) throw std::runtime_error("the server says nothing for a minute");
}

}  // namespace

ServedProgram::ServedProgram(const Environment& changes, const std::vector<std::string>& options)
    : socket_(folder_ / "socket")
{
    start(changes, options);
}

ServedProgram::ServedProgram(std::string socket, const Environment& changes) : socket_(std::move(socket))
{
    start(changes);
}

void ServedProgram::start(const Environment& changes, const std::vector<std::string>& options)
{
    std::vector<const char*> words{VITRINE_PROGRAM, "serve", "--socket", socket_.c_str()};
    for (const std::string& option : options) words.push_back(option.c_str());
    words.push_back(nullptr);
    const std::string err = folder_ / "err";
    std::array<int, 2> out{};
    if (::pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
        ::umask(0);  // The permissions of the socket must not depend on the umask.
        for (const auto& [name, value] : changes) ::setenv(name.c_str(), value.c_str(), 1);
        ::dup2(out[1], 1);
        ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), 2);
        ::execv(VITRINE_PROGRAM, const_cast<char* const*>(words.data()));
        ::_exit(127);
    }
    ::close(out[1]);
    const render::Descriptor read(out[0]);
    std::string said;
    while (said.find('\n') == std::string::npos) {
        waitFor(read.get(), POLLIN);
        std::array<char, 256> piece{};
        const ssize_t count = ::read(read.get(), piece.data(), piece.size());
        if (count <= 0) throw std::runtime_error("the server ended: " + log());
        said.append(piece.data(), static_cast<std::size_t>(count));
    }
    EXPECT_EQ(said, "vitrine: serving at " + socket_ + "\n");
}

ServedProgram::~ServedProgram()
{
    if (child_ > 0) end(SIGKILL);
}

int ServedProgram::end(int signal)
{
    int status = 0;
    ::kill(child_, signal);
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool ServedProgram::alive() const
{
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

RpcClient::RpcClient(const std::string& socket) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, socket.data(), std::min(socket.size(), sizeof address.sun_path - 1));
    if (::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        throw std::runtime_error("connect: " + std::string(std::strerror(errno)));
}

bool RpcClient::send(std::string_view bytes)
{
    while (!bytes.empty()) {
        const std::size_t count = sendSome(bytes);
        bytes.remove_prefix(count);
        if (count > 0) continue;
        if (errno != EAGAIN) return false;
        waitFor(socket_.get(), POLLOUT);
    }
    return true;
}

std::size_t RpcClient::sendSome(std::string_view bytes)
{
    const ssize_t count = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    return count < 0 ? 0 : static_cast<std::size_t>(count);
}

void RpcClient::endInput()
{
    ::shutdown(socket_.get(), SHUT_WR);
}

std::optional<std::string> RpcClient::readLine()
{
    for (std::size_t end = input_.find('\n');; end = input_.find('\n')) {
        if (end != std::string::npos) {
            std::string line = input_.substr(0, end);
            input_.erase(0, end + 1);
            return line;
        }
        waitFor(socket_.get(), POLLIN);
        std::vector<char> piece(1U << 16U);
        const ssize_t count = ::recv(socket_.get(), piece.data(), piece.size(), 0);
        if (count <= 0) return std::nullopt;
        input_.append(piece.data(), static_cast<std::size_t>(count));
    }
}

render::Json RpcClient::read()
{
    const std::optional<std::string> line = readLine();
    if (!line) throw std::runtime_error("the server closed the connection");
    render::Json json = render::parseJson(*line, "answer").root();
    EXPECT_EQ(json.value("jsonrpc", ""), "2.0") << *line;
    return json;
}

render::Json RpcClient::ask(const std::string& line)
{
    send(line + '\n');
    while (true) {
        render::Json json = read();
        if (!json.contains("method")) return json;
        events.push_back(std::move(json));
    }
}

render::Json RpcClient::call(const std::string& method, const render::Json& params)
{
    const int id = ++lastId_;
    std::string line = requestLine(id, method, params);
    line.pop_back();
    render::Json answer = ask(line);
    EXPECT_EQ(answer["id"], id) << answer.dump();
    return answer;
}

render::Json RpcClient::result(const std::string& method, const render::Json& params)
{
    const render::Json answer = call(method, params);
    if (!answer.contains("result")) throw std::runtime_error(answer.dump());
    return answer["result"];
}

std::string requestLine(const render::Json& id, const std::string& method, const render::Json& params)
{
    return render::Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump() + '\n';
}

}  // namespace vitrine::test
