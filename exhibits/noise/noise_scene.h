#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/noise/noise_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

namespace vitrine {

#include "shaders/noise/noise_block.glsl"

/// Where the work on show lies behind the frame.
[[nodiscard]] Portal noisePortal(const NoiseTable&, const ParameterValues&);

/// Seconds that the work has run at `time` of the exhibit's clock.
[[nodiscard]] double noiseTime(const NoiseTable&, const ParameterValues&, double time);

/// The work at that moment. All that moves is wrapped here, at float64, within its own period. `sample` is the number
/// of the supersample.
[[nodiscard]] NoiseBlock noiseBlock(const NoiseTable&, const ParameterValues&, double seconds,
                                    const glm::dvec3& towardsSun, int sample);

}  // namespace vitrine
