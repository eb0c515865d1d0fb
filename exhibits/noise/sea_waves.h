#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace vitrine {

/// One of the waves that a sea is summed of, on deep water.
struct SeaWave {
    glm::dvec2 vector{0};  ///< Where it runs in the plane, radians per meter.
    double amplitude = 0;  ///< Meters.
    double frequency = 0;  ///< Radians per second: the root of g times the length of its vector.
    double phase = 0;      ///< At time 0, radians.
};

/// The longest first, and always the same for the same arguments; `count` of them take the place of the spectrum of a
/// sea that the wind has blown over for long (Pierson and Moskowitz 1964, "A proposed spectral form for fully developed
/// wind seas"), from twice the longest swell's peak to ripples of 25 cm. `windSpeed` in meters a second, above 0;
/// `windDirection` in radians, where the wind blows to: 0 along -y, positive towards +x. Directions spread around it,
/// those of short waves more.
[[nodiscard]] std::vector<SeaWave> seaWaves(double windSpeed, double windDirection, int count, std::uint32_t seed);

/// Mean square slope of all waves down to the finest, for wind of this speed: Cox and Munk 1954, "Measurement of the
/// Roughness of the Sea Surface from Photographs of the Sun's Glitter".
[[nodiscard]] double seaSlopes(double windSpeed);

}  // namespace vitrine
