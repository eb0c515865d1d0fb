#pragma once

#include "render/measure/flip.h"
#include "render/measure/metrics.h"

#include <optional>

namespace vitrine::render {

/// Distance of two pictures of one size by any metric; nothing when they lack the channels that it compares
/// ("normal.X" to "normal.Z" in both, "depth.Z" in both).
[[nodiscard]] std::optional<double> distance(Metric, const Image& reference, const Image& test,
                                             double pixelsPerDegree = flipPixelsPerDegree);

/// Where they differ, one channel: by FLIP for Metric::flip, degrees for normals, meters for depth, and for all
/// others `differenceMap`. What only one of the pictures has is infinite. Nothing as `distance`.
[[nodiscard]] std::optional<Image> errorMap(Metric, const Image& reference, const Image& test,
                                            double pixelsPerDegree = flipPixelsPerDegree);

/// The value that a heat map of these errors shows white: 1 for FLIP, else the largest finite error (1 when
/// there is none).
[[nodiscard]] double fullScale(Metric, const Image& errors);

/// Whether `value` is worse than `limit`: above it, but below it for the signal to noise ratio.
[[nodiscard]] bool isBeyond(Metric, double value, double limit);

/// The channel of that name, or -1.
[[nodiscard]] int channelNamed(const Image&, std::string_view name);

}  // namespace vitrine::render
