// Arithmetic of screen-space sunbeams: weights along a line toward the light. The GPU's source code, at float64 and
// float32. Light scattered by air is in air_test.cpp.

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/rays_cpu32.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace {

namespace r64 = vitrine::glsl;
namespace r32 = vitrine::glsl32;

const double decays[] = {0.0, 1e-6, 0.5, 0.9, 0.96, 0.99, 0.9999, 1 - 1e-6, 1.0};
const double densities[] = {0.0, 1e-7, 1e-3, 0.1, 0.5, 0.95, 1.0};

/// Returns the result of the loop for a mask along the ray, as a function of the remaining part.
double gathered(int samples, double decay, double density, const std::function<double(double)>& mask)
{
    const double exponent = r64::shaftExponent(decay);
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        sum += mask(r64::shaftStep(i, samples, density, 0)) * r64::shaftStepWeight(i, samples, density, exponent);
    return sum;
}

TEST(ShaftWeights, OfALoopAddUpToOneForEverySetting)
{
    for (const int n : {1, 2, 7, 128, 1000}) {
        for (const double decay : decays) {
            for (const double density : densities) {
                double sum = 0;
                float sum32 = 0;
                const float exponent32 = r32::shaftExponent(static_cast<float>(decay));
                for (int i = 0; i < n; ++i) {
                    const double weight = r64::shaftStepWeight(i, n, density, r64::shaftExponent(decay));
                    EXPECT_GE(weight, 0);
                    sum += weight;
                    sum32 += r32::shaftStepWeight(static_cast<float>(i), static_cast<float>(n),
                                                  static_cast<float>(density), exponent32);
                }
                EXPECT_NEAR(sum, 1, 1e-9) << n << ' ' << decay << ' ' << density;
                EXPECT_NEAR(sum32, 1, 2e-4)
                    // Up to 1000 roundings, and 1 / n if all weights are equal.
                    << n << ' ' << decay << ' ' << density;
            }
        }
    }
}

TEST(ShaftWeights, OfGeometricTapsAddUpToOneForEverySetting)
{
    for (const double taps : {1.0, 2.0, 6.0, 16.0}) {
        for (const double decay : decays) {
            for (const double density : densities) {
                const double exponent = r64::shaftExponent(decay);
                const double ratio = r64::shaftRatio(density, exponent, taps, 3);
                double sum = 0;
                for (double i = 0; i < taps; ++i) sum += r64::shaftTapWeight(i, taps, ratio, exponent);
                EXPECT_NEAR(sum, 1, 1e-9) << taps << ' ' << decay << ' ' << density;
            }
        }
    }
}

TEST(ShaftWeights, MoreSamplesMakeNothingBrighter)
{
    // A mask of bars: the mean over many lines must change by less than half a percent from 8 to 512 samples.
    const auto mean = [](int samples, bool normalized) {
        double sum = 0;
        for (int line = 0; line < 400; ++line) {
            const auto mask = [&](double t) { return std::fmod(t * 7 + line * 0.618, 1.0) < 0.4 ? 1.0 : 0.0; };
            if (normalized)
                sum += gathered(samples, 0.97, 0.9, mask);
            else
                for (int i = 0; i < samples; ++i) sum += 0.02 * std::pow(0.97, i) * mask(1 - 0.9 * i / samples);
        }
        return sum / 400;
    };
    const double reference = mean(4096, true);
    for (const int samples : {8, 16, 32, 64, 128, 216, 512})
        EXPECT_NEAR(mean(samples, true) / reference, 1, 0.005) << samples;
    EXPECT_GT(std::abs(mean(8, false) / mean(512, false) - 1), 0.5);  // The reference's sum changes by more than half.
}

TEST(ShaftWeights, GeometricStepsHaveTheirMeanHoweverLongTheyAre)
{
    for (const double ratio : {0.3, 0.7, 0.99}) {
        for (const double exponent : {1.0, 1.77, 30.0}) {
            // Mean of the mask t with the weight a t^(a-1), over the step from ratio to 1.
            const double exact =
                exponent / (exponent + 1) * (1 - std::pow(ratio, exponent + 1)) / (1 - std::pow(ratio, exponent));
            double mean = 0;
            constexpr int shares = 2000;
            for (int i = 0; i < shares; ++i) {
                const double place = r64::shaftTapPlace(ratio, exponent, (i + 0.5) / shares);
                EXPECT_GE(place, ratio);
                EXPECT_LE(place, 1);
                mean += place / shares;
            }
            EXPECT_NEAR(mean, exact, 1e-5) << ratio << ' ' << exponent;
            // The geometric middle is too near to the light for long steps.
            if (ratio < 0.5 && exponent == 1) {
                EXPECT_LT(std::sqrt(ratio), 0.9 * exact);
            }
        }
    }
}

TEST(ShaftWeights, ADecayAboveOneIsNoBrighterThanTheMask)
{
    // The reference's sum at a decay of 1.1 is 4500 times the mask.
    double naive = 0;
    for (int i = 0; i < 64; ++i) naive += std::pow(1.1, i);
    EXPECT_GT(naive, 4400);
    for (const double decay : {1 + 1e-9, 1.001, 1.1, 2.0, 1e30, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(r64::shaftExponent(decay), 1) << decay;
        EXPECT_GE(r64::shaftExponentAt(decay, 3), 1) << decay;
        for (const double density : densities) {
            EXPECT_NEAR(gathered(64, decay, density, [](double) { return 1.0; }), 1, 1e-9) << decay;
            const double ratio = r64::shaftRatio(density, r64::shaftExponent(decay), 6, 3);
            double sum = 0;
            for (double i = 0; i < 6; ++i) sum += r64::shaftTapWeight(i, 6, ratio, r64::shaftExponent(decay));
            EXPECT_NEAR(sum, 1, 1e-9) << decay;
        }
        EXPECT_EQ(r32::shaftExponent(static_cast<float>(decay)), 1) << decay;
    }
}

TEST(ShaftWeights, WithoutAWayToGoTheMaskItselfIsSeen)
{
    // A step's share of zero weight is 0/0.
    const auto naive = [](double i, double n, double density, double a) {
        return (std::pow(1 - density * i / n, a) - std::pow(1 - density * (i + 1) / n, a)) /
               (1 - std::pow(1 - density, a));
    };
    EXPECT_TRUE(std::isnan(naive(0, 8, 0, 3)));
    for (const int n : {1, 8, 100})
        EXPECT_NEAR(gathered(n, 0.97, 0, [](double t) { return t == 1 ? 0.375 : 99; }), 0.375, 1e-12);
    EXPECT_NEAR(gathered(64, 0, 1, [](double t) { return t > 0.99 ? 0.375 : 0; }), 0.375, 1e-12);
}

TEST(ShaftWeights, DensityBeyondOneDoesNotReachThroughTheLight)
{
    for (const double density : {1.0, 1.5, 100.0})
        for (int i = 0; i < 8; ++i) EXPECT_GE(r64::shaftStep(i, 8, r64::shaftDensity(density, 1), 0.5), 0);
    EXPECT_LT(r64::shaftStep(7, 8, 1.5, 0), 0);  // Without the clamp, the rays would be mirrored beyond the sun.
}

TEST(ShaftWeights, ComposeExactlyOverPassesOfGeometricTaps)
{
    // Three passes of 4 taps equal one of 64, for any mask.
    const double exponent = r64::shaftExponent(0.98);
    const double taps = 4;
    const double ratio = r64::shaftRatio(0.9, exponent, taps, 3);
    const auto mask = [](double t) { return 0.5 + 0.5 * std::sin(40 * t) * std::cos(11 * t * t); };
    const std::function<double(double, int)> pass = [&](double t, int number) -> double {
        if (number < 0) return mask(t);
        const double step = std::pow(ratio, std::pow(taps, number));
        double sum = 0;
        for (double i = 0; i < taps; ++i)
            sum += pass(t * std::pow(step, i), number - 1) * r64::shaftTapWeight(i, taps, step, exponent);
        return sum;
    };
    double whole = 0;
    for (double i = 0; i < 64; ++i) whole += mask(std::pow(ratio, i)) * r64::shaftTapWeight(i, 64, ratio, exponent);
    EXPECT_NEAR(pass(1, 2), whole, 1e-12);
    EXPECT_GE(std::pow(ratio, 64), 0.1 - 1e-12);  // No tap is beyond the part of the ray that the density allows.
}

TEST(ShaftWeights, AllMethodsConvergeToTheIntegral)
{
    // A disk around the light with a quarter of the ray: the integral of a t^(a-1) from 0 to 1/4 is (1/4)^a.
    for (const double decay : {0.99, 0.995, 1.0}) {
        const double exponent = r64::shaftExponent(decay);
        const double exact = std::pow(0.25, exponent);
        EXPECT_NEAR(gathered(100000, decay, 1, [](double t) { return t < 0.25 ? 1.0 : 0.0; }), exact, 1e-4);
        const double ratio = r64::shaftRatio(1, exponent, 60, 3);
        double sum = 0;
        for (double i = 0; i < 216000; ++i)
            sum += (std::pow(ratio, i + 0.5) < 0.25 ? 1.0 : 0.0) * r64::shaftTapWeight(i, 216000, ratio, exponent);
        EXPECT_NEAR(sum, exact, 0.004);  // Two thousandths of the weight, next to the light, are left out.
        // The running sum outwards.
        const double keep = std::pow(0.999, exponent);
        double mean = 1;
        for (double radius = 0.001; radius < 1; radius /= 0.999) mean = mean * keep + (radius < 0.25 ? 1 - keep : 0);
        EXPECT_NEAR(mean, exact, 0.002);
    }
}

TEST(ShaftWeights, AreTheOriginalsNearThePixel)
{
    // decay^(128 s) and (1 - s)^(a - 1), where s is the traveled share of the ray, are equal to first order.
    for (const double decay : {0.95, 0.98, 0.995}) {
        const double s = 1e-4;
        EXPECT_NEAR(std::pow(decay, 128 * s), std::pow(1 - s, r64::shaftExponent(decay) - 1), 1e-6);
    }
}

TEST(EdgeFade, IsOneInsideZeroBeyondTheMarginAndSmoothBetween)
{
    EXPECT_EQ(r64::shaftEdgeFade(-0.5, 1), 1);
    EXPECT_EQ(r64::shaftEdgeFade(1, 1), 0);
    EXPECT_EQ(r64::shaftEdgeFade(std::numeric_limits<double>::infinity(), 1), 0);
    double before = 1;
    for (double beyond = 0; beyond <= 1; beyond += 0.01) {
        const double fade = r64::shaftEdgeFade(beyond, 1);
        EXPECT_LE(fade, before);
        EXPECT_LT(before - fade, 0.016);
        before = fade;
    }
}

}  // namespace
