// Sums of octaves of noise: the GPU's source code, at float64.

#include "render/glsl/cpu.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

namespace n64 = vitrine::glsl;
using glm::dvec3;

n64::NoiseSum sumOf(int kind, int sum)
{
    return {kind, sum, 5, 0.5, 2.02, 0.6, 0, 9};
}

TEST(NoiseSums, HaveTheDerivativeThatDifferencesShow)
{
    constexpr double step = 1e-6;
    for (int sum = 0; sum < 4; ++sum) {
        for (int kind = 0; kind < 3; ++kind) {
            const n64::NoiseSum s = sumOf(kind, sum);
            test::Random random(20);
            int wrong = 0;
            for (int i = 0; i < 300; ++i) {
                const dvec3 p = random.point(20);
                for (const double warp : {0.0, 0.7}) {
                    const auto at = [&](const dvec3& q) {
                        return warp > 0 ? n64::noiseWarpedSum(s, q, warp, 0.0) : n64::noiseSum(s, q, 0.0);
                    };
                    const dvec3 slope = at(p).slope;
                    for (int axis = 0; axis < 3; ++axis) {
                        dvec3 d(0);
                        d[axis] = step;
                        const double difference = (at(p + d).value - at(p - d).value) / (2 * step);
                        wrong += std::abs(difference - slope[axis]) > 1e-4 * (1 + std::abs(difference));
                    }
                }
            }
            // Absolute values have kinks.
            EXPECT_LE(wrong, sum == n64::NOISE_FBM ? 0 : 8) << "sum " << sum << " of kind " << kind;
        }
    }
}

TEST(NoiseSums, StayInTheirRange)
{
    for (int sum = 0; sum < 4; ++sum) {
        test::Random random(21);
        double low = 9, high = -9;
        for (int i = 0; i < 20000; ++i) {
            const double value = n64::noiseSum(sumOf(1, sum), random.point(100), 0.0).value;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        EXPECT_GE(low, sum == n64::NOISE_TURBULENCE ? 0 : -1) << sum;
        EXPECT_LE(high, 1) << sum;
    }
}

TEST(NoiseSums, OfNoOctavesOrAnyGainAreFiniteAndInTheirRange)
{
    for (const int octaves : {0, 1, 10})
        for (const double gain : {0.0, 1.0, 2.0})
            for (const double lacunarity : {0.0, 0.5, 1.0, 8.0}) {
                n64::NoiseSum s = sumOf(1, 0);
                s.octaves = octaves;
                s.gain = gain;
                s.lacunarity = lacunarity;
                for (int i = 0; i < 20; ++i) {
                    const n64::Noise3 n = n64::noiseSum(s, dvec3(0.37 * i, 1.1, -2.3), 0.0);
                    EXPECT_TRUE(test::isFinite(n.slope));
                    EXPECT_LE(std::abs(n.value), 1) << octaves << ' ' << gain << ' ' << lacunarity;
                }
            }
}

TEST(NoiseSums, StayInTheirRangeHoweverFarTheirDomainIsWarped)
{
    test::Random random(23);
    for (int i = 0; i < 10000; ++i) {
        n64::NoiseSum s = sumOf(i % 4, (i / 4) % 4);
        s.gain = random.number(0, 1);
        s.octaves = 1 + i % 6;
        const double warp = std::pow(10, random.number(-3, 5));
        const n64::Noise3 n = n64::noiseWarpedSum(s, random.point(1000), warp, 0.0);
        EXPECT_LE(std::abs(n.value), 1);
        EXPECT_TRUE(test::isFinite(n.slope));
    }
}

TEST(NoiseSums, RepeatAfterTheirPeriod)
{
    n64::NoiseSum s = sumOf(1, 0);
    s.lacunarity = 2;
    s.rotation = 0;
    s.period = 4;
    for (int i = 0; i < 200; ++i) {
        const dvec3 p = dvec3(i % 7, i % 5, i % 3) + 0.25 * dvec3(1, 2, 3) / 1.0;
        EXPECT_EQ(n64::noiseSum(s, p, 0.0).value, n64::noiseSum(s, p + dvec3(4, -8, 400), 0.0).value);
    }
}

TEST(NoiseSums, LeaveOutOctavesFinerThanAPixelWithoutAStep)
{
    const n64::NoiseSum s = sumOf(1, 0);
    const dvec3 p(3.3, 1.2, 0.7);
    EXPECT_EQ(n64::noiseSum(s, p, 0.5).value, 0);
    n64::NoiseSum one = s;
    one.octaves = 1;
    // With two pixels in three cells of the first octave, the second octave is filtered out.
    EXPECT_NEAR(n64::noiseSum(s, p, 0.25).value * (1 + 0.5 + 0.25 + 0.125 + 0.0625), n64::noiseSum(one, p, 0.0).value,
                1e-3);
    double last = n64::noiseSum(s, p, 0.0).value;
    for (double footprint = 0; footprint < 0.6; footprint += 1e-4) {
        const double now = n64::noiseSum(s, p, footprint).value;
        EXPECT_LT(std::abs(now - last), 1e-2);
        last = now;
    }
}

}  // namespace
}  // namespace vitrine
