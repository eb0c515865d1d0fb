// Light scattered by dust in air: the GPU's source code, at float64 and float32, compared with the equation of
// radiative transport, and in the stability cases of fog.

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/rays_cpu32.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace {

namespace r64 = vitrine::glsl;
namespace r32 = vitrine::glsl32;
using glm::dvec2;
using glm::dvec3;

TEST(AirPhase, IntegratesToOneOverAllDirections)
{
    const auto naive = [](float cosine, float g) { return (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5F); };
    EXPECT_TRUE(std::isnan(naive(1, 1)));
    EXPECT_TRUE(std::isnan(naive(-1, -1)));
    for (const double g : {-0.999, -0.95, -0.5, 0.0, 0.3, 0.9, 0.999, 5.0}) {
        // A substitution concentrates the samples at the peak.
        double sum = 0;
        const int n = 400000;
        for (int i = 0; i < n; ++i) {
            const double u = (i + 0.5) / n;
            const double toPeak = 2 * u * u * u * u;  // Distance of the cosine from the peak.
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
                for (int i = 0; i < n; ++i)
                    sum += 0.05 * std::exp(-thinning * (1.5 + slope * way * (i + 0.5) / n)) * way / n;
                sum = std::min(sum, 1e4);  // Beyond this value no light is transmitted, and exp could overflow.
                EXPECT_NEAR(r64::airOpticalDepth(1.5, slope, way, 0.05, thinning), sum, 1e-5 * (1 + sum))
                    << slope << ' ' << thinning << ' ' << way;
                EXPECT_NEAR(r32::airOpticalDepth(1.5F, static_cast<float>(slope), static_cast<float>(way), 0.05F,
                                                 static_cast<float>(thinning)),
                            sum, 2e-5 * (1 + sum));
            }
        }
    }
}

TEST(AirOpticalDepth, LetsThroughBetweenNothingAndAllForEveryInput)
{
    // With a wrong sign, or a ray that enters behind its exit, the formula would give infinite light.
    const auto naive = [](float density, float way) { return std::exp(-density * way); };
    EXPECT_TRUE(std::isinf(naive(10, -10)));
    for (const double density : {0.0, 1e-12, 1e-6, 0.01, 10.0})
        for (const double thinning : {0.0, 1e-12, 1.0, 10.0})
            for (const double way : {-1.0, 0.0, 1e-9, 10.0, 1e9, std::numeric_limits<double>::infinity()})
                for (const double slope : {-1.0, 0.0, 1.0}) {
                    const double through = std::exp(-r64::airOpticalDepth(-3, slope, way, density, thinning));
                    EXPECT_TRUE(through >= 0 && through <= 1)
                        << density << ' ' << thinning << ' ' << way << ' ' << slope;
                    const float through32 =
                        std::exp(-r32::airOpticalDepth(-3, static_cast<float>(slope), static_cast<float>(way),
                                                       static_cast<float>(density), static_cast<float>(thinning)));
                    EXPECT_TRUE(through32 >= 0 && through32 <= 1)
                        << density << ' ' << thinning << ' ' << way << ' ' << slope;
                }
}

/// Air with dust that thins with height, and a ray through it. Uses formulas of its own, and none of the library.
struct Air {
    double density, thinning, from, slope, way;

    [[nodiscard]] double extinction(double t) const { return density * std::exp(-thinning * (from + slope * t)); }
    /// Returns the library's transmittance of the first `t` meters.
    [[nodiscard]] double through(double t) const
    {
        return std::exp(-r64::airOpticalDepth(from, slope, t, density, thinning));
    }
};

const Air airs[] = {{0.012, 0.08, 1.5, 0.3, 20}, {0.2, 0.1, 2, -0.2, 12}, {0.09, 0, 0, 1, 9},
                    {1, 0.3, 1, 0.4, 9},         {3, 2, 0.2, -0.01, 40},  {1e-6, 0.08, 1, 0, 10}};

/// Returns the radiance that leaves the air at `first` if `behind` enters it at `last`, in meters from the eye.
/// Radiance of 1 arrives from all sides, and the share `albedo` of the extinction is scattered. Solved by Runge-Kutta.
double transported(const Air& air, double first, double last, double behind, double albedo)
{
    constexpr int steps = 20000;
    const double h = (last - first) / steps;
    double light = behind;
    for (int i = steps; i > 0; --i) {
        const auto change = [&](double t, double l) { return air.extinction(t) * (albedo - l); };
        const double t = first + i * h;
        const double a = change(t, light);
        const double b = change(t - h / 2, light + h / 2 * a);
        const double c = change(t - h / 2, light + h / 2 * b);
        const double d = change(t - h, light + h * c);
        light += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return light;
}

TEST(AirScattering, OfALitStretchIsThatOfTheTransportEquationForAnyNumberOfSteps)
{
    for (const Air& air : airs) {
        // Lit between 30 % and 80 % of the ray, as by a beam.
        const double first = 0.3 * air.way;
        const double last = 0.8 * air.way;
        const double exact = transported(air, 0, first, transported(air, first, last, 0, 1), 0);
        for (const int steps : {1, 2, 3, 16, 1000}) {
            double sum = 0;
            double through = air.through(first);
            for (int i = 1; i <= steps; ++i) {
                const double throughEnd = air.through(first + (last - first) * i / steps);
                sum += r64::airScattered(through, throughEnd);
                through = throughEnd;
            }
            EXPECT_NEAR(sum, exact, 1e-9 * exact + 1e-15) << air.density << ' ' << steps;
        }
    }
}

TEST(AirScattering, ASingleStepBringsNoEnergy)
{
    const Air air = airs[1];
    const double exact = transported(air, 0, air.way, 0, 1);
    EXPECT_NEAR(r64::airScattered(1, air.through(air.way)), exact, 1e-9);
    // The left Riemann sum with two steps of density times transmittance gives far too much light.
    double naive = 0;
    for (int i = 0; i < 2; ++i) naive += air.extinction(6.0 * i) * air.through(6.0 * i) * 6;
    EXPECT_GT(naive / exact, 1.4);
}

TEST(AirScattering, AWhiteFurnaceStaysWhite)
{
    // Furnace test: with radiance 1 from every side and from behind, and dust that absorbs nothing, every pixel is 1.
    // Each direction acts as a sun, whose light the phase function scatters to the eye.
    for (const double anisotropy : {-0.9, 0.0, 0.42, 0.95}) {
        constexpr int cosines = 200000;
        double fromAll = 0;
        for (int i = 0; i < cosines; ++i)
            fromAll += r64::airPhase(2 * (i + 0.5) / cosines - 1, anisotropy) * 2 * std::numbers::pi * 2 / cosines;
        for (const Air& air : airs) {
            constexpr int steps = 5;
            double scattered = 0;
            double through = 1;
            for (int i = 1; i <= steps; ++i) {
                const double throughEnd = air.through(air.way * i / steps);
                scattered += r64::airScattered(through, throughEnd) * fromAll;
                through = throughEnd;
            }
            // The transmitted light comes from an independent integration.
            EXPECT_NEAR(transported(air, 0, air.way, 1, 0) + scattered, 1, 5e-6) << air.density << ' ' << anisotropy;
        }
    }
    // Dust that absorbs half of its extinction is darker.
    for (const Air& air : airs)
        EXPECT_NEAR(transported(air, 0, air.way, 1, 0.5),
                    air.through(air.way) + 0.5 * r64::airScattered(1, air.through(air.way)), 1e-9);
}

TEST(AirScattering, NoDustScattersNothingAndTheLeastOfItInProportion)
{
    const auto naive = [](auto x) { return (1 - std::exp(-x)) / x; };
    EXPECT_TRUE(std::isnan(naive(0.0)));
    EXPECT_EQ(naive(1e-8F), 0);  // Rounding destroys the result long before 0.
    EXPECT_EQ(r64::airMean(0), 1);
    for (int i = 0; i <= 1000; ++i) {
        const double sigma = i * 1e-9;
        for (const double sign : {-1.0, 1.0}) {
            EXPECT_NEAR(r64::airMean(sign * sigma), 1 - sign * sigma / 2, 1e-12);
            EXPECT_NEAR(r32::airMean(static_cast<float>(sign * sigma)), 1 - sign * sigma / 2, 1e-7);
        }
        // Density, and the thinning, which has a quotient of its own: both from 0 to a millionth.
        for (const double thinning : {0.0, sigma}) {
            const double depth = r64::airOpticalDepth(2, 0.5, 10, sigma, thinning);
            EXPECT_NEAR(depth, 10 * sigma, 1e-4 * sigma);
            EXPECT_NEAR(r32::airOpticalDepth(2, 0.5F, 10, static_cast<float>(sigma), static_cast<float>(thinning)),
                        10 * sigma, 1e-4 * sigma);
            EXPECT_NEAR(r64::airScattered(1, std::exp(-depth)), 10 * sigma, 1e-4 * sigma + 1e-15);
        }
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
            const bool lit = onWindow.x > low.x && onWindow.x < high.x && onWindow.y > low.y && onWindow.y < high.y &&
                             p.x > -6 && p.x < 6 && p.y > 0 && p.y < 9 && p.z > -12 && p.z < 12;
            inside += lit;
            EXPECT_EQ(t > stretch.x && t < stretch.y, lit) << i << ' ' << t;
        }
    }
    EXPECT_GT(inside, 500);
}

/// Returns the light that a ray scatters in a lit box of air, up to a surface at `end`, like
/// crepuscular_rays/march.frag.
template <typename Scalar, typename Vec3, typename Box, typename Depth, typename Scattered>
Scalar marched(const Vec3& eye, const Vec3& direction, Scalar end, const Box& box, const Depth& opticalDepth,
               const Scattered& scattered)
{
    const auto inside = box(eye, direction, Vec3(-1), Vec3(1));
    const Scalar first = std::max(inside.x, Scalar(0));
    const Scalar way = std::min(inside.y, end) - first;
    if (!(way > 0)) return 0;
    Scalar sum = 0;
    Scalar through = 1;
    for (int i = 1; i <= 4; ++i) {
        const Scalar throughEnd = std::exp(-opticalDepth(eye.y + direction.y * first, direction.y,
                                                         way * static_cast<Scalar>(i) / 4, Scalar(0.3), Scalar(0.1)));
        sum += scattered(through, throughEnd);
        through = throughEnd;
    }
    return sum;
}

TEST(LineBox, RaysOfNoLengthWithoutEndAndAlongFacesAreDefined)
{
    // The slab test with plain division gives 0/0 on a face and along it. Rays without a surface have infinite depth.
    const auto naive = [](float origin, float direction, float low) { return (low - origin) / direction; };
    EXPECT_TRUE(std::isnan(naive(-1, 0, -1)));
    const double infinity = std::numeric_limits<double>::infinity();
    const auto naiveDepth = [](double density, double thinning, double way) {
        return density * (1 - std::exp(-thinning * way)) / thinning;
    };
    EXPECT_TRUE(std::isnan(naiveDepth(0.3, 0, infinity)));

    EXPECT_EQ(r64::lineBox({0, 0, -5}, {0, 0, 1}, dvec3(-1), dvec3(1)), dvec2(4, 6));
    const dvec2 beside = r64::lineBox({2, 0, -5}, {0, 0, 1}, dvec3(-1), dvec3(1));
    EXPECT_LT(beside.y, beside.x);
    for (const double face : {-1.0, 1.0})
        for (const double zero : {0.0, -0.0, 1e-13, -1e-13}) {
            EXPECT_EQ(r64::lineBox({face, 0, -5}, {zero, 0, 1}, dvec3(-1), dvec3(1)), dvec2(4, 6))
                << face << ' ' << zero;  // In the face.
            EXPECT_EQ(r64::lineBox({face, face, -5}, {zero, zero, 1}, dvec3(-1), dvec3(1)), dvec2(4, 6))
                << face << ' ' << zero;  // Along the edge.
        }

    const auto ours = [](const dvec3& eye, const dvec3& direction, double end) {
        const double wide = marched<double>(eye, direction, end, r64::lineBox, r64::airOpticalDepth, r64::airScattered);
        const auto narrow =
            static_cast<double>(marched<float>(glm::vec3(eye), glm::vec3(direction), static_cast<float>(end),
                                               r32::lineBox, r32::airOpticalDepth, r32::airScattered));
        EXPECT_NEAR(narrow, wide, 1e-5);
        return wide;
    };
    const double whole = ours({0, 0, -5}, {0, 0, 1}, infinity);  // No surface: the sky.
    EXPECT_NEAR(whole, -std::expm1(-0.3 * 2), 1e-12);            // Two meters at height 0.
    EXPECT_EQ(ours({0, 0, -5}, {0, 0, 1}, 0), 0);                // A surface at the eye.
    EXPECT_EQ(ours({0, 0, 0}, {0, 0, 1}, 0), 0);
    EXPECT_EQ(ours({0, 0, -5}, {0, 0, 1}, 1e-30), 0);
    EXPECT_NEAR(ours({1, 0, -5}, {0, 0, 1}, infinity), whole, 1e-12);
    EXPECT_EQ(ours({0, 0, -5}, {0, 0, -1}, infinity), 0);
    // Without a direction the result is still finite.
    EXPECT_TRUE(std::isfinite(ours({0, 0, 0}, {0, 0, 0}, infinity)));
}

}  // namespace
