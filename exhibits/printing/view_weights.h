#pragma once

#include "exhibits/printing/print_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// Part of a printed pixel: one view under one lens.
struct ViewWeight {
    std::int64_t lens = 0;
    int view = 0;
    double weight = 0;
};

/// Returns the share of a pixel before `t`, measured across the lens from the pixel's center. `a` and `b` are the
/// widths of the pixel's two sides as seen across the lens. Their boxes, convolved, make a trapezoid, or a box if one
/// of them is 0.
[[nodiscard]] double shareBefore(double t, double a, double b);

/// Computes what the pixel with center (x, y) shows, in pixels from the raster's top left corner. The weights sum to 1.
/// `taps` is cleared first; the caller keeps it, so a row needs no allocation.
void viewWeightsAt(const PrintLayout&, double x, double y, std::vector<ViewWeight>& taps);

/// Samples of a line that make up an interval of it.
struct BoxTaps {
    int first = 0;
    std::vector<float> weights{};  ///< Sum to 1.
};

/// Computes the mean over [center - width/2, center + width/2] of a line of `count` samples, sample i covering [i,
/// i+1]. It is interpolated at the center if the interval is shorter than a sample. Only the part of a longer interval
/// on the line counts; beyond the line it is the nearest sample.
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
    if (!(to - from > 1e-9)) {  // The interval is beyond the line.
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
