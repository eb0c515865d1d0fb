#pragma once

#include <array>
#include <cstddef>

namespace vitrine::ui {

/// Resolution of pictures while something moves. It drops when frames are slow, and rises again when they are fast.
class AdaptiveScale {
public:
    /// Resolutions as parts of the viewport's, the full one first.
    static constexpr std::array<double, 5> scales{1, 0.75, 0.5, 0.35, 0.25};
    /// Target of seconds per frame: about 18 frames a second.
    static constexpr double targetTime = 0.055;

    /// Sets the lowest resolution, as a part of the full one; a higher one may be slower.
    void setLeast(double scale);
    [[nodiscard]] double scale() const { return scales[level_]; }
    [[nodiscard]] bool isReduced() const { return level_ > 0; }
    /// Takes note of a frame at this resolution, which took this many seconds of wall-clock time.
    void drawn(double scale, double seconds);

private:
    [[nodiscard]] bool canBeCoarser() const;

    double least_ = 0;
    std::size_t level_ = 0;  // Index into `scales`.
    int fastFrames_ = 0;     // Number of frames in a row that were fast enough for a finer level.
};

}  // namespace vitrine::ui
