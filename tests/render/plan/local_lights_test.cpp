// Local lights: radiation in closed form, positions in shadow maps, and the choice of lights.

#include "render/glsl/cpu.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"
#include "render/scene/cube_views.h"
#include "shaders/lib/bindings.glsl"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

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

/// Returns random lights in a room of 12 m by 8 m by 24 m: some have no range, some a cone, up to nearly a sphere.
render::LocalLighting randomLights(std::mt19937& random)
{
    std::uniform_real_distribution<double> share;
    std::normal_distribution<double> number;
    std::vector<render::LocalLight> lights(render::mostLocalLights);
    for (render::LocalLight& light : lights) {
        light.position = glm::dvec3(12 * share(random) - 6, 8 * share(random), 24 * share(random) - 12);
        light.range = share(random) < 0.3 ? 0 : 6 * share(random);
        if (share(random) < 0.3) continue;
        light.axis = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        light.coneInner = 1.5 * share(random);
        light.coneOuter = light.coneInner + 0.02 + (pi - 0.05 - light.coneInner) * std::pow(share(random), 3);
    }
    return localLighting(lights, {0, 4, 0}, 100);
}

glsl::LocalLightEntry entryOf(const render::LocalLightEntry& light)
{
    glsl::LocalLightEntry entry = lightAt(light.position, 0, light.range);
    entry.axis = light.axis;
    entry.coneCosine = light.coneCosine;
    entry.coneScale = light.coneScale;
    return entry;
}

// The lights that are left out reach no place that the pass may shade, in a box, in view, or both.
TEST(LocalLights, ThatAreLeftOutReachNoPlace)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share;
    const auto placeIn = [&](const render::Box& box) {
        return box.low + (box.high - box.low) * glm::dvec3(share(random), share(random), share(random));
    };
    const render::Box room{{-6, 0, -12}, {6, 8, 12}};
    int left = 0, kept = 0, needed = 0;
    for (int round = 0; round < 300; ++round) {
        const render::LocalLighting all = randomLights(random);
        const render::View view =
            render::makeView({placeIn(room), placeIn(room), 0.3 + share(random)}, {.size = {160, 90}});
        const glm::dvec3 a = placeIn(room), b = placeIn(room);
        const bool isSmall = round % 3 == 0;
        const render::Box box = isSmall ? render::Box{glm::min(a, b), glm::max(a, b)} : room;
        const render::LocalLightsBlock some = render::reachingLights(all.block, {box, round % 3 != 0}, view);
        std::vector<glm::dvec3> places;
        while (places.size() < 400) {
            const glm::dvec3 place = placeIn(box);
            const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(place, 1);
            const bool isSeen = clip.w > 0 && std::max(std::abs(clip.x), std::abs(clip.y)) <= clip.w;
            if (isSmall || isSeen) places.push_back(place);
            if (clip.w <= 0 && share(random) < 1e-3) break;
        }
        int next = 0;
        for (int i = 0; i < all.block.count; ++i) {
            const render::LocalLightEntry& light = all.block.lights[static_cast<std::size_t>(i)];
            const bool isKept =
                next < some.count && some.lights[static_cast<std::size_t>(next)].position == light.position;
            next += isKept;
            (isKept ? kept : left) += 1;
            bool reaches = false;
            for (const glm::dvec3& place : places) reaches = reaches || glsl::localReaches(entryOf(light), place);
            needed += reaches;
            ASSERT_TRUE(isKept || !reaches) << round << ": light " << i;
        }
        EXPECT_EQ(next, some.count) << "in their order";
    }
    // Few of those that are kept reach no place.
    EXPECT_GT(left, kept / 2);
    EXPECT_GT(needed, 3 * kept / 4);
}

/// The lights that shaders/lib/local_lights.glsl finds near a place, as bits.
std::uint32_t lightsNear(const render::LocalLightsBlock& block, const glm::dvec3& place)
{
    const glm::vec3 last(LIGHT_CELLS_X - 1, LIGHT_CELLS_Y - 1, LIGHT_CELLS_Z - 1);
    const glm::ivec3 at(glm::clamp((glm::vec3(place) - block.cellsLow) * block.cellsPerMeter, glm::vec3(0), last));
    const int cell = (at.z * LIGHT_CELLS_Y + at.y) * LIGHT_CELLS_X + at.x;
    return static_cast<std::uint32_t>(block.cells[static_cast<std::size_t>(cell / 4)][cell % 4]);
}

TEST(LocalLights, OfACellAreThoseThatMayReachIt)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> share;
    const render::Box room{{-6, 0, -12}, {6, 8, 12}};
    int kept = 0, needed = 0, all = 0;
    for (int round = 0; round < 100; ++round) {
        render::LocalLightsBlock block = randomLights(random).block;
        divideIntoCells(block, room);
        const render::LocalLightsBlock some =
            render::reachingLights(block, {render::Box{{-6, 0, -12}, {6, 3, 0}}, false}, {});
        for (int i = 0; i < 400; ++i) {
            // At the faces of the room, too.
            const glm::dvec3 relative = glm::clamp(glm::dvec3(share(random), share(random), share(random)) * 1.1 - 0.05,
                                                   glm::dvec3(0), glm::dvec3(1));
            const bool isLow = i % 2 == 0;
            const glm::dvec3 place = room.low + relative * (isLow ? glm::dvec3(12, 3, 12) : room.high - room.low);
            const render::LocalLightsBlock& lights = isLow ? some : block;
            const std::uint32_t near = lightsNear(lights, place);
            for (int light = 0; light < lights.count; ++light) {
                const bool isNear = (near >> light & 1U) != 0;
                const bool reaches = glsl::localReaches(entryOf(lights.lights[static_cast<std::size_t>(light)]), place);
                ASSERT_TRUE(isNear || !reaches) << round << ": light " << light;
                kept += isNear;
                needed += reaches;
                ++all;
            }
            ASSERT_EQ(lights.count < 32 ? near >> lights.count : 0, 0U) << "bits of no light";
        }
    }
    EXPECT_LT(kept, all / 2);
    EXPECT_GT(needed, kept / 2);
}

TEST(LocalLights, AreInOneCellWhereAPassMayShadeOutsideTheGrid)
{
    std::mt19937 random(10);
    render::LocalLightsBlock block = randomLights(random).block;
    divideIntoCells(block, {{-6, 0, -12}, {6, 8, 12}});
    for (const std::optional<render::Box>& within :
         {std::optional<render::Box>(), std::optional(render::Box{{-6, 0, -12}, {6, 9, 12}})}) {
        const render::LocalLightsBlock lights = render::reachingLights(block, {within, false}, {});
        EXPECT_EQ(lights.cellsPerMeter, glm::vec3(0));
        EXPECT_EQ(lightsNear(lights, {100, 0, 0}), lights.count < 32 ? (1U << lights.count) - 1 : ~0U);
    }
}

TEST(LocalLights, AreAllKeptWhereAPassMayShadeAnything)
{
    std::mt19937 random(8);
    const render::LocalLighting all = randomLights(random);
    EXPECT_EQ(render::reachingLights(all.block, {}, {}).count, all.block.count);
    EXPECT_EQ(render::reachingLights(all.block, {render::Box{}, false}, {}).count, 0) << "an empty box";
}

TEST(LocalLights, OfAPassAreThoseThatReachItUnlessEverythingRuns)
{
    const std::vector<render::LocalLight> lights{{.position = {0, 1, 0}, .range = 2},
                                                 {.position = {9, 1, 0}, .range = 2}};
    for (const bool everything : {false, true}) {
        render::FramePlan plan;
        plan.runEverything = everything;
        render::Pass pass;
        pass.name = "lit";
        pass.localLights = std::make_shared<render::LocalLightsBlock>(localLighting(lights, {0, 0, 0}, 20).block);
        pass.shaded.within = render::Box{glm::dvec3(-1), glm::dvec3(1)};
        plan.add(pass);
        EXPECT_EQ(plan.passes().front().counts.at("localLights"), everything ? 2 : 1);
        pass.localLights =
            std::make_shared<render::LocalLightsBlock>(localLighting({lights.data(), 1}, {0, 0, 0}, 20).block);
        if (!everything) {
            EXPECT_EQ(plan.passes().front().blocks.at(BLOCK_LOCAL_LIGHTS), render::std140Bytes(*pass.localLights));
        }
    }
}

}  // namespace
}  // namespace vitrine
