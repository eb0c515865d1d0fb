#include "exhibits/paper_lanterns/lake_waves.h"

#include "render/glsl/cpu.h"

#include <cmath>
#include <numbers>

namespace vitrine::paper_lanterns {
namespace {

constexpr double lakeGravity = 9.81;  // m/s^2

/// Returns a random number in [0, 1) by index and seed.
double rippleNumber(int i, std::uint32_t seed, std::uint32_t which)
{
    return glsl::unitFromBits(glsl::pcg3d({static_cast<std::uint32_t>(i), seed, which}).x);
}

}  // namespace

std::vector<LakeWave> sourceWaves(bool dispersion)
{
    constexpr glm::dvec2 directions[] = {
        {-0.371391, 0.928477}, {0, -1}, {-0.624695, 0.780869}, {-0.768221, -0.640184}, {0.371391, 0.928477}};
    std::vector<LakeWave> waves;
    double amplitude = 0.15, k = 0.4;
    for (const glm::dvec2& direction : directions) {
        amplitude *= 0.6;
        k *= 1.4;
        LakeWave wave;
        wave.vector = k * direction;
        wave.amplitude = amplitude;
        wave.frequency = dispersion ? std::sqrt(lakeGravity * glm::length(wave.vector)) : 2.5;
        wave.phase = std::numbers::pi;  // The reference's surface is at -1 minus the sum.
        waves.push_back(wave);
    }
    return waves;
}

LakeWave sourceRideWave()
{
    return {0.4 * glm::dvec2(-0.371391, 0.928477), 0.15, 2.5, std::numbers::pi - 0.2 * 2.5};
}

std::vector<LakeWave> windRipples(double slope, double windDirection, int count, std::uint32_t seed)
{
    constexpr double longest = 2.2, shortest = 0.1;
    std::vector<LakeWave> waves;
    for (int i = 0; i < count; ++i) {
        const double share = (i + rippleNumber(i, seed, 1)) / count;
        const double k = 2 * std::numbers::pi / (longest * std::pow(shortest / longest, share));
        // A sum of uniform numbers is nearly normal, here 40 degrees wide.
        double bell = -2;
        for (std::uint32_t j = 0; j < 4; ++j) bell += rippleNumber(i, seed, 2 + j);
        const double angle = windDirection + 0.7 * std::sqrt(3.0) * bell;
        LakeWave wave;
        // Phases increase, so a vector against the wind means travel with the wind.
        wave.vector = -k * glm::dvec2(std::sin(angle), -std::cos(angle));
        wave.amplitude = slope * std::sqrt(2.0 / count) / k;
        wave.frequency = std::sqrt(lakeGravity * k + 7.3e-5 * k * k * k);  // Water: surface tension over density.
        wave.phase = 2 * std::numbers::pi * rippleNumber(i, seed, 9);
        waves.push_back(wave);
    }
    return waves;
}

RideShare rideShare(double k, double radius)
{
    const double x = k * radius;
    if (x < 1e-3) return {};
    return {2 * std::cyl_bessel_j(1.0, x) / x, 8 * std::cyl_bessel_j(2.0, x) / (x * x)};
}

}  // namespace vitrine::paper_lanterns
