#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace vitrine {

/// One of the waves that the lake is summed of.
struct LakeWave {
    glm::dvec2 vector{0};  ///< In the plane (x, z), radians per meter.
    double amplitude = 0;  ///< Meters.
    double frequency = 0;  ///< Radians per second: the phase grows by it, so the wave runs against its vector.
    double phase = 0;      ///< At time 0, radians.
};

/// The five of the source: 11.2 to 2.9 m long, 9 to 1.2 cm high, together 20.75 cm at most, all of one frequency, 2.5
/// radians a second; with `dispersion`, each as gravity makes it on deep water, the root of g k.
[[nodiscard]] std::vector<LakeWave> sourceWaves(bool dispersion);

/// The wave that the source's lanterns ride, which is none of these: 15.7 m long, 15 cm high, 0.2 s late.
[[nodiscard]] LakeWave sourceRideWave();

/// Small waves of a wind, `count` of them in even ratios from 2.2 m to 10 cm, each with the same share of the mean
/// square slope `slope`^2 (both axes together), around `windDirection` (radians from -z towards +x).
[[nodiscard]] std::vector<LakeWave> windRipples(double slope, double windDirection, int count, std::uint32_t seed);

/// By how much less a disk of this radius follows a wave of `k` radians per meter: mean height over it, and slope of
/// the plane that is nearest to the wave over it. 1 for a small disk; in closed form, 2 J1(x)/x and 8 J2(x)/x^2, x = k
/// radius.
struct RideShare {
    double height = 1, slope = 1;
};
[[nodiscard]] RideShare rideShare(double k, double radius);

}  // namespace vitrine
