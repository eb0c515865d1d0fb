// The arithmetic of the sunbeams: weights along a ray of the screen, and light scattered in air. The very source that
// the GPU runs, at float64 and at float32.

#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace {

namespace r64 = vitrine::glsl;
namespace r32 = vitrine::glsl32;
using glm::dvec2;
using glm::dvec3;

const double decays[] = {0.0, 1e-6, 0.5, 0.9, 0.96, 0.99, 0.9999, 1 - 1e-6, 1.0};
const double densities[] = {0.0, 1e-7, 1e-3, 0.1, 0.5, 0.95, 1.0};

/// What the loop makes of a mask along the way, told by what remains of it.
double gathered(int samples, double decay, double density, const std::function<double(double)>& mask)
{
    const double exponent = r64::shaftExponent(decay);
    double sum = 0;
    for (int i = 0; i < samples; ++i) sum += mask(r64::shaftStep(i, samples, density, 0)) * r64::shaftStepWeight(i, samples, density, exponent);
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
                    sum32 += r32::shaftStepWeight(static_cast<float>(i), static_cast<float>(n), static_cast<float>(density), exponent32);
                }
                EXPECT_NEAR(sum, 1, 1e-9) << n << ' ' << decay << ' ' << density;
                EXPECT_NEAR(sum32, 1, 2e-4) << n << ' ' << decay << ' ' << density;  // Up to 1000 roundings, and 1 / n where all are alike.
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

TEST(ShaftWeights, ThePlainSumIsTheClosedFormAlsoWhereItIsZeroOverZero)
{
    for (const int n : {1, 2, 64, 128, 512}) {
        for (const double decay : decays) {
            double sum = 0;
            double share = 1;
            for (int i = 0; i < n; ++i, share *= decay) sum += 0.1 * share;
            EXPECT_NEAR(r64::shaftPlainSum(0.1, decay, n), sum, 1e-9 * n) << n << ' ' << decay;
        }
        EXPECT_EQ(r64::shaftPlainSum(1, 1, n), n);
        for (const double e : {-1e-6, 1e-6}) {
            EXPECT_NEAR(r64::shaftPlainSum(1, 1 + e, n), r64::shaftPlainSum(1, 1, n), 1e-6 * n * n);
            EXPECT_NEAR(r32::shaftPlainSum(1, static_cast<float>(1 + e), static_cast<float>(n)), n, 1e-3 * n);
        }
    }
    EXPECT_TRUE(std::isnan((1 - std::pow(1.0F, 64.0F)) / (1 - 1.0F)));
}

TEST(ShaftWeights, MoreSamplesMakeNothingBrighter)
{
    // A mask of bars: the mean over many lines must not move by half a percent from 8 to 512 samples.
    const auto mean = [](int samples, bool normalized) {
        double sum = 0;
        for (int line = 0; line < 400; ++line) {
            const auto mask = [&](double t) { return std::fmod(t * 7 + line * 0.618, 1.0) < 0.4 ? 1.0 : 0.0; };
            if (normalized) sum += gathered(samples, 0.97, 0.9, mask);
            else for (int i = 0; i < samples; ++i) sum += 0.02 * std::pow(0.97, i) * mask(1 - 0.9 * i / samples);
        }
        return sum / 400;
    };
    const double reference = mean(4096, true);
    for (const int samples : {8, 16, 32, 64, 128, 216, 512}) EXPECT_NEAR(mean(samples, true) / reference, 1, 0.005) << samples;
    EXPECT_GT(std::abs(mean(8, false) / mean(512, false) - 1), 0.5);  // The original's sum does.
}

TEST(ShaftWeights, GeometricStepsHaveTheirMeanHoweverLongTheyAre)
{
    for (const double ratio : {0.3, 0.7, 0.99}) {
        for (const double exponent : {1.0, 1.77, 30.0}) {
            // Of the mask t, with the weight a t^(a-1), over the step from ratio to 1.
            const double exact = exponent / (exponent + 1) * (1 - std::pow(ratio, exponent + 1)) / (1 - std::pow(ratio, exponent));
            double mean = 0;
            constexpr int shares = 2000;
            for (int i = 0; i < shares; ++i) {
                const double place = r64::shaftTapPlace(ratio, exponent, (i + 0.5) / shares);
                EXPECT_GE(place, ratio);
                EXPECT_LE(place, 1);
                mean += place / shares;
            }
            EXPECT_NEAR(mean, exact, 1e-5) << ratio << ' ' << exponent;
            // The middle of the ratios is too near to the light where steps are long.
            if (ratio < 0.5 && exponent == 1) {
                EXPECT_LT(std::sqrt(ratio), 0.9 * exact);
            }
        }
    }
}

TEST(ShaftWeights, WithoutAWayToGoTheMaskItselfIsSeen)
{
    for (const int n : {1, 8, 100}) EXPECT_NEAR(gathered(n, 0.97, 0, [](double t) { return t == 1 ? 0.375 : 99; }), 0.375, 1e-12);
    EXPECT_NEAR(gathered(64, 0, 1, [](double t) { return t > 0.99 ? 0.375 : 0; }), 0.375, 1e-12);
}

TEST(ShaftWeights, DensityBeyondOneDoesNotReachThroughTheLight)
{
    for (const double density : {1.0, 1.5, 100.0})
        for (int i = 0; i < 8; ++i) EXPECT_GE(r64::shaftStep(i, 8, r64::shaftDensity(density, 1), 0.5), 0);
    EXPECT_LT(1 - 1.5 * (7.5 / 8), 0);  // Unclamped, it would: rays mirrored beyond the sun.
}

TEST(ShaftWeights, ComposeExactlyOverPassesOfGeometricTaps)
{
    // Three passes of 4 taps are one of 64, for any mask.
    const double exponent = r64::shaftExponent(0.98);
    const double taps = 4;
    const double ratio = r64::shaftRatio(0.9, exponent, taps, 3);
    const auto mask = [](double t) { return 0.5 + 0.5 * std::sin(40 * t) * std::cos(11 * t * t); };
    const std::function<double(double, int)> pass = [&](double t, int number) -> double {
        if (number < 0) return mask(t);
        const double step = std::pow(ratio, std::pow(taps, number));
        double sum = 0;
        for (double i = 0; i < taps; ++i) sum += pass(t * std::pow(step, i), number - 1) * r64::shaftTapWeight(i, taps, step, exponent);
        return sum;
    };
    double whole = 0;
    for (double i = 0; i < 64; ++i) whole += mask(std::pow(ratio, i)) * r64::shaftTapWeight(i, 64, ratio, exponent);
    EXPECT_NEAR(pass(1, 2), whole, 1e-12);
    EXPECT_GE(std::pow(ratio, 64), 0.1 - 1e-12);  // And no tap looks beyond the density's share of the way.
}

TEST(ShaftWeights, AllMethodsConvergeToTheIntegral)
{
    // A disk around the light of a quarter of the way: the integral of a t^(a-1) from 0 to 1/4 is (1/4)^a.
    for (const double decay : {0.99, 0.995, 1.0}) {
        const double exponent = r64::shaftExponent(decay);
        const double exact = std::pow(0.25, exponent);
        EXPECT_NEAR(gathered(100000, decay, 1, [](double t) { return t < 0.25 ? 1.0 : 0.0; }), exact, 1e-4);
        const double ratio = r64::shaftRatio(1, exponent, 60, 3);
        double sum = 0;
        for (double i = 0; i < 216000; ++i) sum += (std::pow(ratio, i + 0.5) < 0.25 ? 1.0 : 0.0) * r64::shaftTapWeight(i, 216000, ratio, exponent);
        EXPECT_NEAR(sum, exact, 0.004);  // What is left out next to the light: two thousandths of the weight.
        // The running sum outwards.
        const double keep = std::pow(0.999, exponent);
        double mean = 1;
        for (double radius = 0.001; radius < 1; radius /= 0.999) mean = mean * keep + (radius < 0.25 ? 1 - keep : 0);
        EXPECT_NEAR(mean, exact, 0.002);
    }
}

TEST(ShaftWeights, AreTheOriginalsNearThePixel)
{
    // decay^(128 s) and (1 - s)^(a - 1), s the share of the way gone: equal to first order.
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

TEST(AirPhase, IntegratesToOneOverAllDirections)
{
    for (const double g : {-0.999, -0.95, -0.5, 0.0, 0.3, 0.9, 0.999, 5.0}) {
        // In the cosine's own variable the peak is resolved by a substitution towards it.
        double sum = 0;
        const int n = 400000;
        for (int i = 0; i < n; ++i) {
            const double u = (i + 0.5) / n;
            const double toPeak = 2 * u * u * u * u;  // 1 - |cosine| side of the peak
            const double cosine = g >= 0 ? 1 - toPeak : toPeak - 1;
            const double phase = r64::airPhase(cosine, g);
            EXPECT_TRUE(std::isfinite(phase));
            sum += phase * 8 * u * u * u / n;
        }
        EXPECT_NEAR(2 * std::numbers::pi * sum, 1, 1e-3) << g;
    }
    EXPECT_TRUE(std::isfinite(r32::airPhase(1, 1)));
    EXPECT_TRUE(std::isfinite(r32::airPhase(-1, -1)));
}

TEST(AirOpticalDepth, IsTheIntegralOfTheDensity)
{
    for (const double slope : {-0.7, -1e-9, 0.0, 1e-5, 0.3, 1.0}) {
        for (const double thinning : {0.0, 1e-7, 0.08, 2.0}) {
            for (const double way : {0.0, 1e-3, 3.0, 20.0}) {
                double sum = 0;
                const int n = 4000;
                for (int i = 0; i < n; ++i) sum += 0.05 * std::exp(-thinning * (1.5 + slope * way * (i + 0.5) / n)) * way / n;
                sum = std::min(sum, 1e4);  // Beyond this nothing comes through, and exp could overflow.
                EXPECT_NEAR(r64::airOpticalDepth(1.5, slope, way, 0.05, thinning), sum, 1e-5 * (1 + sum)) << slope << ' ' << thinning << ' ' << way;
                EXPECT_NEAR(r32::airOpticalDepth(1.5F, static_cast<float>(slope), static_cast<float>(way), 0.05F, static_cast<float>(thinning)), sum, 2e-5 * (1 + sum));
            }
        }
    }
}

TEST(AirOpticalDepth, LetsThroughBetweenNothingAndAllForEveryInput)
{
    for (const double density : {0.0, 1e-12, 1e-6, 0.01, 10.0})
        for (const double thinning : {0.0, 1e-12, 1.0, 10.0})
            for (const double way : {-1.0, 0.0, 1e-9, 10.0, 1e9, std::numeric_limits<double>::infinity()})
                for (const double slope : {-1.0, 0.0, 1.0}) {
                    const double through = std::exp(-r64::airOpticalDepth(-3, slope, std::min(way, 1e9), density, thinning));
                    EXPECT_TRUE(through >= 0 && through <= 1) << density << ' ' << thinning << ' ' << way << ' ' << slope;
                    const float through32 = std::exp(-r32::airOpticalDepth(-3, static_cast<float>(slope), static_cast<float>(std::min(way, 1e9)), static_cast<float>(density), static_cast<float>(thinning)));
                    EXPECT_TRUE(through32 >= 0 && through32 <= 1) << density << ' ' << thinning << ' ' << way << ' ' << slope;
                }
    // Small densities are small depths, not rounding: sigma from 0 to 1e-6.
    for (int i = 0; i <= 100; ++i) EXPECT_NEAR(r64::airOpticalDepth(0, 0, 10, i * 1e-8, 0), i * 1e-7, 1e-15);
}

TEST(AirScattering, OfALitSlabIsTheClosedFormForAnyNumberOfSteps)
{
    const double exact = 1 - std::exp(-r64::airOpticalDepth(2, -0.2, 12, 0.2, 0.1));
    for (const int steps : {1, 2, 3, 16, 1000}) {
        double sum = 0;
        double before = 1;
        for (int i = 1; i <= steps; ++i) {
            const double after = std::exp(-r64::airOpticalDepth(2, -0.2, 12.0 * i / steps, 0.2, 0.1));
            sum += before - after;
            before = after;
        }
        EXPECT_NEAR(sum, exact, 1e-12) << steps;
    }
    // Density times transmittance times length, at the beginning of each of two steps, makes far too much light.
    double naive = 0;
    for (int i = 0; i < 2; ++i) naive += 0.2 * std::exp(-0.1 * (2 - 0.2 * 6 * i)) * std::exp(-r64::airOpticalDepth(2, -0.2, 6.0 * i, 0.2, 0.1)) * 6;
    EXPECT_GT(naive / exact, 1.4);
}

TEST(AirScattering, AWhiteRoomStaysWhite)
{
    // Light 1 behind the air and light 1 all around in it: what is taken out is what is put in.
    for (const double density : {0.0, 0.01, 1.0, 1e4}) {
        const double through = std::exp(-r64::airOpticalDepth(1, 0.4, 9, density, 0.3));
        EXPECT_NEAR(1.0 * through + 1.0 * (1 - through), 1, 1e-15);
    }
}

TEST(AirBeam, HoldsExactlyThePointsThatTheLightReachesThroughTheOpening)
{
    const dvec3 sun = glm::normalize(dvec3(-0.3, 0.5, -1));
    const dvec3 along = sun / sun.z;
    const dvec3 low(-1.2, 1.4, -12.5), high(1.2, 6.4, -11.9), roomLow(-6, 0, -12), roomHigh(6, 9, 12);
    std::uint32_t state = 7;
    const auto number = [&](double a, double b) {
        state = state * 747796405U + 2891336453U;
        return a + (b - a) * (state >> 8U) / 16777216.0;
    };
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 eye(number(-6, 6), number(0, 8), number(-14, 12));
        const dvec3 direction = glm::normalize(dvec3(number(-1, 1), number(-1, 1), number(-1, 1)));
        const dvec2 stretch = r64::airBeam(eye, direction, low, high, 2, -12, along, roomLow, roomHigh);
        for (int k = 0; k < 20; ++k) {
            const double t = number(-20, 20);
            const dvec3 p = eye + direction * t;
            const dvec3 onWindow = p - along * (p.z + 12);
            const bool lit = onWindow.x > low.x && onWindow.x < high.x && onWindow.y > low.y && onWindow.y < high.y && p.x > -6 && p.x < 6 && p.y > 0 && p.y < 9 && p.z > -12 && p.z < 12;
            inside += lit;
            EXPECT_EQ(t > stretch.x && t < stretch.y, lit) << i << ' ' << t;
        }
    }
    EXPECT_GT(inside, 500);
}

TEST(AirBox, IsDefinedForRaysAlongItsFaces)
{
    const dvec2 through = r64::airBox({0, 0, -5}, {0, 0, 1}, dvec3(-1), dvec3(1));
    EXPECT_EQ(through, dvec2(4, 6));
    const dvec2 beside = r64::airBox({2, 0, -5}, {0, 0, 1}, dvec3(-1), dvec3(1));
    EXPECT_LT(beside.y, beside.x);
}

}  // namespace
