#pragma once

#include "render/measure/flip.h"
#include "render/measure/metrics.h"

#include <optional>

namespace vitrine::render {

/// Returns the distance of two pictures of one size by any metric. Returns nothing if they lack the channels that it
/// compares ("normal.X" to "normal.Z" in both, "depth.Z" in both).
[[nodiscard]] std::optional<double> distance(Metric, const Image& reference, const Image& test,
                                             double pixelsPerDegree = flipPixelsPerDegree);

/// Returns the error of each pixel, one channel: FLIP for Metric::flip, degrees for normals, meters for depth, and
/// `differenceMap` for all others. A normal or depth that only one picture has gives infinity. Returns nothing as
/// `distance` does.
[[nodiscard]] std::optional<Image> errorMap(Metric, const Image& reference, const Image& test,
                                            double pixelsPerDegree = flipPixelsPerDegree);

/// Returns the value that a heat map of these errors shows white: 1 for FLIP, else the largest finite error (1 if there
/// is none).
[[nodiscard]] double fullScale(Metric, const Image& errors);

/// Returns whether `value` is worse than `limit`: above it, or below it for the signal-to-noise ratio.
[[nodiscard]] bool isBeyond(Metric, double value, double limit);

/// Returns the index of the channel of that name, or -1.
[[nodiscard]] int channelNamed(const Image&, std::string_view name);

}  // namespace vitrine::render
