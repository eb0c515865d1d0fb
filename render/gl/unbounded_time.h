#pragma once

#include "render/measure/clock.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace vitrine::render::gl {

/// Divides passes that may take any time into bands of rows, and says when their time in a frame is over.
///
/// Other programs do not count: on a software renderer, the time for which the threads of this process waited for a
/// processor is subtracted. Where that cannot be measured, a pass is drawn a second time before it is too slow.
class UnboundedTime {
public:
    struct Clocks {
        std::function<double()> wall = wallSeconds;
        std::function<ThreadTimes()> threads = threadTimes;
    };
    /// `software`: a processor draws. Its bands are small, because nothing else bounds their time; a graphics card is
    /// reset by its driver when a draw takes some seconds.
    explicit UnboundedTime(bool software) : UnboundedTime(software, Clocks()) {}
    UnboundedTime(bool software, Clocks clocks) : software_(software), clocks_(std::move(clocks)) {}

    /// Sets the limit of a frame, in seconds on an idle machine.
    void setLimit(double seconds) { limit_ = seconds; }
    [[nodiscard]] bool isLimited() const { return limit_ < std::numeric_limits<double>::infinity(); }
    void beginFrame();

    /// Returns the next band of a pass with `size` pixels: its first row, and that behind its last one. Nothing is
    /// returned if the whole height was returned before, or the time is over. The band before must have been drawn
    /// completely (glFinish).
    [[nodiscard]] std::optional<glm::ivec2> nextBand(glm::ivec2 size);
    /// Returns whether the time of this frame was over before all bands were drawn.
    [[nodiscard]] bool isOver() const { return isOver_; }
    /// Returns whether the passes with this value of Pass::unbounded, whose time was over in this frame, are too slow
    /// to be drawn again: at once where other programs did not count, else when it happens in two frames in a row.
    [[nodiscard]] bool isTooSlow(std::uint64_t passes);

private:
    bool software_;
    Clocks clocks_;
    double limit_ = std::numeric_limits<double>::infinity();
    double used_ = 0;           ///< Seconds of this frame.
    double begun_ = 0;          ///< Start of `band_`, by the wall clock.
    ThreadTimes begunThreads_;  ///< The same by the threads' clocks; empty where it is not measured.
    std::set<std::uint64_t> lateOnce_;
    std::optional<glm::ivec2> band_;
    bool isOver_ = false;
};

}  // namespace vitrine::render::gl
