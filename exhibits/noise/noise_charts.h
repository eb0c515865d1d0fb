#pragma once

#include "exhibits/framework/scene/chart.h"
#include "exhibits/noise/noise_table.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace vitrine::noise {

/// Noise at a point; coordinates are in cells.
using NoiseSample = std::function<double(const glm::dvec3&)>;

/// Returns the distribution of the values, as a density over [-1, 1].
[[nodiscard]] ChartCurve noiseHistogram(const std::string& name, const NoiseSample&);

/// Returns the share of the variance over frequency, from 1/16 to 4 waves per cell. The noise is sampled along lines in
/// many directions and Fourier transformed with a Hann window.
[[nodiscard]] ChartCurve noiseSpectrum(const std::string& name, const NoiseSample&);

/// Returns the mean square change over a quarter of a cell in the plane y = const, relative to its mean, by direction
/// from 0 to 180 degrees. It is 1 everywhere if no direction is preferred.
[[nodiscard]] ChartCurve noiseIsotropy(const std::string& name, const NoiseSample&);

/// Returns these three charts for the work that is shown, with the value noise that the reference uses for comparison.
[[nodiscard]] std::vector<Chart> noiseCharts(const NoiseTable&, const ParameterValues&);

}  // namespace vitrine::noise
