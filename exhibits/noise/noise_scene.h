#pragma once

#include "exhibits/kit/portal.h"
#include "exhibits/kit/sky_view.h"
#include "exhibits/noise/noise_table.h"
#include "render/glsl/std140.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace vitrine::noise {

#include "shaders/noise/noise_block.glsl"

/// Returns the position of the shown work behind the frame.
[[nodiscard]] Portal noisePortal(const NoiseTable&, const ParameterValues&);

/// Returns the seconds for which the work has run at `time` of the exhibit's clock.
[[nodiscard]] double noiseTime(const NoiseTable&, const ParameterValues&, double time);

/// Returns the work after `seconds`. Everything that moves is wrapped within its own period here, at float64. `sample`
/// is the number of the supersample.
[[nodiscard]] NoiseBlock noiseBlock(const NoiseTable&, const ParameterValues&, double seconds,
                                    const glm::dvec3& towardsSun, int sample);

/// Returns GLSL statements that move the block on by TIME seconds, and compute what follows from parameters that the
/// shader reads. They use only members that the shader of the shown work reads.
[[nodiscard]] std::string noiseMotionGlsl(const NoiseTable&, const ParameterValues&);

/// Light in the work's world, by day or by night. The sun has irradiance 1 above the air.
struct NoiseLight {
    glm::dvec3 towards{0, 1, 0};  ///< Direction of the sun or the moon, unit.
    double sunElevation = 0;      ///< Radians above the horizon.
    glm::dvec3 moon{0};           ///< Irradiance of the moon.
};

/// Returns the light at the elevation of the hall's sun, in radians. A sun of the work's own sinks with it while it
/// sets, and gives its place to a moon.
[[nodiscard]] NoiseLight noiseLight(const NoiseTable&, const ParameterValues&, double hallSunElevation);

/// Returns the clear sky of the works under a light.
[[nodiscard]] std::shared_ptr<const SkyView> noiseSky(const NoiseTable&, const ParameterValues&, const NoiseLight&);
/// Sets the light of the block. It is exposed as a photographer would: longer at a low sun, so that dusk is darker than
/// day, but not black. `brightness`: a factor.
void lightBy(const SkyView&, const NoiseLight&, double brightness, NoiseBlock&);

}  // namespace vitrine::noise
