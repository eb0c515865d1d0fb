#pragma once

#include "render/measure/flip.h"

#include <vector>

namespace vitrine::render {

/// Returns the exposures, in stops, at which HDR-FLIP looks at pictures with this reference, in rising order: at the
/// first one the brightest pixel of the reference is shown at 0.85 of white, at the last one its median luminance.
/// There are at least two, and as many as stops between the two.
[[nodiscard]] std::vector<double> hdrFlipExposures(const Image& reference);

/// Returns the color of a display for linear light at an exposure of 0 stops: the curve of Narkowicz 2016, "ACES Filmic
/// Tone Mapping Curve", without its pre-exposure, clamped to [0, 1]. HDR-FLIP applies it to each component.
[[nodiscard]] double hdrFlipToneCurve(double light);

/// Returns the perceived difference per pixel, 0 to 1, of two pictures with a high dynamic range: HDR-FLIP (Andersson,
/// Nilsson, Shirley, Akenine-Möller 2021, "Visualizing Errors in Rendered High Dynamic Range Images"). It is the
/// largest of the LDR-FLIP errors at all exposures. Alpha is composited over black; negative light and NaN count as 0,
/// infinite light as 65504.
[[nodiscard]] Image hdrFlipMap(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

/// Returns the mean of the map.
[[nodiscard]] double hdrFlip(const Image& reference, const Image& test, double pixelsPerDegree = flipPixelsPerDegree);

}  // namespace vitrine::render
