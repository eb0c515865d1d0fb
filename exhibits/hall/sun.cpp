#include "exhibits/hall/sun.h"

#include "exhibits/framework/scene/scene_lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::hall {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double latitude = 48 * degree;
/// Azimuth from south, westwards: the sun is at the hall's initial angles a little after four o'clock.
constexpr double windowAzimuth = 70.6 * degree;
/// Strength above the air that makes the light at four o'clock as strong as the hall's initial sun.
constexpr double strengthAboveAir = 7.5;

}  // namespace

glm::dvec3 Sun::towards() const
{
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
}

Sun sunAtHour(double hour)
{
    const double turn = ((std::isfinite(hour) ? std::fmod(hour, 24.0) : 12.0) - 12) * 15 * degree;
    Sun sun;
    // On an equinox the sun moves along the celestial equator.
    sun.elevation = std::asin(std::clamp(std::cos(latitude) * std::cos(turn), -1.0, 1.0));
    const double fromSouth = std::atan2(std::sin(turn), std::cos(turn) * std::sin(latitude));
    sun.azimuth = std::remainder(fromSouth - windowAzimuth, 2 * std::numbers::pi);
    const double high = std::max(sun.elevation / degree, 0.0);
    const double airMass = 1 / (std::sin(high * degree) + 0.50572 * std::pow(high + 6.07995, -1.6364));
    // The disk sets over one degree of elevation.
    const double risen = std::clamp(sun.elevation / degree + 0.5, 0.0, 1.0);
    sun.strength = strengthAboveAir * std::pow(0.7, std::pow(airMass, 0.678)) * risen;
    sun.temperature = 2000 + 3700 * (1 - std::exp(-high / 15));
    return sun;
}

glm::dvec3 Sun::irradiance() const
{
    return blackBodyColor(temperature) * strength;
}

SkyTint skyByHour(double sunElevation)
{
    SkyTint sky = skyTint(sunElevation);
    sky.zenith += moonlitSky;
    sky.horizon += moonlitSky;
    return sky;
}

SkyTint skyOf(const HallTable& table, const ParameterValues& values, const Sun& sun)
{
    if (values[table.sunBy] == SunBy::hour) return skyByHour(sun.elevation);
    // Colors and strengths are set by hand here. The glow depends on the elevation of the sun alone.
    return {.sunward = skyTint(sun.elevation).sunward};
}

Sun sunOf(const HallTable& table, const ParameterValues& values)
{
    if (values[table.sunBy] == SunBy::hour) {
        Sun sun = sunAtHour(values[table.timeOfDay]);
        sun.strength *= values[table.sunStrength] / std::get<double>(table.rows()[table.sunStrength.row].initial);
        return sun;
    }
    return {values[table.sunElevation], values[table.sunAzimuth], values[table.sunStrength],
            values[table.sunTemperature]};
}

}  // namespace vitrine::hall
