#include "app/serve/connection.h"

#include "app/serve/json_rpc.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>

namespace vitrine::app {
namespace {

/// Time for a dropped client to read its last line.
constexpr std::chrono::seconds lastLineWaits{2};
constexpr const char* unreadReason = "More than 1 MiB of answers and events were not read: the connection ends here.";

}  // namespace

std::optional<ReceivedLine> Connection::takeLine()
{
    while (true) {
        const std::size_t end = input_.find('\n', searched_);
        if (end == std::string::npos) break;
        std::string line = input_.substr(taken_, end - taken_);
        taken_ = searched_ = end + 1;
        if (leavingOut_ || line.size() > mostLineBytes) {
            const bool answered = leavingOut_;
            leavingOut_ = false;
            if (!answered) return ReceivedLine{ReceivedLine::Kind::tooLong, {}};
            continue;
        }
        if (line.find_first_not_of(" \t\r") != std::string::npos)
            return ReceivedLine{ReceivedLine::Kind::whole, std::move(line)};
    }
    searched_ = input_.size();
    const std::size_t begun = input_.size() - taken_;
    if (leavingOut_ || begun > mostLineBytes || (inputEnded_ && begun > 0)) {
        input_.clear();
        taken_ = searched_ = 0;
        const bool tooLong = begun > mostLineBytes && !leavingOut_;
        const bool unfinished = inputEnded_ && !tooLong && !leavingOut_;
        leavingOut_ = leavingOut_ || tooLong;
        if (tooLong) return ReceivedLine{ReceivedLine::Kind::tooLong, {}};
        if (unfinished) return ReceivedLine{ReceivedLine::Kind::unfinished, {}};
    }
    return std::nullopt;
}

void Connection::receive()
{
    if (inputEnded_) return;
    input_.erase(0, taken_);
    searched_ -= taken_;
    taken_ = 0;
    std::array<char, 1U << 16U> piece;
    const ssize_t count = ::recv(socket_.get(), piece.data(), piece.size(), 0);
    if (count > 0) {
        if (!dropped()) input_.append(piece.data(), static_cast<std::size_t>(count));
    } else if (count == 0) {
        inputEnded_ = true;
    } else if (errno != EAGAIN && errno != EINTR) {
        inputEnded_ = true;
        hangUp();
    }
}

void Connection::hangUp()
{
    hungUp_ = true;
    unsent_.clear();
    sent_ = unsentBytes_ = 0;
}

void Connection::send(std::string message)
{
    if (hungUp_ || dropped()) return;
    flush();
    if (!keepsUp()) {
        drop(errorLine(nullptr, RpcCode::dropped, unreadReason));
        return;
    }
    unsentBytes_ += message.size();
    unsent_.push_back(std::move(message));
    flush();
}

void Connection::flush()
{
    while (hasUnsent()) {
        const std::string& message = unsent_.front();
        const ssize_t count = ::send(socket_.get(), message.data() + sent_, message.size() - sent_, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno == EAGAIN) return;
        if (count < 0) {
            hangUp();
            return;
        }
        sent_ += static_cast<std::size_t>(count);
        unsentBytes_ -= static_cast<std::size_t>(count);
        if (sent_ < message.size()) continue;
        unsent_.pop_front();
        sent_ = 0;
    }
}

void Connection::drop(std::string lastLine)
{
    if (dropped()) return;
    // A message that was begun is finished first, so that the last line stands by itself.
    unsent_.resize(sent_ > 0 ? 1 : 0);
    unsentBytes_ = (sent_ > 0 ? unsent_.front().size() - sent_ : 0) + lastLine.size();
    unsent_.push_back(std::move(lastLine));
    input_.clear();
    taken_ = searched_ = 0;
    droppedAt_ = std::chrono::steady_clock::now();
    flush();
}

bool Connection::over() const
{
    return dropped() && (hungUp_ || !hasUnsent() || std::chrono::steady_clock::now() - *droppedAt_ > lastLineWaits);
}

}  // namespace vitrine::app
