#include "exhibits/noise/sea_waves.h"

#include "render/glsl/cpu.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::noise {
namespace {

constexpr double gravity = 9.81;  // m/s^2

/// Returns the variance of the height per angular frequency (radians per second), m^2 s.
double heightSpectrum(double frequency, double windSpeed)
{
    const double ratio = gravity / (1.026 * windSpeed * frequency);  // The formula's wind is measured at 19.5 m.
    return 0.0081 * gravity * gravity / std::pow(frequency, 5) * std::exp(-0.74 * std::pow(ratio, 4));
}

/// Returns a random number in [0, 1) by index and seed.
double evenNumber(int i, std::uint32_t seed, std::uint32_t which)
{
    return glsl::unitFromBits(glsl::pcg3d({static_cast<std::uint32_t>(i), seed, which}).x);
}

}  // namespace

std::vector<SeaWave> seaWaves(double windSpeed, double windDirection, int count, std::uint32_t seed)
{
    const double peak = 0.877 * gravity / (1.026 * windSpeed);
    const double lowest = 0.72 * peak;
    const double highest = std::max(std::sqrt(gravity * 2 * std::numbers::pi / 0.25), 2 * lowest);
    std::vector<SeaWave> waves;
    for (int i = 0; i < count; ++i) {
        const auto edge = [&](int j) { return lowest * std::pow(highest / lowest, static_cast<double>(j) / count); };
        SeaWave wave;
        wave.frequency = edge(i) * std::pow(edge(i + 1) / edge(i), evenNumber(i, seed, 1));
        wave.amplitude = std::sqrt(2 * heightSpectrum(wave.frequency, windSpeed) * (edge(i + 1) - edge(i)));
        // A sum of uniform numbers is nearly normal. Its width increases from 20 degrees at the peak to 55 in the
        // ripples.
        double bell = -2;
        for (std::uint32_t k = 0; k < 4; ++k) bell += evenNumber(i, seed, 2 + k);
        const double width = std::clamp(0.35 + 0.25 * std::log(wave.frequency / peak), 0.3, 0.96);
        const double angle = windDirection + bell * width * std::sqrt(3.0);
        wave.vector = wave.frequency * wave.frequency / gravity * glm::dvec2(std::sin(angle), -std::cos(angle));
        wave.phase = 2 * std::numbers::pi * evenNumber(i, seed, 9);
        waves.push_back(wave);
    }
    return waves;
}

double seaSlopes(double windSpeed)
{
    return 0.003 + 0.00512 * windSpeed;
}

}  // namespace vitrine::noise
