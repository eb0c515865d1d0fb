#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace vitrine::noise {

/// One wave of a sea on deep water.
struct SeaWave {
    glm::dvec2 vector{0};  ///< Direction of travel in the plane, radians per meter.
    double amplitude = 0;  ///< Meters.
    double frequency = 0;  ///< Radians per second: the square root of g times the length of the vector.
    double phase = 0;      ///< At time 0, radians.
};

/// Returns waves, the longest first, always the same for the same arguments. `count` of them approximate the spectrum
/// of a fully developed sea (Pierson and Moskowitz 1964, "A proposed spectral form for fully developed wind seas").
/// They range from almost twice the length of the peak to ripples of 25 cm.
///
/// `windSpeed` is in meters per second, above 0. `windDirection` is where the wind blows to, in radians: 0 along -y,
/// positive towards +x. Directions are spread around it, those of short waves more.
[[nodiscard]] std::vector<SeaWave> seaWaves(double windSpeed, double windDirection, int count, std::uint32_t seed);

/// Returns the mean square slope of all waves down to the finest, for this wind speed: Cox and Munk 1954, "Measurement
/// of the Roughness of the Sea Surface from Photographs of the Sun's Glitter".
[[nodiscard]] double seaSlopes(double windSpeed);

}  // namespace vitrine::noise
