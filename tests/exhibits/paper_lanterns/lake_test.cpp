// The water and floating lanterns.

#include "exhibits/paper_lanterns/lake_waves.h"
#include "tests/exhibits/paper_lanterns/lake_at_float64.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vitrine::paper_lanterns {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

TEST(LakeWaves, AreTheReferencesFiveAndStayWithinTheirBounds)
{
    const std::vector<LakeWave> waves = sourceWaves(false);
    const double lengths[] = {11.2, 8.0, 5.7, 4.1, 2.9}, amplitudes[] = {0.09, 0.054, 0.0324, 0.0194, 0.0117};
    ASSERT_EQ(waves.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(2 * std::numbers::pi / glm::length(waves[i].vector), lengths[i], 0.06);
        EXPECT_NEAR(waves[i].amplitude, amplitudes[i], 5e-5);
        EXPECT_EQ(waves[i].frequency, 2.5);
    }
    double highest = 0, steepest = 0;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-500, 500);
    for (int i = 0; i < 40; ++i) {
        glsl::Lake lake = lakeAtFloat64(sourceLake(), 1.7 * i);
        EXPECT_NEAR(lake.lake.waveTop, 0.2075, 1e-4);
        EXPECT_NEAR(lake.lake.waveSlope, 0.1833, 1e-4);
        for (int j = 0; j < 5000; ++j) {
            const auto at = lake.lakeAt({place(random), place(random)});
            highest = std::max(highest, std::abs(at.height));
            steepest = std::max(steepest, glm::length(at.slope));
        }
    }
    EXPECT_LE(highest, 0.2075 + 1e-6);
    EXPECT_LE(steepest, 0.1833 + 1e-4);
    // The bounds are tight.
    EXPECT_GT(highest, 0.17);
    EXPECT_GT(steepest, 0.12);
}

TEST(LakeWaves, AreTheReferencesSumWithItsSign)
{
    glsl::Lake lake = lakeAtFloat64(sourceLake(), 3.1);
    const dvec2 directions[] = {
        {-0.371391, 0.928477}, {0, -1}, {-0.624695, 0.780869}, {-0.768221, -0.640184}, {0.371391, 0.928477}};
    for (const dvec2 p : {dvec2(0), dvec2(3, -7), dvec2(-20, 11)}) {
        double sum = 0, a = 0.15, w = 0.4;
        for (const dvec2& d : directions) {
            a *= 0.6;
            w *= 1.4;
            sum += a * std::sin(glm::dot(d, p) * w + 3.1 * 2.5);
        }
        EXPECT_NEAR(lake.lakeAt(p).height, -sum, 1e-4);
    }
}

TEST(LakeWaves, RunAsGravityMakesThem)
{
    for (const LakeWave& wave : sourceWaves(true))
        EXPECT_NEAR(wave.frequency * wave.frequency, 9.81 * glm::length(wave.vector), 1e-6);
    // In the reference all waves have one phase speed, which at most one wave of deep water has.
    int right = 0;
    for (const LakeWave& wave : sourceWaves(false))
        right += std::abs(wave.frequency * wave.frequency / (9.81 * glm::length(wave.vector)) - 1) < 0.02;
    EXPECT_LE(right, 1);
    double slopes = 0;
    for (const LakeWave& wave : windRipples(0.05, 0.3, 23, 1))
        slopes += 0.5 * std::pow(wave.amplitude * glm::length(wave.vector), 2);
    EXPECT_NEAR(slopes, 0.0025, 1e-9);
}

/// Returns the largest errors of base height and tilt of some lanterns over 60 s, in meters and radians. The true
/// values are those of the plane that fits the water below the square base best.
dvec2 rideError(const ParameterValues& values)
{
    dvec2 worst(0);
    for (int step = 0; step < 60; ++step) {
        glsl::Lake lake = lakeAtFloat64(values, step + 0.37 * (step % 3));
        for (int i = 0; i < 12; ++i) {
            const auto l = lake.lanternOfCell({5 + 3 * i, 2 + 5 * i});
            const dvec2 x(std::cos(l.turn), std::sin(l.turn)), z(-x.y, x.x);
            double height = 0, sx = 0, sz = 0, squares = 0;
            constexpr int side = 21;
            for (int a = 0; a < side; ++a)
                for (int b = 0; b < side; ++b) {
                    const double u = 1.1 * (2 * (a + 0.5) / side - 1), v = 1.1 * (2 * (b + 0.5) / side - 1);
                    const double h = lake.lakeAt(dvec2(l.place.x, l.place.z) + u * x + v * z).height;
                    height += h / (side * side);
                    sx += h * u;
                    sz += h * v;
                    squares += u * u;
                }
            const dvec2 slope = (sx * x + sz * z) / squares;
            const dvec3 truth = glm::normalize(dvec3(-slope.x, 1, -slope.y));
            const dvec3 up = glm::normalize(dvec3(-l.tilt.x, 1, -l.tilt.y));
            worst.x = std::max(worst.x, std::abs(l.place.y - height));
            worst.y = std::max(worst.y, std::acos(std::min(glm::dot(truth, up), 1.0)));
        }
    }
    return worst;
}

TEST(LanternsAfloat, SitOnTheWaterWithinACentimeterAndADegree)
{
    ParameterValues values = sourceLake();
    const dvec2 error = rideError(values);
    EXPECT_LT(error.x, 0.01);
    EXPECT_LT(error.y, std::numbers::pi / 180);
    // Control: the reference's wave for lanterns is not one of the water's.
    values.set(lanternsTable().ride, LakeRide::reference);
    const dvec2 rough = rideError(values);
    EXPECT_GT(rough.x, 0.1);
    EXPECT_GT(rough.y, 3 * std::numbers::pi / 180);
}

TEST(LanternsAfloat, DriftWithTheWindAndKeepTheirLook)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().drift, 1.0);
    values.set(lanternsTable().waveHeight, 0.0);
    values.set(lanternsTable().flicker, 0.0);
    glsl::Lake now = lakeAtFloat64(values, 100), later = lakeAtFloat64(values, 103);
    const auto a = now.lanternOfCell({20, 20});
    const glm::ivec2 cell = glm::ivec2(20) + now.lake.firstCell - later.lake.firstCell;
    const auto b = later.lanternOfCell(cell);
    EXPECT_EQ(a.hue, b.hue);
    EXPECT_EQ(a.turn, b.turn);
    const double angle = values[lanternsTable().windDirection] + std::numbers::pi / 4;
    EXPECT_NEAR(b.place.x - a.place.x, 3 * std::sin(angle), 1e-3);
    EXPECT_NEAR(b.place.z - a.place.z, -3 * std::cos(angle), 1e-3);
}

/// Returns the distance to the water by small uniform steps.
double waterByEvenSteps(glsl::Lake& lake, const dvec3& o, const dvec3& d)
{
    for (double t = 0.01; t < 200; t += 0.004)
        if (o.y + d.y * t < lake.lakeAt({o.x + d.x * t, o.z + d.z * t}).height) return t;
    return -1;
}

TEST(LakeWater, IsMetWhereItIsByItsBounds)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().waveHeight, 3.0);
    glsl::Lake lake = lakeAtFloat64(values, 2);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-30, 30), down(-0.6, -0.03);
    int met = 0, control = 0;
    for (int i = 0; i < 400; ++i) {
        const dvec3 o(place(random), 2.5, place(random));
        const dvec3 d = glm::normalize(dvec3(place(random), 30 * down(random), place(random)));
        const double truth = waterByEvenSteps(lake, o, d);
        if (truth < 0) continue;
        ++met;
        EXPECT_NEAR(lake.waterDistance(o, d, 0, 1000, 1e-5, 0.5, 256), truth, 0.02);
        // The same number of uniform steps over the same distance, with bisection in the first step that ends below:
        // crests are missed.
        const auto above = [&](double t) { return o.y + d.y * t > lake.lakeAt({o.x + d.x * t, o.z + d.z * t}).height; };
        double low = 0;
        while (low < 1000 && above(low + 1000.0 / 256)) low += 1000.0 / 256;
        double high = low + 1000.0 / 256;
        for (int half = 0; half < 40; ++half) (above((low + high) / 2) ? low : high) = (low + high) / 2;
        control += std::abs(low - truth) > 0.02;
    }
    EXPECT_GT(met, 300);
    EXPECT_GT(control, 3);
}

TEST(LakeWater, MirrorsByFresnelsLaw)
{
    EXPECT_NEAR(glsl::fresnelDielectric(1, 1.333), std::pow(0.333 / 2.333, 2), 1e-9);
    // At Brewster's angle only perpendicularly polarized light is reflected.
    const double brewster = std::atan(1.333), refracted = std::asin(std::sin(brewster) / 1.333);
    const double across = std::pow(std::sin(brewster - refracted) / std::sin(brewster + refracted), 2);
    EXPECT_NEAR(glsl::fresnelDielectric(std::cos(brewster), 1.333), 0.5 * across, 1e-9);
    EXPECT_NEAR(glsl::fresnelDielectric(0, 1.333), 1, 1e-9);
}

TEST(LakeScene, IsFiniteAndWithinItsPeriodsAtAnyTime)
{
    for (const double seconds : {0.0, -3.7, 1e6, -1e6, 1e12}) {
        ParameterValues values = sourceLake();
        values.set(lanternsTable().drift, 0.3);
        const LakeBlock b = lakeBlock(lanternsTable(), values, seconds, {5, seconds - 5});
        EXPECT_GE(b.flickerTime, 0);
        EXPECT_LE(b.flickerTime, 4);
        for (int i = 0; i < b.waves; ++i) {
            EXPECT_GE(b.wave[static_cast<std::size_t>(i)].w, 0);
            EXPECT_LT(b.wave[static_cast<std::size_t>(i)].w, 6.2832F);
        }
        EXPECT_LT(glm::length(b.corner), 100) << seconds;
        EXPECT_LT(glm::length(glm::vec3(b.released)), 100);
    }
    // Sixty times a second something has moved, also after a million seconds.
    float last = -1;
    int moved = 0;
    for (int i = 0; i < 60; ++i) {
        const LakeBlock b = lakeBlock(lanternsTable(), sourceLake(), 1e6 + i / 60.0);
        moved += b.wave[0].w != last;
        last = b.wave[0].w;
    }
    EXPECT_EQ(moved, 60);
}

}  // namespace
}  // namespace vitrine::paper_lanterns
