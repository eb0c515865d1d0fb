#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::lenticular {

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
        taps.weights.push_back(static_cast<float>((std::min<double>(to, i + 1) - std::max<double>(from, i)) / (to - from)));
    }
}

}  // namespace vitrine::lenticular
