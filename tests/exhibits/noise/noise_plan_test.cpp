// Animations behind the noise frame, and the light in its clouds, without a GPU.

#include "exhibits/noise/noise_cpu.h"
#include "exhibits/noise/noise_scene.h"
#include "exhibits/noise/sea_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine::noise {
namespace {

using std::numbers::pi;

const NoiseTable& noiseTable()
{
    static const NoiseTable t;
    return t;
}

TEST(SeaWaves, RunAsDeepWaterDoesAndHoldTheSpectrumsEnergy)
{
    for (const double wind : {4.0, 7.5, 15.0}) {
        const std::vector<SeaWave> waves = seaWaves(wind, 0.4, 64, 1);
        ASSERT_EQ(waves.size(), 64U);
        double variance = 0;
        glm::dvec2 way(0);
        for (std::size_t i = 0; i < waves.size(); ++i) {
            const SeaWave& w = waves[i];
            EXPECT_NEAR(w.frequency * w.frequency, 9.81 * glm::length(w.vector), 1e-9 * w.frequency * w.frequency);
            if (i > 0) {
                EXPECT_GT(w.frequency, waves[i - 1].frequency);
            }
            variance += 0.5 * w.amplitude * w.amplitude;
            way += w.amplitude * w.amplitude * glm::normalize(w.vector);
        }
        // Closed-form integral of the Pierson-Moskowitz spectrum.
        const double u = 1.026 * wind;
        const double whole = 0.0081 * std::pow(u, 4) / (4 * 0.74 * 9.81 * 9.81);
        EXPECT_NEAR(variance / whole, 1, 0.15) << wind;
        EXPECT_GT(glm::dot(glm::normalize(way), glm::dvec2(std::sin(0.4), -std::cos(0.4))), 0.95);
    }
}

TEST(SeaWaves, StayFlatterThanTheSlopesThatPhotographsShow)
{
    for (const double wind : {2.0, 7.5, 14.0}) {
        double slopes = 0;
        for (const SeaWave& w : seaWaves(wind, 0, 64, 1))
            slopes += 0.5 * std::pow(w.amplitude * glm::length(w.vector), 2);
        EXPECT_LT(slopes, 1.3 * seaSlopes(wind)) << wind;
        EXPECT_GT(slopes, 0.05 * seaSlopes(wind)) << wind;
    }
}

NoiseBlock blockAt(const ParameterValues& values, double seconds)
{
    return noiseBlock(noiseTable(), values, seconds, {0, 1, 0}, 0);
}

TEST(NoiseScene, IsFiniteAndWithinItsPeriodsAtAnyTime)
{
    ParameterValues values(noiseTable());
    values.set(noiseTable().work, NoiseWork::fractal);
    for (const double seconds : {0.0, -3.7, 1e6, -1e6, 1e12}) {
        const NoiseBlock b = blockAt(values, seconds);
        for (const glm::vec4& place : b.places)
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(place[i], 0) << seconds;
                EXPECT_LT(place[i], 1) << seconds;
            }
        for (int i = 0; i < b.waves; ++i) {
            EXPECT_GE(b.wave[static_cast<std::size_t>(i)].w, 0);
            EXPECT_LT(b.wave[static_cast<std::size_t>(i)].w, 6.2832F);
        }
        EXPECT_GE(b.foamTime, 0);
        EXPECT_LE(b.foamTime, NOISE_PERIOD);
        for (int i = 0; i < 3; ++i) {
            EXPECT_GE(b.cloudShift[i], 0);
            EXPECT_LE(b.cloudShift[i], CLOUD_REPEAT);
        }
    }
}

TEST(NoiseScene, MovesSixtyTimesASecondAfterAMillionSeconds)
{
    ParameterValues values(noiseTable());
    values.set(noiseTable().work, NoiseWork::field);
    float last = -1;
    int steps = 0;
    for (int i = 0; i < 60; ++i) {
        const NoiseBlock b = blockAt(values, 1e6 + i / 60.0);
        steps += b.places[0].z != last;
        last = b.places[0].z;
    }
    EXPECT_EQ(steps, 60);
}

TEST(NoiseScene, KeepsTheHallsLengthsBehindTheFrameExceptForTheClouds)
{
    ParameterValues values(noiseTable());
    for (const NoiseWork work : {NoiseWork::field, NoiseWork::fractal, NoiseWork::sea}) {
        values.set(noiseTable().work, work);
        EXPECT_NEAR(glm::length(glm::dvec3(noisePortal(noiseTable(), values).workFromExhibit[0])), 1, 1e-12);
    }
    values.set(noiseTable().work, NoiseWork::clouds);
    EXPECT_NEAR(glm::length(glm::dvec3(noisePortal(noiseTable(), values).workFromExhibit[0])), 40, 1e-12);
}

/// Returns the light that leaves a slab of optical depth `depth` with `source` everywhere, and light from behind, in
/// `steps` steps.
double through(double source, double depth, double behind, int steps)
{
    double sum = 0, left = 1;
    for (int i = 0; i < steps; ++i) {
        sum += left * glsl::cloudAdded(source, depth / steps);
        left *= glsl::cloudThrough(depth / steps);
    }
    return sum + left * behind;
}

TEST(CloudMedium, IsInvisibleInAnEvenLightThatItSwallowsNothingOf)
{
    for (const double depth : {0.01, 1.0, 30.0})
        for (int steps = 1; steps <= 256; ++steps) EXPECT_NEAR(through(0.7, depth, 0.7, steps), 0.7, 1e-12);
}

TEST(CloudMedium, OfAnEvenSlabIsItsClosedFormForAnyNumberOfSteps)
{
    for (const double depth : {0.1, 2.0, 20.0}) {
        const double exact = 3 * (1 - std::exp(-depth)) + 0.5 * std::exp(-depth);
        for (const int steps : {1, 2, 7, 64, 256}) EXPECT_NEAR(through(3, depth, 0.5, steps), exact, 1e-12);
        // Control: the plain sum, S T dx, depends on the steps.
        double sum = 0, left = 1;
        for (int i = 0; i < 4; ++i) {
            sum += left * 3 * depth / 4;
            left *= std::exp(-depth / 4);
        }
        if (depth >= 2) {
            EXPECT_GT(sum + left * 0.5, 1.2 * exact);
        }
    }
}

TEST(CloudMedium, ScattersAllOfTheLightSomewhere)
{
    for (const double forward : {0.0, 0.5, 0.78, 0.95})
        for (const double backward : {0.0, 0.3, 1.0}) {
            double sum = 0;
            constexpr int steps = 200000;
            for (int i = 0; i < steps; ++i)
                sum += glsl::cloudPhase(-1 + (i + 0.5) * 2 / steps, forward, backward) * 2 / steps;
            EXPECT_NEAR(2 * pi * sum, 1, 1e-3) << forward << ' ' << backward;
        }
}

TEST(CloudMedium, OfLessThanNoDensityDoesNotGlow)
{
    double last = 1;
    for (double depth = -50; depth < 50; depth += 0.25) {
        const double now = glsl::cloudThrough(depth);
        EXPECT_LE(now, last);
        EXPECT_GE(now, 0);
        EXPECT_GE(glsl::cloudAdded(1, depth), 0);
        last = now;
    }
}

TEST(CloudMedium, IsBrighterWithEveryOrderAndBrightestTowardsTheSun)
{
    double last = 0;
    for (int orders = 1; orders <= 8; ++orders) {
        const double now = glsl::cloudSunlight(0.2, 3, 0.78, 0.3, orders);
        EXPECT_GT(now, last);
        last = now;
    }
    EXPECT_GT(glsl::cloudSunlight(1, 0.1, 0.78, 0.3, 4), 10 * glsl::cloudSunlight(0, 0.1, 0.78, 0.3, 4));
}

}  // namespace
}  // namespace vitrine::noise
