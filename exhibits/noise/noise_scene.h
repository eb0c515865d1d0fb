#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/noise/noise_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

namespace vitrine {

#include "shaders/noise/noise_block.glsl"

/// Returns the position of the shown work behind the frame.
[[nodiscard]] Portal noisePortal(const NoiseTable&, const ParameterValues&);

/// Returns the seconds for which the work has run at `time` of the exhibit's clock.
[[nodiscard]] double noiseTime(const NoiseTable&, const ParameterValues&, double time);

/// Returns the work after `seconds`. Everything that moves is wrapped within its own period here, at float64. `sample`
/// is the number of the supersample.
[[nodiscard]] NoiseBlock noiseBlock(const NoiseTable&, const ParameterValues&, double seconds,
                                    const glm::dvec3& towardsSun, int sample);

}  // namespace vitrine
