#pragma once

#include "render/files/descriptor.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace vitrine::app {

/// What came as one line.
struct ReceivedLine {
    enum class Kind { whole, tooLong, unfinished };
    Kind kind = Kind::whole;
    std::string text;  ///< Without its end; empty where it was too long.
};

/// Lines to and from one client, over a nonblocking socket; nothing here waits. Lines that are too long are left out,
/// those behind them are read. Who does not read what he is sent is dropped, with the reason as the last line.
class Connection {
public:
    /// Of a line that comes.
    static constexpr std::size_t mostLineBytes = 1U << 20U;
    /// Of what was sent and not read: more than that, and nothing further may be sent.
    static constexpr std::size_t mostUnread = 1U << 20U;

    explicit Connection(render::Descriptor socket) : socket_(std::move(socket)) {}

    [[nodiscard]] int descriptor() const { return socket_.get(); }

    /// The next line that came, blank ones left out.
    [[nodiscard]] std::optional<ReceivedLine> takeLine();
    /// Reads what has come, at most a piece of it.
    void receive();
    /// The other end was closed: what it sent before can still be read.
    void hangUp();

    /// Sends a line, which ends with a newline: at once, or when the other end takes it. The first beyond `mostUnread`
    /// drops the connection instead.
    void send(std::string line);
    /// Sends what waits, as far as the other end takes it.
    void flush();
    /// Ends the connection: `lastLine` takes the place of what waits.
    void drop(std::string lastLine);

    [[nodiscard]] bool hungUp() const { return hungUp_; }
    /// Nothing further will come.
    [[nodiscard]] bool inputEnded() const { return inputEnded_; }
    [[nodiscard]] bool hasUnsent() const { return sent_ < unsent_.size(); }
    /// Whether the other end reads, so that it may ask for more.
    [[nodiscard]] bool keepsUp() const { return unsent_.size() - sent_ <= mostUnread; }
    [[nodiscard]] bool dropped() const { return droppedAt_.has_value(); }
    /// It was dropped, and its last line was sent or will not be.
    [[nodiscard]] bool over() const;

private:
    render::Descriptor socket_;
    std::string input_;
    std::size_t taken_ = 0;     ///< Of `input_`.
    std::size_t searched_ = 0;  ///< Of `input_`: no line ends before that.
    bool leavingOut_ = false;   ///< Up to the end of a line that is too long.
    bool inputEnded_ = false, hungUp_ = false;
    std::string unsent_;
    std::size_t sent_ = 0;     ///< Of `unsent_`.
    bool withinLine_ = false;  ///< Of what was sent, the last line has not ended.
    std::optional<std::chrono::steady_clock::time_point> droppedAt_;
};

}  // namespace vitrine::app
