#pragma once

#include "render/image/image.h"

namespace vitrine::render {

/// Pixels per degree of the usual desk: 0.7 m from a monitor 0.7 m wide with 3840 pixels.
inline constexpr double flipPixelsPerDegree = 67;

/// The difference that an observer sees when he flips between two pictures, per pixel from 0 to 1: LDR-FLIP
/// (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for
/// Alternating Images"). The colors of both are clamped to [0, 1]; alpha is composed onto black. Pixels outside
/// the picture repeat its edge.
///
/// Departures from the paper: it is computed in 64-bit floats, and every filter is applied as a sum of separable
/// ones, which its Gaussians are. `pixelsPerDegree` is positive.
[[nodiscard]] Image flipMap(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

/// Mean of the map.
[[nodiscard]] double flip(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

}  // namespace vitrine::render
