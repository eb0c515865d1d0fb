// The sunbeams' part of a plan: added passes, skipped passes with reasons, and the sun's position in a picture.

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/rays_scene.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "exhibits/hall/sun.h"
#include "tests/support/block_of.h"
#include "tests/support/degree.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace vitrine::crepuscular_rays {
namespace {

using glm::dvec2;
using glm::dvec3;
using hall::HallTable;
using hall::skyByHour;
using hall::Sun;
using hall::sunAtHour;
using hall::SunBy;
using hall::sunOf;
using namespace test;

/// Scene that looks along the hall at the window.
Scene atTheWindow(RayTechnique technique = RayTechnique::both)
{
    Scene scene;
    scene.see({0, 1.65, -2}, {0, 3.5, -12});
    scene.rays().set(raysTable().technique, technique);
    return scene;
}

const char* const screenPasses[] = {"crepuscular_rays/mask", "crepuscular_rays/rays"};

void expectNothingOfTheScreen(const Scene& scene, const char* why)
{
    const render::FramePlan plan = scene.plan();
    for (const char* pass : screenPasses) EXPECT_EQ(reasonFor(plan, pass), why);
    for (const char* pass :
         {"crepuscular_rays/loop", "crepuscular_rays/taps", "crepuscular_rays/polar", "crepuscular_rays/occluders"})
        EXPECT_FALSE(runs(plan, pass)) << pass;
}

/// Expects no pass, no used image and no program of the exhibit.
void expectNothingAtAll(const render::FramePlan& plan)
{
    EXPECT_FALSE(runs(plan, "crepuscular_rays/"));
    for (const render::Pass& pass : plan.passes()) {
        const std::vector<std::string> inputs = render::inputsOf(pass);
        for (const std::string& image : inputs)
            EXPECT_EQ(image.rfind("crepuscular_rays", 0), std::string::npos) << pass.name;
        EXPECT_EQ(pass.shader.fragment.rfind("crepuscular_rays/", 0), std::string::npos);
    }
}

TEST(RaysPlan, RunsWhatTheTechniqueNeedsAndNothingElse)
{
    EXPECT_TRUE(runs(atTheWindow(RayTechnique::both).plan(), "crepuscular_rays/march"));
    EXPECT_TRUE(runs(atTheWindow(RayTechnique::both).plan(), "crepuscular_rays/polar"));
    EXPECT_EQ(reasonFor(atTheWindow(RayTechnique::screen).plan(), "crepuscular_rays/march"),
              "the selected technique does not make them");
    expectNothingOfTheScreen(atTheWindow(RayTechnique::volume), "the selected technique does not make them");
    expectNothingAtAll(atTheWindow(RayTechnique::none).plan());
    EXPECT_EQ(reasonFor(atTheWindow(RayTechnique::none).plan(), "crepuscular_rays/composite"),
              "the selected technique does not make them");
}

TEST(RaysPlan, EveryMethodGathersByItsOwnPassesAndCountsItsLooks)
{
    Scene scene = atTheWindow(RayTechnique::screen);
    scene.rays().set(raysTable().samples, 216);
    scene.rays().set(raysTable().resolution, RayResolution::full);
    const auto looks = [&](RayMethod method, const char* start) {
        scene.rays().set(raysTable().method, method);
        std::int64_t sum = 0;
        const render::FramePlan plan = scene.plan();
        for (const render::Pass& pass : plan.passes())
            if (pass.name.rfind(start, 0) == 0) sum += pass.counts.at("fetches");
        return sum;
    };
    EXPECT_EQ(looks(RayMethod::loop, "crepuscular_rays/loop"), 64 * 36 * 216);
    EXPECT_EQ(looks(RayMethod::threePasses, "crepuscular_rays/taps"), 64 * 36 * 18);
    EXPECT_EQ(looks(RayMethod::polar, "crepuscular_rays/polar"), 864 * 864);
}

TEST(RaysPlan, NothingToSeeAddsNoPassAndSaysWhy)
{
    Scene weightless = atTheWindow();
    weightless.rays().set(raysTable().weight, 0.0);
    expectNothingOfTheScreen(weightless, "the weight of the rays is 0");
    Scene black = atTheWindow();
    black.rays().set(raysTable().tint, ColorValue{dvec3(0)});
    expectNothingOfTheScreen(black, "the tint of the rays is black");
    Scene clear = atTheWindow();
    clear.rays().set(raysTable().airDensity, 0.0);
    EXPECT_EQ(reasonFor(clear.plan(), "crepuscular_rays/march"), "the air is clear");
    Scene dark = atTheWindow();
    dark.hall().set(test::hallTable().sunStrength, 0.0);
    EXPECT_EQ(reasonFor(dark.plan(), "crepuscular_rays/march"), "the sun's strength is 0");
    expectNothingOfTheScreen(dark, "the sun's strength is 0");
    EXPECT_EQ(reasonFor(dark.plan(), "crepuscular_rays/composite"), "it ran") << "dust is there without a sun, too";
    dark.rays().set(raysTable().airDensity, 0.0);
    EXPECT_EQ(reasonFor(dark.plan(), "crepuscular_rays/haze"), "the air is clear");
    expectNothingAtAll(dark.plan());

    Scene away = atTheWindow();
    away.see({0, 1.65, 8}, {0, 1.65, 20});
    expectNothingOfTheScreen(away, "the sun is not in front of the camera");
    EXPECT_EQ(reasonFor(away.plan(), "crepuscular_rays/march"), "the beams are out of view");
    away.rays().set(raysTable().airDensity, 0.0);
    expectNothingAtAll(away.plan());

    // At the left wall, with the sun still in front: neither window nor oculus is in the picture.
    Scene wall = atTheWindow();
    wall.see({-3, 1.65, -6}, {-12, 1.0, -10});
    wall.rays().set(raysTable().edgeFade, 8.0);
    expectNothingOfTheScreen(wall, "no sky is in view");
    wall.rays().set(raysTable().edgeFade, 0.01);
    expectNothingOfTheScreen(wall, "the sun is too far beyond the picture's edge");

    Scene alone = atTheWindow();
    alone.request.alone = *test::museum().find("crepuscular_rays");
    alone.sceneState.hall().set(test::hallTable().sunAzimuth, 3.0);
    EXPECT_EQ(reasonFor(alone.plan(), "crepuscular_rays/march"),
              "no sunbeam wider than 30 cm comes in through the window");
}

TEST(RaysPlan, TheMaskAndTheLightAloneAreShownHoweverDarkTheyAre)
{
    // Without light, the view "rays only" is black and must not show the hall.
    Scene mask = atTheWindow();
    mask.rays().set(raysTable().view, RayView::mask);
    mask.rays().set(raysTable().weight, 0.0);
    EXPECT_EQ(reasonFor(mask.plan(), "crepuscular_rays/composite"), "it ran");
    Scene light = atTheWindow();
    light.rays().set(raysTable().view, RayView::light);
    light.hall().set(test::hallTable().sunStrength, 0.0);
    EXPECT_EQ(reasonFor(light.plan(), "crepuscular_rays/composite"), "it ran");
    light.see({0, 1.65, 8}, {0, 1.65, 20});
    EXPECT_EQ(reasonFor(light.plan(), "crepuscular_rays/mask"), "the sun is not in front of the camera");
    EXPECT_EQ(reasonFor(light.plan(), "crepuscular_rays/composite"), "it ran");
}

TEST(RaysPlan, AloneTheWindowShinesWithoutItsHall)
{
    Scene alone = atTheWindow(RayTechnique::volume);
    const std::size_t rays = *test::museum().find("crepuscular_rays");
    alone.request.alone = rays;
    alone.see(test::museum().subject(rays).bestView(alone.rays()));
    const render::FramePlan plan = alone.plan();
    EXPECT_TRUE(plan.find("crepuscular_rays/march"));
    // Beam of the hall's window, in the exhibit's own space.
    const BeamBlock own = test::blockOf<RaysBlock>(plan.find("crepuscular_rays/march")->draws[0].object).beams[0];
    Scene hall = atTheWindow(RayTechnique::volume);
    const render::FramePlan inHall = hall.plan();
    const BeamBlock there = test::blockOf<RaysBlock>(inHall.find("crepuscular_rays/march")->draws[0].object).beams[0];
    const glm::vec3 place(test::museum().worldFromExhibit(rays)[3]);
    EXPECT_LT(glm::length(own.openingLow + place - there.openingLow), 1e-5F);
    EXPECT_LT(glm::length(own.openingHigh + place - there.openingHigh), 1e-5F);
    EXPECT_LT(glm::length(own.airHigh + place - there.airHigh), 1e-4F);
}

TEST(RaysPlan, OccludersAreWhateverHidesTheSkyAndNothingElseIsDrawnAgain)
{
    Scene scene = atTheWindow(RayTechnique::screen);
    scene.see({0, 1.3, 3.5}, {0, 2.0, -12});
    scene.rays().set(raysTable().mask, RayMask::occluders);
    const render::FramePlan plan = scene.plan();
    const render::Pass* marched = plan.find("crepuscular_rays/occluders/sdf_morph/march");
    ASSERT_TRUE(marched);
    EXPECT_TRUE(marched->colors.empty());
    EXPECT_EQ(marched->depth->image, "crepuscular_rays/occluders.depth");
    EXPECT_NE(std::find(marched->shader.defines.begin(), marched->shader.defines.end(), "DEPTH_ONLY"),
              marched->shader.defines.end());
    EXPECT_TRUE(plan.find("crepuscular_rays/occluders/sdf_morph/cone"));
    // Walls need only positions: neither materials nor light are bound.
    const render::Pass* walls = plan.find("crepuscular_rays/occluders/hall/walls");
    ASSERT_TRUE(walls);
    EXPECT_TRUE(walls->colors.empty() && walls->inputs.empty() && walls->draws[0].inputs.empty());
    for (const char* shadow :
         {"crepuscular_rays/occluders/hall/shadow", "crepuscular_rays/occluders/sky",
          "crepuscular_rays/occluders/sdf_morph/shadow", "crepuscular_rays/occluders/hall/plaques"})
        EXPECT_EQ(plan.find(shadow), nullptr) << shadow;
    // With other masks nothing is drawn twice.
    scene.rays().set(raysTable().mask, RayMask::depth);
    EXPECT_FALSE(runs(scene.plan(), "crepuscular_rays/occluders"));
}

TEST(RaysPlan, WhenOffThePlanIsThatOfAMuseumWithoutBeams)
{
    Scene off = atTheWindow(RayTechnique::none);
    const std::string without = toString(off.plan());
    EXPECT_EQ(without.find("crepuscular"), std::string::npos);
    Scene on = atTheWindow();
    std::string with = toString(on.plan());
    for (const char* pass : {" > crepuscular_rays/mask", " > crepuscular_rays/polar", " > crepuscular_rays/march",
                             " > crepuscular_rays/composite"}) {
        const std::size_t at = with.find(pass);
        ASSERT_NE(at, std::string::npos) << pass << " in " << with;
        with.erase(at, std::string(pass).size());
    }
    EXPECT_EQ(with, without);
}

TEST(RaysPlan, ShadowsAndProbeAreNotMadeAgainForTheBeams)
{
    Scene scene = atTheWindow();
    const render::PersistentState kept = test::keptAfter(scene.plan());
    scene.rays().set(raysTable().airDensity, 0.05);
    scene.rays().set(raysTable().decay, 0.9);
    for (const char* start : {"hall/shadow", "exhibits/shadow", "probe/"})
        EXPECT_FALSE(runs(scene.plan(kept), start)) << start;
    // The mobile is in the sun's shadow map, but not in the probe.
    scene.rays().set(raysTable().mobileRotation, 1.0);
    const render::FramePlan turned = scene.plan(kept);
    EXPECT_FALSE(runs(turned, "probe/"));
    // Only hanging objects are drawn again in the sun's shadow map, and only in their region.
    EXPECT_EQ(reasonFor(turned, "hall/shadow"), "unchanged since it last ran");
    EXPECT_EQ(reasonFor(turned, "hall/shadow/copy"), "unchanged since it last ran");
    ASSERT_TRUE(turned.find("hall/shadow/restore"));
    ASSERT_TRUE(turned.find("hall/shadow/hangings"));
    EXPECT_LT(turned.find("hall/shadow/hangings")->draws.size(), 12U);
    // All of it is drawn again when the sun moves.
    scene.hall().set(test::hallTable().sunElevation, 0.4);
    for (const char* pass : {"hall/shadow", "hall/shadow/copy", "hall/shadow/restore", "hall/shadow/hangings"})
        EXPECT_TRUE(scene.plan(kept).find(pass)) << pass;
}

TEST(RaysPlan, AStandingMobileAsksForNoNewPicture)
{
    Scene scene = atTheWindow();
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request),
              std::numeric_limits<double>::infinity());
    scene.rays().set(raysTable().animate, true);
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), 0);
}

TEST(RaysPlan, ATileTakesItsMaskFromTheWholePicture)
{
    Scene scene = atTheWindow(RayTechnique::screen);
    scene.rays().set(raysTable().method, RayMethod::threePasses);
    scene.request.raster = {.size = {6400, 3600}, .offset = {1000, 1000}, .tile = {500, 300}};
    const render::FramePlan plan = scene.plan();
    ASSERT_TRUE(runs(plan, "crepuscular_rays/occluders/"));
    EXPECT_EQ(plan.images().at("crepuscular_rays.mask").size, glm::ivec2(2048, 1152));
    EXPECT_TRUE(plan.find("crepuscular_rays/loop"));  // Passes cannot sample the next tile.
    EXPECT_EQ(plan.find("crepuscular_rays/taps/1"), nullptr);
    EXPECT_EQ(plan.find("crepuscular_rays/loop")->reason,
              "the picture is a tile, which cannot read the passes of its neighbors; one loop replaces them");
}

TEST(SunInPicture, IsProjectedLikeAPointVeryFarAway)
{
    const render::View view = render::makeView({{3, 2, 1}, {-1, 4, -8}, 0.9}, {.size = {640, 360}});
    const dvec3 ways[] = {{-0.5, 0.3, -1}, {1, 0.2, -1}, {-1, -0.1, -0.3}};
    for (const dvec3& path : ways) {
        const dvec3 sun = glm::normalize(path);
        const SunInPicture found = sunInPicture(view, sun);
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(view.eye + 1e9 * sun, 1);
        ASSERT_EQ(found.inFront, clip.w > 0);
        if (!found.inFront) continue;
        EXPECT_NEAR(found.pixel.x, (clip.x / clip.w * 0.5 + 0.5) * 640, 1e-3 * (1 + std::abs(clip.x / clip.w)));
        EXPECT_NEAR(found.pixel.y, (clip.y / clip.w * 0.5 + 0.5) * 360, 1e-3 * (1 + std::abs(clip.y / clip.w)));
    }
}

TEST(SunInPicture, BehindTheCameraIsNotMirroredIntoThePicture)
{
    const render::View view = render::makeView({{0, 0, 0}, {0, 0, -1}, 0.9}, {.size = {640, 360}});
    const dvec3 behind = glm::normalize(dvec3(0.05, -0.1, 1));
    EXPECT_FALSE(sunInPicture(view, behind).inFront);
    EXPECT_EQ(glsl::shaftEdgeFade(sunInPicture(view, behind).beyond, 100), 0);
    // Without the sign, the division would put it in the middle of the picture.
    const glm::dvec4 clip = view.clipFromView * glm::dvec4(behind, 0);
    EXPECT_LT(std::abs(clip.x / clip.w), 0.2);
}

TEST(SunInPicture, SweptThroughEdgeAndCameraPlaneChangesLittleByLittle)
{
    // Values in the shaders: the fade, and the direction of the streaks at the center of the picture.
    double lastFade = 1;
    dvec2 lastDirection(0);
    double largestFade = 0;
    double largestTurn = 0;
    for (int i = 0; i <= 1800; ++i) {
        const double angle = 0.1 * i * degree;
        const render::View view =
            render::makeView({{0, 0, 0}, {std::sin(angle), 0.1, -std::cos(angle)}, 0.9}, {.size = {640, 360}});
        const SunInPicture sun = sunInPicture(view, glm::normalize(dvec3(0, 0.3, -1)));
        const double fade = sun.inFront ? glsl::shaftEdgeFade(sun.beyond, 1.5) : 0;
        largestFade = std::max(largestFade, std::abs(fade - lastFade));
        lastFade = fade;
        if (fade <= 0) continue;
        const dvec2 direction = glm::normalize(sun.pixel - dvec2(320, 180));
        if (i > 0) largestTurn = std::max(largestTurn, glm::length(direction - lastDirection));
        lastDirection = direction;
    }
    EXPECT_LT(largestFade, 0.01);
    EXPECT_LT(largestTurn, 0.02);
    EXPECT_EQ(lastFade, 0);
}

TEST(PolarGrid, HoldsEveryPixelOfThePictureWhereverTheSunIs)
{
    const dvec2 size(640, 360);
    const dvec2 sources[] = {{320, 180}, {0, 0}, {640, 500}, {-900, 100}, {320, 361}, {5000, -4000}, {320.5, 180.5}};
    for (const dvec2& source : sources) {
        const PolarGrid grid = polarGrid(source, size, 64);
        for (int y = 0; y <= 36; ++y) {
            for (int x = 0; x <= 64; ++x) {
                const dvec2 path = dvec2(x, y) * 10.0 - source;
                const double radius = glm::length(path);
                EXPECT_LE(radius, grid.lastRadius);
                if (!grid.around) {
                    EXPECT_GE(radius, grid.firstRadius);
                }
                if (radius < 1e-9) continue;
                double angle = std::fmod(std::atan2(path.y, path.x) - grid.firstAngle, 2 * std::numbers::pi);
                if (angle < 0) angle += 2 * std::numbers::pi;
                EXPECT_LE(angle, grid.span + 1e-9) << source.x << ',' << source.y << " at " << x << ',' << y;
            }
        }
        EXPECT_EQ(grid.around, source.x >= 0 && source.x <= 640 && source.y >= 0 && source.y < 361);
    }
}

TEST(Beams, OfTheWindowReachTheFloorWhereTheSunSaysSo)
{
    const render::Box window{{-1.2, 1.4, -12.5}, {1.2, 6.4, -11.9}};
    const render::Box room{{-6, 0, -12}, {6, 9, 12}};
    const double elevation = 19 * degree;
    const std::vector<Beam> found = beams(std::span(&window, 1), room, {0, std::sin(elevation), -std::cos(elevation)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].axis, 2);
    EXPECT_NEAR(found[0].box.high.z, -11.9 + 6.4 / std::tan(elevation), 1e-9);
    EXPECT_NEAR(found[0].box.low.y, 0, 1e-9);
    EXPECT_NEAR(found[0].box.high.x, 1.2, 1e-9);
    EXPECT_TRUE(beams(std::span(&window, 1), room, {0, std::sin(elevation), std::cos(elevation)}).empty());
    EXPECT_TRUE(beams(std::span(&window, 1), room, glm::normalize(dvec3(5, 1, -1))).empty());  // Parallel to the wall.
}

TEST(SunAtHour, CrossesTheSkyOfAnEquinox)
{
    EXPECT_NEAR(sunAtHour(12).elevation, 42 * degree, 1e-9);
    for (const double hour : {6.0, 18.0}) EXPECT_NEAR(sunAtHour(hour).elevation, 0, 1e-9);
    EXPECT_LT(sunAtHour(0).elevation, -0.5);
    EXPECT_EQ(sunAtHour(0).strength, 0);
    EXPECT_LT(skyByHour(sunAtHour(0).elevation).zenith.y, 0.02);
    EXPECT_GT(skyByHour(sunAtHour(0).elevation).zenith.y, 0);
    // The hall's initial sun, shortly after four.
    const Sun four = sunAtHour(16.05);
    EXPECT_NEAR(four.elevation, 19 * degree, 0.6 * degree);
    EXPECT_NEAR(four.azimuth, -3 * degree, 0.6 * degree);
    EXPECT_NEAR(four.strength, 3.6, 0.15);
    EXPECT_GT(sunAtHour(12).temperature, sunAtHour(17.5).temperature);
}

TEST(SunAtHour, MovesReddensAndSetsLittleByLittle)
{
    for (int minute = 0; minute < 1440; ++minute) {
        const Sun a = sunAtHour(minute / 60.0);
        const Sun b = sunAtHour((minute + 1) / 60.0);
        EXPECT_LT(glm::length(a.towards() - b.towards()), 0.25 * degree * 1.1) << minute;
        EXPECT_LT(std::abs(a.strength - b.strength), 0.2) << minute;
        EXPECT_LT(std::abs(a.temperature - b.temperature), 80) << minute;
        const glm::dvec3 change = skyByHour(a.elevation).horizon - skyByHour(b.elevation).horizon;
        for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(change[i]), 0.03) << minute;
    }
}

TEST(SunAtHour, LeavesTheAnglesAloneUntilItIsAskedFor)
{
    const HallTable table;
    ParameterValues values(table);
    values.set(table.timeOfDay, 8.0);
    EXPECT_EQ(sunOf(table, values).elevation, values[table.sunElevation]);
    values.set(table.sunBy, SunBy::hour);
    EXPECT_EQ(sunOf(table, values).elevation, sunAtHour(8).elevation);
}

TEST(SteadyLightView, KeepsItsGridWhileTheBoxMovesAndGrows)
{
    const dvec3 sun = glm::normalize(dvec3(-0.2, 0.6, -1));
    const auto view = [&](const dvec3& shift, double grow) {
        return steadyLightView({dvec3(-0.5) + shift - grow, dvec3(0.5) + shift + grow}, sun, glm::ivec2(512), 30);
    };
    const render::View first = view(dvec3(0), 0);
    const auto texel = [](const render::View& v, const dvec3& world) {
        const glm::dvec4 clip = v.clipFromWorld * glm::dvec4(world, 1);
        return (dvec2(clip) * 0.5 + 0.5) * 512.0;
    };
    const dvec3 still(0.1, 0.2, 0.3);
    for (int i = 1; i < 50; ++i) {
        const render::View moved = view(dvec3(0.003, -0.001, 0.002) * static_cast<double>(i), 0.0002 * i);
        const dvec2 difference = texel(moved, still) - texel(first, still);
        EXPECT_NEAR(difference.x, std::round(difference.x), 1e-6) << i;
        EXPECT_NEAR(difference.y, std::round(difference.y), 1e-6) << i;
    }
    // Control: the map fitted to the box does not.
    const render::View loose = lightView({dvec3(-0.5) + 0.00123, dvec3(0.5) + 0.00123}, sun, glm::ivec2(512), 30);
    const dvec2 slid =
        texel(loose, still) - texel(lightView({dvec3(-0.5), dvec3(0.5)}, sun, glm::ivec2(512), 30), still);
    EXPECT_GT(std::abs(slid.y - std::round(slid.y)), 1e-3);
}

}  // namespace
}  // namespace vitrine::crepuscular_rays
