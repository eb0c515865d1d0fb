#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace vitrine::paper_lanterns {

/// One wave of the lake.
struct LakeWave {
    glm::dvec2 vector{0};  ///< In the plane (x, z), radians per meter.
    double amplitude = 0;  ///< Meters.
    double frequency = 0;  ///< Radians per second. The phase increases by it, so the wave travels against its vector.
    double phase = 0;      ///< At time 0, radians.
};

/// Returns the five waves of the reference: 11.2 to 2.9 m long, 9 to 1.2 cm high, together 20.75 cm at most. All have a
/// frequency of 2.5 radians per second. With `dispersion`, each has the frequency of gravity waves on deep water, the
/// square root of g k.
[[nodiscard]] std::vector<LakeWave> sourceWaves(bool dispersion);

/// Returns the wave that the reference's lanterns ride, which is none of these: 15.7 m long, 15 cm high, 0.2 s late.
[[nodiscard]] LakeWave sourceRideWave();

/// Returns `count` small wind waves, with lengths in equal ratios from 2.2 m to 10 cm. Each has the same share of the
/// mean square slope `slope`^2 (both axes together). They travel around `windDirection` (radians from -z towards +x).
[[nodiscard]] std::vector<LakeWave> windRipples(double slope, double windDirection, int count, std::uint32_t seed);

/// Response of a floating disk to a wave of `k` radians per meter, relative to a small disk. `height` is the mean
/// height over the disk: 2 J1(x)/x, with x = k radius. `slope` is that of the best-fitting plane: 8 J2(x)/x^2.
struct RideShare {
    double height = 1, slope = 1;
};
[[nodiscard]] RideShare rideShare(double k, double radius);

}  // namespace vitrine::paper_lanterns
