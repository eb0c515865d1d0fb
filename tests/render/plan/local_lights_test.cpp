// Local lights: radiation in closed form, positions in shadow maps, and the choice of lights.

#include "render/glsl/cpu.h"
#include "render/plan/local_lights.h"
#include "render/scene/cube_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace vitrine {
namespace {

using render::localLighting;
using std::numbers::pi;
using LocalLightEntryInBlock = render::LocalLightEntry;

glsl::LocalLightEntry lightAt(const glm::dvec3& position, double radius = 0, double range = 0)
{
    return {position, radius, glm::dvec3(2, 3, 5), range, false, 0, 0, glm::dvec3(0), 0, 0};
}

TEST(LocalLight, NearerThanItsLimitIsAsBrightAsAtTheLimit)
{
    for (const double radius : {0.0, 0.2}) {
        glsl::LocalLightEntry light = lightAt({0, 0, 0}, radius);
        const glm::dvec3 far = glsl::localIrradiance(light, {0, -3, 0}, {0, 1, 0});
        const glm::dvec3 near = glsl::localIrradiance(light, {0, -0.5, 0}, {0, 1, 0});
        EXPECT_GT(near.x, 2 / (1.5 * 1.5));
        light.nearest = 1.5;
        EXPECT_EQ(glsl::localIrradiance(light, {0, -3, 0}, {0, 1, 0}), far);
        EXPECT_NEAR(glsl::localIrradiance(light, {0, -0.5, 0}, {0, 1, 0}).x, 2 / (1.5 * 1.5), 1e-12);
    }
}

// All light sent downward by a point reaches the plane below it: half of 4 pi I.
TEST(LocalLight, AsAPointSendsHalfOfItsFluxOntoAPlane)
{
    const glsl::LocalLightEntry light = lightAt({0, 1.7, 0});
    double flux = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        // Rings by their angle from the downward direction: radius z tan(a).
        const double angle = 0.5 * pi * (i + 0.5) / steps;
        const double radius = 1.7 * std::tan(angle);
        const double ring = 2 * pi * radius * 1.7 / (std::cos(angle) * std::cos(angle)) * 0.5 * pi / steps;
        flux += glsl::localIrradiance(light, {radius, 0, 0}, {0, 1, 0}).x * ring;
    }
    EXPECT_NEAR(flux, 2 * pi * 2, 1e-6);
    EXPECT_EQ(glsl::localIrradiance(light, {0, 3, 0}, {0, 1, 0}), glm::dvec3(0)) << "from below";
    EXPECT_EQ(glsl::localIrradiance(light, {0, 1.7, 0}, {0, 1, 0}), glm::dvec3(0)) << "at the point itself";
}

TEST(LocalLight, InAConeSendsAllWithinItAndNothingBeyond)
{
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -1, 0.2));
    const std::vector<render::LocalLight> lights{
        {.position = {0, 2, 0}, .intensity = {2, 3, 5}, .axis = axis, .coneInner = 0.3, .coneOuter = 0.7}};
    const LocalLightEntryInBlock entry = localLighting(lights, {0, 0, 0}, 5).block.lights[0];
    glsl::LocalLightEntry cone = lightAt({0, 2, 0});
    cone.axis = glm::dvec3(entry.axis);
    cone.coneCosine = static_cast<double>(entry.coneCosine);
    cone.coneScale = static_cast<double>(entry.coneScale);
    const glm::dvec3 across = glm::normalize(glm::cross(axis, glm::dvec3(0, 0, 1)));
    double before = 1e9;
    for (double angle = 0; angle < pi; angle += 0.01) {
        const glm::dvec3 way = std::cos(angle) * axis + std::sin(angle) * across;
        const double sent = glsl::localIrradiance(cone, glm::dvec3(0, 2, 0) + way, -way).x;
        if (angle < 0.299) {
            EXPECT_NEAR(sent, 2, 1e-6) << angle;
        } else if (angle > 0.701) {
            EXPECT_EQ(sent, 0) << angle;
        }
        EXPECT_LE(sent, before + 1e-9) << angle;
        if (angle > 0.1) {
            EXPECT_LT(before - sent, 0.15) << angle;
        }
        before = sent;
    }
}

/// The same by quadrature over the directions of the sphere.
double formFactorByQuadrature(double cosine, double distance, double radius)
{
    const double half = std::asin(radius / distance);
    const double tilt = std::acos(cosine);
    const int across = 600;
    const int around = 600;
    double sum = 0;
    for (int i = 0; i < across; ++i) {
        const double t = half * (i + 0.5) / across;
        for (int j = 0; j < around; ++j) {
            const double phi = 2 * pi * (j + 0.5) / around;
            sum += std::max(std::cos(t) * std::cos(tilt) + std::sin(t) * std::cos(phi) * std::sin(tilt), 0.0) *
                   std::sin(t);
        }
    }
    return sum * (half / across) * (2 * pi / around) / pi;
}

TEST(LocalLight, AsASphereSendsWhatQuadratureSays)
{
    for (const double distance : {1.05, 1.5, 4.0})
        for (const double cosine : {1.0, 0.8, 0.4, 0.1, 0.0, -0.1, -0.4, -0.8, -1.0})
            EXPECT_NEAR(glsl::sphereFormFactor(cosine, 0.3 * distance, 0.3),
                        formFactorByQuadrature(cosine, distance, 1), 3e-5)
                << distance << ' ' << cosine;
    EXPECT_EQ(glsl::sphereFormFactor(-1, 0.2, 0.3), 1) << "inside it is light all around";
}

TEST(LocalLight, ThatIsASmallSphereIsAPoint)
{
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, -0.2));
    const glm::dvec3 point = glsl::localIrradiance(lightAt({0.5, 2, 1}), {0, 0, 0}, normal);
    const double distance = glm::length(glm::dvec3(0.5, 2, 1));
    // The whole sphere is above the horizon, so that both are I cos / d².
    EXPECT_LT(glm::distance(glsl::localIrradiance(lightAt({0.5, 2, 1}, 2e-3 * distance), {0, 0, 0}, normal), point),
              1e-12);
    EXPECT_LT(glm::distance(glsl::localIrradiance(lightAt({0.5, 2, 1}, 0.5), {0, 0, 0}, normal), point), 1e-12);
}

TEST(LocalLight, EndsAtItsRangeWithoutAnEdge)
{
    EXPECT_EQ(glsl::localWindow(5, 5), 0);
    EXPECT_EQ(glsl::localWindow(6, 5), 0);
    EXPECT_EQ(glsl::localWindow(6, 0), 1);
    EXPECT_EQ(glsl::localWindow(0, 5), 1);
    EXPECT_NEAR(glsl::localWindow(2.5, 5), (1 - 1.0 / 16) * (1 - 1.0 / 16), 1e-15);
    EXPECT_LT(glsl::localWindow(5 - 1e-4, 5), 1e-8) << "slope 0 at the end";
    EXPECT_EQ(glsl::localIrradiance(lightAt({0, 2, 0}, 0, 1.9), {0, 0, 0}, {0, 1, 0}), glm::dvec3(0));
}

TEST(LocalLight, FindsItsShadowWhereTheMapsAreDrawn)
{
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    const glm::dvec3 eye(0.4, 1.3, -2);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 fromLight(number(random), number(random), number(random));
        const int face = glsl::localShadowFace(fromLight);
        const render::View view = render::cubeFaceView(eye, face, 64, render::localShadowNear);
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(eye + fromLight, 1);
        ASSERT_GT(clip.w, 0);
        const glm::dvec3 seen(glm::dvec2(clip) / clip.w * 0.5 + 0.5, clip.z / clip.w);
        EXPECT_LT(glm::distance(glsl::localShadowPosition(fromLight, render::localShadowNear), seen), 1e-12);
        EXPECT_LE(std::max(std::abs(seen.x - 0.5), std::abs(seen.y - 0.5)), 0.5 + 1e-12);
    }
}

TEST(LocalLights, AreTheStrongestWhereOneLooks)
{
    std::vector<render::LocalLight> lights;
    for (int i = 0; i < 100; ++i) lights.push_back({.position = {1.0 + 0.1 * i, 0, 0}, .castsShadow = i % 2 == 0});
    lights.push_back({.position = {0.5, 0, 0}, .intensity = {0, 0, 0}});
    lights.push_back({.position = {0, 50, 0}, .intensity = glm::dvec3(1e6), .range = 30, .castsShadow = true});
    const render::LocalLighting near = localLighting(lights, {0, 0, 0}, 2);
    ASSERT_EQ(near.chosen.size(), render::mostLocalLights);
    for (std::size_t i = 0; i < near.chosen.size(); ++i) EXPECT_EQ(near.chosen[i], i) << "nearest first";
    EXPECT_EQ(near.shadowed, (std::vector<std::size_t>{0, 2, 4, 6}));
    EXPECT_TRUE(near.block.lights[2].castsShadow);
    EXPECT_EQ(near.block.lights[2].firstLayer, 6);
    EXPECT_FALSE(near.block.lights[1].castsShadow);
    EXPECT_FALSE(near.block.lights[8].castsShadow) << "no map is left";
    EXPECT_EQ(near.block.count, 32);
    const render::LocalLighting high = localLighting(lights, {0, 25, 0}, 2);
    EXPECT_EQ(high.chosen.front(), 101U) << "within its range it is the strongest by far";
    EXPECT_TRUE(localLighting({}, {0, 0, 0}, 2).chosen.empty());
}

}  // namespace
}  // namespace vitrine
