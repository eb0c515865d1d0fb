#pragma once

#include "render/image/image.h"

namespace vitrine::render {

/// Pixels per degree at a usual desk: 0.7 m from a monitor 0.7 m wide with 3840 pixels.
inline constexpr double flipPixelsPerDegree = 67;

/// Returns the perceived difference per pixel, 0 to 1, when an observer flips between two pictures: LDR-FLIP
/// (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for
/// Alternating Images"). The colors of both are clamped to [0, 1]; alpha is composited over black. Pixels outside the
/// picture repeat its edge.
///
/// Departures from the paper: it is computed in 64-bit floats, and every filter is applied as a sum of separable
/// filters, which its Gaussians are. `pixelsPerDegree` must be positive.
[[nodiscard]] Image flipMap(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

/// Returns the mean of a map of errors, which has one channel; 0 if it is empty.
[[nodiscard]] double meanOfMap(const Image&);
/// Returns the mean of the map.
[[nodiscard]] double flip(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

}  // namespace vitrine::render
