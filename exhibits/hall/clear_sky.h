#pragma once

#include <glm/glm.hpp>

namespace vitrine {

/// Radiance that the clear air over sea level sends to an eye on the ground, in linear Rec. 709, for sunlight of
/// irradiance 1 above the air; not negative. `sunElevation` in radians above the horizon, negative at night;
/// `elevation` and `fromSun` are of the direction that is looked in: radians above the horizon, and of azimuth away
/// from the sun. Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique": light
/// scattered once along the ray, and what is scattered more often as if it came from everywhere alike.
[[nodiscard]] glm::dvec3 clearSkyRadiance(double sunElevation, double elevation, double fromSun);

/// What a clear sky looks like against the one under which the hall's own colors of sun and sky were chosen.
struct SkyTint {
    glm::dvec3 zenith{1};   ///< Factor of the zenith's radiance.
    glm::dvec3 horizon{1};  ///< Factor of the horizon's, away from the sun.
    glm::dvec3 sunward{0};  ///< What the horizon below the sun has more than away from it, in units of the latter then.
};

/// Of a sun that high, radians; the factors are 1 at `referenceSunElevation`.
[[nodiscard]] SkyTint skyTint(double sunElevation);

/// Of the sun at the hall's initial angles, radians.
inline constexpr double referenceSunElevation = 0.3316;

}  // namespace vitrine
