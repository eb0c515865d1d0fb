#pragma once

#include <glm/vec2.hpp>

#include <limits>
#include <optional>

namespace vitrine::render::gl {

/// Divides passes that may take any time into bands of rows, and says when their time in a frame is over.
class UnboundedTime {
public:
    /// `software`: a processor draws. Its bands are small, because nothing else bounds their time; a graphics card is
    /// reset by its driver when a draw takes some seconds.
    explicit UnboundedTime(bool software) : software_(software) {}

    /// Sets the limit of a frame, in seconds.
    void setLimit(double seconds) { limit_ = seconds; }
    [[nodiscard]] bool isLimited() const { return limit_ < std::numeric_limits<double>::infinity(); }
    void beginFrame();

    /// Returns the next band of a pass with `size` pixels: its first row, and that behind its last one. Nothing is
    /// returned if the whole height was returned before, or the time is over. The band before must have been drawn
    /// completely (glFinish).
    [[nodiscard]] std::optional<glm::ivec2> nextBand(glm::ivec2 size);
    /// Returns whether the time of this frame was over before all bands were drawn.
    [[nodiscard]] bool isOver() const { return isOver_; }

private:
    bool software_;
    double limit_ = std::numeric_limits<double>::infinity();
    double used_ = 0;   ///< Seconds of this frame.
    double begun_ = 0;  ///< Start of `band_`, by the wall clock.
    std::optional<glm::ivec2> band_;
    bool isOver_ = false;
};

}  // namespace vitrine::render::gl
