// Clear sky at all heights of the sun: its colors, its light, and gradual changes.
#include "exhibits/hall/sun.h"
#include "exhibits/kit/clear_sky.h"
#include "exhibits/kit/sky_view.h"
#include "tests/support/degree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine::hall {
namespace {

using test::degree;

double luminanceOf(const glm::dvec3& color)
{
    return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
}

TEST(ClearSky, IsBlueAtNoonAndRedWhereTheSunSets)
{
    const glm::dvec3 noon = clearSkyRadiance(42 * degree, 80 * degree, 0);
    EXPECT_GT(noon.z, 1.8 * noon.x);
    const glm::dvec3 below = clearSkyRadiance(0, 3 * degree, 0.3);
    EXPECT_GT(below.x, 3 * below.z);
    // The opposite side is darker, and the zenith stays bluer.
    EXPECT_LT(luminanceOf(clearSkyRadiance(0, 3 * degree, std::numbers::pi)), 0.5 * luminanceOf(below));
    const glm::dvec3 zenith = clearSkyRadiance(0, 90 * degree, 0);
    EXPECT_GT(zenith.z / zenith.x, 3 * below.z / below.x);
}

TEST(ClearSky, ScattersNoMoreThanTheSunBrings)
{
    // Irradiance of the whole sky on the ground, summed by elevation and azimuth.
    for (const double sun : {80.0, 42.0, 19.0, 5.0}) {
        glm::dvec3 sum(0);
        constexpr int rings = 18, around = 16;
        for (int i = 0; i < rings; ++i)
            for (int k = 0; k < around; ++k) {
                const double up = (i + 0.5) / rings * std::numbers::pi / 2;
                const double fromSun = (k + 0.5) / around * std::numbers::pi;
                sum += clearSkyRadiance(sun * degree, up, fromSun) * (std::sin(up) * std::cos(up));
            }
        sum *= (std::numbers::pi / 2 / rings) * (2 * std::numbers::pi / around);
        // A clear sky sends between a tenth and a half of the light that reaches the atmosphere.
        const double falls = std::sin(sun * degree);
        EXPECT_GT(luminanceOf(sum), 0.05 * falls) << sun;
        EXPECT_LT(sum.z, 0.55 * falls) << sun;
    }
}

TEST(ClearSky, IsFiniteInEveryDirectionAndGoneByNight)
{
    for (const double sun : {-90.0, -30.0, -5.0, 0.0, 0.01, 45.0, 90.0})
        for (const double up : {-90.0, -10.0, 0.0, 1.0, 89.9, 90.0})
            for (const double beside : {0.0, 1.0, 3.14159265358979}) {
                const glm::dvec3 color = clearSkyRadiance(sun * degree, up * degree, beside);
                for (int i = 0; i < 3; ++i) {
                    EXPECT_TRUE(std::isfinite(color[i])) << sun << ' ' << up << ' ' << beside;
                    EXPECT_GE(color[i], 0) << sun << ' ' << up << ' ' << beside;
                }
            }
    EXPECT_LT(luminanceOf(clearSkyRadiance(-20 * degree, 90 * degree, 0)), 1e-9);
}

TEST(ClearSky, ReddensTheSunAndLeavesItOnHighCloudsAfterSunset)
{
    double before = 0;
    for (const double sun : {45.0, 19.0, 9.0, 5.0, 2.0}) {
        const glm::dvec3 light = ClearSky(sun * degree).sunlight();
        EXPECT_GT(light.x / light.z, before) << sun;
        before = light.x / light.z;
    }
    EXPECT_EQ(ClearSky(-2 * degree).sunlight(), glm::dvec3(0));
    // Cirrus at 8 km sees the sun until it is 2.9 degrees below the horizon of the ground.
    EXPECT_GT(ClearSky(-2 * degree).sunlight(8).x, 0.01);
    EXPECT_EQ(ClearSky(-3.3 * degree).sunlight(8), glm::dvec3(0));
}

TEST(ClearSky, IsDarkerTowardsAHazySunAndFiniteInAnyHaze)
{
    EXPECT_LT(luminanceOf(ClearSky(5 * degree, 28).sunlight()), 0.5 * luminanceOf(ClearSky(5 * degree).sunlight()));
    for (const double haze : {0.0, 1e6, -1.0, std::nan("")})
        for (const double sun : {-90.0, 0.0, 90.0}) {
            const glm::dvec3 color = ClearSky(sun * degree, haze).radiance(0.1, 1);
            for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(color[i]) && color[i] >= 0) << haze << ' ' << sun;
        }
}

/// Returns the texel of a sky's table: `up` and `aside` from 0 to 1 as in shaders/lib/sky_view.glsl.
glm::dvec3 texelOf(const SkyView& sky, double aside, double up)
{
    const render::Texture& table = *sky.radiance;
    const auto at = [&](double share) { return static_cast<std::size_t>(std::lround(share * (table.width - 1))); };
    const std::size_t first = 3 * (at(up) * static_cast<std::size_t>(table.width) + at(aside));
    return {table.floats[first], table.floats[first + 1], table.floats[first + 2]};
}

TEST(SkyViews, HaveAPinkBeltOppositeTheSunAboveTheShadowOfTheEarth)
{
    const std::shared_ptr<const SkyView> dusk = skyView({.sunElevation = -2 * degree});
    const glm::dvec3 belt = texelOf(*dusk, 1, std::sqrt(std::sin(12 * degree)));
    EXPECT_GT(belt.x, 1.1 * belt.y);
    EXPECT_GT(belt.z, belt.y) << "pink, not orange";
    const glm::dvec3 shadow = texelOf(*dusk, 1, std::sqrt(std::sin(1 * degree)));
    EXPECT_LT(luminanceOf(shadow), luminanceOf(belt));
    const glm::dvec3 high = texelOf(*dusk, 0, 1);
    EXPECT_GT(high.z, high.x);
    const glm::dvec3 below = texelOf(*dusk, 0, std::sqrt(std::sin(2 * degree)));
    EXPECT_GT(below.x, 3 * below.z);
}

TEST(SkyViews, SumUpTheirTable)
{
    const std::shared_ptr<const SkyView> sky = skyView({.sunElevation = 30 * degree, .sun = glm::dvec3(2)});
    EXPECT_EQ(sky, skyView({.sunElevation = 30 * degree, .sun = glm::dvec3(2)})) << "kept";
    // The irradiance, by elevation and azimuth, from the same table read elsewhere.
    glm::dvec3 sum(0);
    constexpr int rings = 60, around = 60;
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < around; ++k) {
            const double up = (i + 0.5) / rings * std::numbers::pi / 2,
                         half = (k + 0.5) / around * std::numbers::pi / 2;
            sum += texelOf(*sky, std::sqrt(std::sin(half)), std::sqrt(std::sin(up))) * (std::sin(up) * std::cos(up));
        }
    sum *= (std::numbers::pi / 2 / rings) * (2 * std::numbers::pi / around) / std::numbers::pi;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(sky->above[i] / sum[i], 1, 0.06);
}

TEST(SkyTint, IsNoneAtTheReferenceAndFollowsTheSunLittleByLittle)
{
    const SkyTint still = skyTint(referenceSunElevation);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(still.zenith[i], 1, 1e-9);
        EXPECT_NEAR(still.horizon[i], 1, 1e-9);
    }
    double before = luminanceOf(skyTint(-12 * degree).zenith);
    for (double sun = -11.9; sun < 60; sun += 0.1) {
        const double now = luminanceOf(skyTint(sun * degree).zenith);
        EXPECT_GE(now, before) << sun;
        EXPECT_LT(now - before, 0.02) << sun;
        before = now;
    }
}

}  // namespace
}  // namespace vitrine::hall
