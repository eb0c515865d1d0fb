#pragma once

#include "exhibits/printing/print_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// A part of what a printed pixel shows: one view under one lens.
struct Tap {
    std::int64_t lens = 0;
    int view = 0;
    double weight = 0;
};

/// The share of a pixel that lies before `t`, both measured across the lens from the pixel's center. `a` and
/// `b` are the widths of the pixel's two sides as seen across the lens: their boxes, one folded with the
/// other, make a trapezoid, and a box when one of them is 0.
[[nodiscard]] double shareBefore(double t, double a, double b);

/// What the pixel whose center is (x, y), in pixels from the raster's top left corner, shows. The weights sum
/// to 1. `taps` is cleared first; it is kept by the caller so that a row needs no allocation.
void tapsAt(const PrintLayout&, double x, double y, std::vector<Tap>& taps);

/// Which samples of a line make up a stretch of it.
struct BoxTaps {
    int first = 0;
    std::vector<float> weights{};  ///< Sum to 1.
};

/// The mean over [center - width/2, center + width/2] of a line of `count` samples, sample i covering
/// [i, i+1]; interpolated at the center when the stretch is shorter than a sample. Beyond its ends the line
/// goes on with its last sample.
inline void boxTaps(double center, double width, int count, BoxTaps& taps)
{
    taps.weights.clear();
    if (width <= 1) {
        const double at = std::clamp(center - 0.5, 0.0, static_cast<double>(count - 1));
        taps.first = std::min(static_cast<int>(at), std::max(count - 2, 0));
        const double part = at - taps.first;
        taps.weights.push_back(static_cast<float>(1 - part));
        if (count > 1) taps.weights.push_back(static_cast<float>(part));
        return;
    }
    const double end = count;
    const double from = std::clamp(center - width / 2, 0.0, end);
    const double to = std::clamp(center + width / 2, 0.0, end);
    if (!(to - from > 1e-9)) {  // Beyond the line.
        taps.first = center < end / 2 ? 0 : count - 1;
        taps.weights.push_back(1);
        return;
    }
    taps.first = std::min(static_cast<int>(from), count - 1);
    for (int i = taps.first; i < to && i < count; ++i) {
        taps.weights.push_back(
            static_cast<float>((std::min<double>(to, i + 1) - std::max<double>(from, i)) / (to - from)));
    }
}

}  // namespace vitrine::printing
