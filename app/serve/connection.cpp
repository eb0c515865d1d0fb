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
    sent_ = 0;
}

void Connection::send(std::string line)
{
    if (hungUp_ || dropped()) return;
    flush();
    if (!keepsUp()) {
        drop(errorLine(nullptr, RpcCode::dropped, unreadReason));
        return;
    }
    unsent_.erase(0, sent_);
    sent_ = 0;
    if (unsent_.empty())
        unsent_ = std::move(line);
    else
        unsent_ += line;
    flush();
}

void Connection::flush()
{
    while (hasUnsent()) {
        const ssize_t count = ::send(socket_.get(), unsent_.data() + sent_, unsent_.size() - sent_, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno == EAGAIN) return;
        if (count < 0) {
            hangUp();
            return;
        }
        sent_ += static_cast<std::size_t>(count);
        withinLine_ = unsent_[sent_ - 1] != '\n';
    }
    unsent_.clear();
    unsent_.shrink_to_fit();
    sent_ = 0;
}

void Connection::drop(std::string lastLine)
{
    if (dropped()) return;
    // An unfinished line is finished first, so that the last line stands by itself.
    const std::size_t end = withinLine_ ? unsent_.find('\n', sent_) : std::string::npos;
    unsent_ = end == std::string::npos ? std::string() : unsent_.substr(sent_, end + 1 - sent_);
    sent_ = 0;
    unsent_ += lastLine;
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
