#pragma once

#include <glm/glm.hpp>

namespace vitrine::hall {

/// Color of a clear sky relative to the one for which the hall's colors of sun and sky were chosen.
struct SkyTint {
    glm::dvec3 zenith{1};   ///< Factor of the zenith's radiance.
    glm::dvec3 horizon{1};  ///< Factor of the horizon's radiance, away from the sun.
    glm::dvec3 sunward{0};  ///< Radiance of the horizon below the sun in addition to that away from it, divided by the
                            ///< latter's luminance at `referenceSunElevation`.
};

/// Returns the tint for a sun `sunElevation` radians above the horizon. The factors are 1 at `referenceSunElevation`.
[[nodiscard]] SkyTint skyTint(double sunElevation);

/// Elevation of the sun at the hall's initial parameters, radians.
inline constexpr double referenceSunElevation = 0.3316;

}  // namespace vitrine::hall
