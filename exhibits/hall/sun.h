#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/hall/sky_tint.h"

#include <glm/glm.hpp>

namespace vitrine::hall {

/// The sun over the museum, set by hand or by the hour.
struct Sun {
    double elevation = 0;    ///< Radians above the horizon; negative at night.
    double azimuth = 0;      ///< Radians, seen through the window; negative is to the left.
    double strength = 0;     ///< Irradiance on a plane that faces the sun, in the hall's units.
    double temperature = 0;  ///< Color temperature, kelvin.

    [[nodiscard]] glm::dvec3 towards() const;     ///< Returns a unit vector, world space.
    [[nodiscard]] glm::dvec3 irradiance() const;  ///< Returns irradiance on a plane facing the sun, linear Rec. 709.
};

[[nodiscard]] Sun sunOf(const HallTable&, const ParameterValues&);

/// Radiance of the moonlit sky at night relative to that at the initial sun, brighter than in reality, as eyes adapted
/// to the dark see it.
inline constexpr glm::dvec3 moonlitSky{0.011, 0.015, 0.024};

/// Returns the clear sky for a sun set by the hour, `sunElevation` radians above the horizon. At night it is the sky in
/// moonlight.
[[nodiscard]] SkyTint skyByHour(double sunElevation);
/// Returns the sky under that sun. It integrates scattering anew, so call it once per frame.
[[nodiscard]] SkyTint skyOf(const HallTable&, const ParameterValues&, const Sun&);

/// Returns the sun at an hour of an equinox at 48° north, for a window that faces west-southwest. The hour is solar
/// time, 0 to 24; any finite value wraps.
///
/// Its strength is 0.7 to the power of (air mass to the power of 0.678): Meinel and Meinel 1976, "Applied Solar
/// Energy". The air mass is that of Kasten and Young 1989, "Revised optical air mass tables and approximation formula".
/// Its color temperature falls from 5,700 K at the zenith to 2,000 K at the horizon.
[[nodiscard]] Sun sunAtHour(double hour);

}  // namespace vitrine::hall
