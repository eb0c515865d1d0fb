#pragma once

#include "exhibits/framework/chart.h"
#include "exhibits/noise/noise_table.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace vitrine {

/// Noise at a point, in cells.
using NoiseSample = std::function<double(const glm::dvec3&)>;

/// How often each value occurs, as a density over [-1, 1].
[[nodiscard]] ChartCurve noiseHistogram(const std::string& name, const NoiseSample&);

/// Share of the variance over frequency, in waves per cell, from 1/16 to 4: along lines in many directions, by a
/// Fourier transform under Hann's window.
[[nodiscard]] ChartCurve noiseSpectrum(const std::string& name, const NoiseSample&);

/// Mean square change over a quarter of a cell in the plane y = const, by direction from 0 to 180 degrees, over its
/// mean: 1 everywhere where no direction is preferred.
[[nodiscard]] ChartCurve noiseIsotropy(const std::string& name, const NoiseSample&);

/// The three of what is on show, beside those of the value noise that the source has in its place.
[[nodiscard]] std::vector<Chart> noiseCharts(const NoiseTable&, const ParameterValues&);

}  // namespace vitrine
