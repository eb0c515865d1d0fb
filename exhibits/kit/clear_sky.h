#pragma once

#include <glm/glm.hpp>

#include <memory>

namespace vitrine {

namespace clear_sky {
struct LitAir;
}

/// The clear sky over sea level, seen from the ground, in linear Rec. 709 and not negative. Sunlight has irradiance 1
/// above the air.
///
/// Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique": single scattering along the
/// ray, and multiple scattering as if it were isotropic.
class ClearSky {
public:
    /// `sunElevation` is in radians above the horizon, negative at night. `haze` is a multiple of the haze of clear
    /// air, which is 1; it is clamped to [0, 1000]. A new haze takes some milliseconds.
    explicit ClearSky(double sunElevation, double haze = 1);

    /// Returns the radiance from a direction: radians above the horizon, and radians of azimuth away from the sun.
    [[nodiscard]] glm::dvec3 radiance(double elevation, double fromSun) const;
    /// Returns the irradiance of the sun on a plane that faces it, at a height in kilometers; 0 once it has set.
    [[nodiscard]] glm::dvec3 sunlight(double height = 0.2) const;

private:
    std::shared_ptr<const clear_sky::LitAir> air_;
    double sunElevation_;
};

/// Returns the radiance of ClearSky in clear air.
[[nodiscard]] glm::dvec3 clearSkyRadiance(double sunElevation, double elevation, double fromSun);

}  // namespace vitrine
