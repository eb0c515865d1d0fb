#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/hall/clear_sky.h"
#include "exhibits/hall/hall_table.h"

#include <glm/glm.hpp>

namespace vitrine {

/// The sun over the museum, as set by hand or by the hour.
struct Sun {
    double elevation = 0;    ///< Above the horizon, radians; negative at night.
    double azimuth = 0;      ///< Seen through the window; negative is to the left. Radians.
    double strength = 0;     ///< Irradiance on a plane that faces it, in the hall's units.
    double temperature = 0;  ///< Of its color, kelvin.

    [[nodiscard]] glm::dvec3 towards() const;     ///< Unit length, world space.
    [[nodiscard]] glm::dvec3 irradiance() const;  ///< On a plane that faces it, linear Rec. 709.
};

[[nodiscard]] Sun sunOf(const HallTable&, const ParameterValues&);

/// The clear sky under a sun that stands so high, radians, where it goes by the hour: by night, what a moon leaves of
/// it.
[[nodiscard]] SkyTint skyByHour(double sunElevation);
/// The sky under that sun; its scattered light is summed up anew, which is for once a frame.
[[nodiscard]] SkyTint skyOf(const HallTable&, const ParameterValues&, const Sun&);

/// The sun at an hour of the day (solar time, 0 to 24, any finite value wraps) of an equinox at 48° north, for a
/// window that faces west-southwest. Its light by air mass: Kasten and Young 1989, "Revised optical air mass tables
/// and approximation formula", and Meinel and Meinel 1976, "Applied Solar Energy" (0.7 to the power of the air mass
/// to the power of 0.678); its color falls from 5,700 K in the height to 2,000 K at the horizon.
[[nodiscard]] Sun sunAtHour(double hour);

}  // namespace vitrine
