#pragma once

#include "exhibits/printing/print_layout.h"

#include <cstdint>
#include <vector>

namespace vitrine::lenticular {

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

}  // namespace vitrine::lenticular
