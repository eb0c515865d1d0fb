#pragma once

#include "render/files/descriptor.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

namespace vitrine::app {

/// Received line.
struct ReceivedLine {
    enum class Kind { whole, tooLong, unfinished };
    Kind kind = Kind::whole;
    std::string text;  ///< Text without the line's end; empty if it was too long.
};

/// Connection to one client: lines over a nonblocking socket, and messages back. No function waits. Lines that are too
/// long are skipped. A client that does not read its answers is dropped, with the reason as the last line.
class Connection {
public:
    /// Largest size of a received line.
    static constexpr std::size_t mostLineBytes = 1U << 20U;
    /// Largest number of bytes sent and not yet read. Beyond it, nothing more is sent.
    static constexpr std::size_t mostUnread = 1U << 20U;

    explicit Connection(render::Descriptor socket) : socket_(std::move(socket)) {}

    [[nodiscard]] int descriptor() const { return socket_.get(); }

    /// Returns the next received line, if any; blank lines are skipped.
    [[nodiscard]] std::optional<ReceivedLine> takeLine();
    /// Reads available data, at most one block.
    void receive();
    /// The other end was closed. Data that it sent before can still be read.
    void hangUp();

    /// Sends a message, a line with its end and the bytes that belong to it, now or as soon as the client reads. If
    /// more than `mostUnread` bytes are unread, drops the connection instead.
    void send(std::string message);
    /// Sends waiting data, as much as the socket accepts.
    void flush();
    /// Drops the connection: `lastLine` replaces the waiting messages, except for one that was begun.
    void drop(std::string lastLine);

    [[nodiscard]] bool hungUp() const { return hungUp_; }
    /// Returns whether no more data will arrive.
    [[nodiscard]] bool inputEnded() const { return inputEnded_; }
    [[nodiscard]] bool hasUnsent() const { return !unsent_.empty(); }
    /// Returns whether the client reads its answers, so that it may send more requests.
    [[nodiscard]] bool keepsUp() const { return unsentBytes_ <= mostUnread; }
    [[nodiscard]] bool dropped() const { return droppedAt_.has_value(); }
    /// Returns whether the connection was dropped, and its last line was sent or will never be.
    [[nodiscard]] bool over() const;

private:
    render::Descriptor socket_;
    std::string input_;
    std::size_t taken_ = 0;     ///< Number of bytes of `input_` that were taken.
    std::size_t searched_ = 0;  ///< Position in `input_` before which no line ends.
    bool leavingOut_ = false;   ///< Skipping the rest of a line that is too long.
    bool inputEnded_ = false, hungUp_ = false;
    std::deque<std::string> unsent_;  ///< Messages.
    std::size_t sent_ = 0;            ///< Number of bytes of the first message that were sent.
    std::size_t unsentBytes_ = 0;     ///< Number of bytes of all messages that were not sent.
    std::optional<std::chrono::steady_clock::time_point> droppedAt_;
};

}  // namespace vitrine::app
