// Plans of the museum: passes, and skipped passes with their reasons. Uses the real hall without a GPU.

#include "exhibits/hall/hall_scene.h"
#include "exhibits/hall/walk.h"
#include "exhibits/noise/noise_table.h"
#include "exhibits/sdf_morph/sdf_morph.h"
#include "render/image/image.h"
#include "tests/stability/fields.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vitrine {
namespace {

using hall::buttonScale;
using hall::isBehind;
using hall::Occluder;
using render::FramePlan;
using render::toString;
using namespace test;

/// Sets the sun to shine straight through the window onto the middle of the hall.
void shineOnTheExhibit(Scene& scene)
{
    scene.hall().set(test::hallTable().sunAzimuth, 0.0);
    scene.hall().set(test::hallTable().sunElevation, 0.21);
}

/// Sets the sun to the side, behind the walls.
void hideTheSun(Scene& scene)
{
    scene.hall().set(test::hallTable().sunAzimuth, 0.7);
    scene.hall().set(test::hallTable().sunElevation, 0.35);
}

/// Looks at the floor of the near half, where the exhibit's shadow falls, but not at the exhibit.
void seeItsShadowOnly(Scene& scene)
{
    scene.see({0, 1.65, 4}, {0, 0, 7});
}

void turnAway(Scene& scene)
{
    scene.see({0, 1.65, 3}, {0, 1.65, 12});
}

/// Moves the camera outside of the far wall, beside the window.
void stepBehindTheWall(Scene& scene)
{
    scene.see({-3.7, 2, -13.5}, {0, 1.45, 0});
}

std::int64_t trianglesOf(const FramePlan& plan)
{
    std::int64_t count = 0;
    for (const render::Pass& pass : plan.passes())
        for (const render::Draw& draw : pass.draws)
            count += draw.instances * (draw.mesh ? static_cast<std::int64_t>(draw.mesh->indices.size() / 3) : 1);
    return count;
}

TEST(MuseumPlan, InViewTheExhibitIsMarchedAndTheRestSaysWhyNot)
{
    Scene scene;
    const FramePlan plan = scene.plan();
    ASSERT_TRUE(plan.find("sdf_morph/march"));
    EXPECT_EQ(plan.find("sdf_morph/march")->reason, "in view");
    EXPECT_TRUE(plan.find("sdf_morph/cone"));
    EXPECT_EQ(reasonFor(plan, "sdf_morph/count"), "no counts are requested");
    EXPECT_EQ(reasonFor(plan, "sdf_morph/mesh"), "the field is shown");
    EXPECT_EQ(reasonFor(plan, "sdf_morph/box"), "the overlay is switched off");
    EXPECT_EQ(reasonFor(plan, "average"), "one sample per pixel");
    EXPECT_EQ(reasonFor(plan, "hall/visitor"), "the free plinth is empty");
    EXPECT_EQ(toString(plan).substr(toString(plan).size() - 4), "tone");
}

TEST(MuseumPlan, OutOfViewItIsNotMarched)
{
    Scene scene;
    hideTheSun(scene);
    turnAway(scene);
    const FramePlan plan = scene.plan();
    EXPECT_EQ(reasonFor(plan, "sdf_morph"), "out of view");
    EXPECT_FALSE(runs(plan, "sdf_morph/"));
    // One line for the picture and one for the shadow; passes over the frame have no line for their bounds.
    for (const render::CulledPass& skipped : plan.skipped())
        EXPECT_TRUE(skipped.name.rfind("sdf_morph/", 0) != 0 || skipped.name == "sdf_morph/shadow") << skipped.name;
    EXPECT_EQ(reasonFor(plan, "crepuscular_rays"), "not in the plan");
}

TEST(MuseumPlan, BehindAWallItIsNotMarched)
{
    Scene scene;
    stepBehindTheWall(scene);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph"), "behind a wall");
    // It is visible through the window.
    scene.see({0, 3, -15}, {0, 1.45, 0});
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/march"), "it ran");
}

TEST(MuseumPlan, OfTheOnesInViewNoMoreAreDrawnThanAreAskedForTheNearestFirst)
{
    Scene scene;
    scene.see(test::museum().initialSceneState().camera);
    std::vector<std::size_t> nearest;
    for (std::size_t i = 1; i < test::museum().subjects().size(); ++i)
        if (!capability<OverFrame>(*test::museum().subjects()[i])) nearest.push_back(i);
    const auto distance = [&](std::size_t i) {
        const auto& exhibit = dynamic_cast<const Exhibit&>(*test::museum().subjects()[i]);
        const render::Box box =
            exhibit.boundsOf({scene.sceneState.values[i]}).transformed(test::museum().worldFromExhibit(i));
        return glm::distance(box.center(), scene.request.camera.eye);
    };
    std::sort(nearest.begin(), nearest.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
    const auto drawn = [&](std::size_t i) {
        return runs(scene.plan(), std::string(test::museum().subjects()[i]->name()) + "/");
    };
    std::erase_if(nearest, [&](std::size_t i) { return !drawn(i); });
    ASSERT_GE(nearest.size(), 4U);
    for (std::size_t most = 0; most <= nearest.size(); ++most) {
        scene.request.mostExhibits = static_cast<int>(most);
        for (std::size_t k = 0; k < nearest.size(); ++k)
            EXPECT_EQ(drawn(nearest[k]), k < most) << test::museum().subjects()[nearest[k]]->name() << ", " << most;
    }
    scene.request.mostExhibits = 0;
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph"), "the window is opening, and nearer exhibits are drawn first");
    EXPECT_EQ(reasonFor(scene.plan(), "exhibits/shadow"), "the window is opening, and nearer exhibits are drawn first");
}

TEST(MuseumPlan, WhileTheWindowOpensTheProbeAndTheShadowMapAreSmall)
{
    Scene scene;
    const auto sides = [&](int mostExhibits) {
        scene.request.mostExhibits = mostExhibits;
        const FramePlan plan = scene.plan();
        return glm::ivec3(plan.images().at("probe").size.x, plan.images().at("probe.captured").size.x,
                          plan.images().at("shadow.hall").size.x);
    };
    constexpr int all = std::numeric_limits<int>::max();
    EXPECT_EQ(sides(all), glm::ivec3(256, 256, 2048));
    EXPECT_EQ(sides(0), glm::ivec3(64, 64, 1024));
    EXPECT_EQ(sides(3), glm::ivec3(64, 64, 1024));
    // Sizes that are smaller already stay.
    scene.hall().set(test::hallTable().probeSize, 16);
    scene.hall().set(test::hallTable().shadowMapSize, 256);
    EXPECT_EQ(sides(0), glm::ivec3(16, 16, 256));
    EXPECT_EQ(sides(all), glm::ivec3(16, 16, 256));
}

TEST(MuseumPlan, OutOfViewTheHallIsPlannedAsIfItWereEmpty)
{
    // The initial state, compared with a museum without exhibits, where no exhibit, stand or sunbeam is in view.
    Scene scene;
    scene.see({0.5, 1.65, 9}, {0.5, 1.2, 12});
    const Museum empty{std::vector<std::unique_ptr<Exhibit>>{}};
    const auto emptyPlan = [&](const render::PersistentState& kept) {
        return test::planned(empty, empty.initialSceneState(), scene.request, kept);
    };
    // Only dust is always in view: one pass composites it.
    EXPECT_EQ(toString(scene.plan(keptAfter(scene.plan()))),
              "hall/walls > hall/floor > sky > crepuscular_rays/composite > glare > glare/spread > tone");
    EXPECT_EQ(reasonFor(scene.plan(), "crepuscular_rays/march"), "the beams are out of view");
    scene.rays().set(test::raysTable().airDensity, 0.0);
    const FramePlan first = scene.plan();
    for (const auto& [i, exhibit] : test::museum().exhibits())
        EXPECT_FALSE(runs(first, std::string(exhibit.name()) + '/')) << exhibit.name();
    EXPECT_FALSE(runs(first, "exhibits/"));
    EXPECT_EQ(reasonFor(first, "crepuscular_rays/march"), "the air is clear");
    const FramePlan later = scene.plan(keptAfter(first));
    const FramePlan bare = emptyPlan(keptAfter(emptyPlan({})));
    EXPECT_EQ(toString(later), toString(bare));
    EXPECT_EQ(toString(later), "hall/walls > hall/floor > sky > glare > glare/spread > tone");
    EXPECT_EQ(trianglesOf(later), trianglesOf(bare));
    // No setting of the exhibit makes it more expensive.
    Scene costly = scene;
    costly.object().set(test::sdfTable().shownAs, SdfShown::mesh);
    costly.object().set(test::sdfTable().showBox, true);
    costly.object().set(test::sdfTable().material, SdfMaterial::glass);
    costly.object().set(test::sdfTable().stepLimit, 1024);
    EXPECT_EQ(toString(costly.plan(keptAfter(first))), toString(later));
    EXPECT_EQ(trianglesOf(costly.plan(keptAfter(first))), trianglesOf(later));
}

TEST(MuseumPlan, SkipsItsShadowWhereTheSunDoesNotReach)
{
    Scene scene;
    hideTheSun(scene);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "the sun does not reach it through window or oculus");
    EXPECT_EQ(reasonFor(scene.plan(), "exhibits/shadow"), "the sun does not reach it through window or oculus");
    shineOnTheExhibit(scene);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "it ran");
    EXPECT_EQ(reasonFor(scene.plan(), "exhibits/shadow"), "it ran");
}

TEST(MuseumPlan, DrawsTheShadowOfWhatIsOutOfViewWhenTheShadowIsNot)
{
    Scene scene;
    shineOnTheExhibit(scene);
    seeItsShadowOnly(scene);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph"), "out of view");
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "it ran");
    scene.see({0, 1.65, -3}, {0, 3, -12});  // Toward the window, the shadow is behind the visitor.
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "neither it nor its shadow is in view");
}

TEST(MuseumPlan, WithoutSunNothingCasts)
{
    Scene scene;
    shineOnTheExhibit(scene);
    scene.hall().set(test::hallTable().sunStrength, 0.0);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "the sun's strength is 0");
}

TEST(MuseumPlan, ShadowsSwitchedOffAreNotDrawn)
{
    Scene scene;
    shineOnTheExhibit(scene);
    EXPECT_EQ(reasonFor(scene.plan(), "hall/shadow"), "it ran");
    scene.hall().set(test::hallTable().sunShadows, false);
    for (const char* pass : {"hall/shadow", "sdf_morph/shadow", "exhibits/shadow"})
        EXPECT_EQ(reasonFor(scene.plan(), pass), "sun shadows are switched off") << pass;
    const FramePlan plan = scene.plan();
    for (const render::Pass& pass : plan.passes())
        for (const std::string& image : inputsOf(pass))
            EXPECT_EQ(image.find("shadow."), std::string::npos) << pass.name << " reads " << image;
}

TEST(MuseumPlan, ProbeSwitchedOffIsNotCaptured)
{
    Scene scene;
    EXPECT_TRUE(runs(scene.plan(), "probe/"));
    scene.hall().set(test::hallTable().reflectionProbe, false);
    EXPECT_EQ(reasonFor(scene.plan(), "probe"), "the reflection probe is switched off");
    EXPECT_FALSE(runs(scene.plan(), "probe/"));
}

TEST(MuseumPlan, ProbeAndHallShadowAreKeptWhileTheLightIsTheSame)
{
    Scene scene;
    const FramePlan first = scene.plan();
    const render::PersistentState kept = keptAfter(first);
    EXPECT_GT(kept.passes.size(), 8U);
    scene.object().set(test::sdfTable().morph, 0.25);
    scene.hall().set(test::hallTable().exposure, 1.0);  // Exposure changes the display, and not the light in the room.
    turnAway(scene);
    const FramePlan second = scene.plan(kept);
    for (const auto& [pass, key] : kept.passes) {
        // Only the shadow of the changed exhibit differs.
        const bool ofExhibits = pass.rfind("probe/", 0) != 0 && pass.rfind("hall/", 0) != 0;
        EXPECT_EQ(reasonFor(second, pass), ofExhibits ? "it ran" : "unchanged since it last ran") << pass;
    }

    scene.hall().set(test::hallTable().sunElevation, 0.4);
    const FramePlan third = scene.plan(kept);
    for (const auto& [pass, key] : kept.passes) EXPECT_EQ(reasonFor(third, pass), "it ran") << pass;
}

TEST(MuseumPlan, WorksOnTheWallsAreDrawnForMirrorsThatCanShowThemAndKeptUntilTheyChange)
{
    const std::vector<std::string> works{"sdf_scenes/reflected", "noise/reflected", "pixel_art/reflected",
                                         "paper_lanterns/reflected", "your_shader/reflected"};
    Scene scene;
    EXPECT_EQ(reasonFor(scene.plan(), "probe/works"), "no mirror in view is large enough to show them");
    scene.request.raster.size = {640, 360};
    const FramePlan first = scene.plan();
    for (const std::string& work : works) EXPECT_EQ(reasonFor(first, work), "it ran");
    EXPECT_TRUE(first.errors().empty());
    // The probe itself, which everything else reads, does not contain them.
    for (const render::Pass& pass : first.passes()) {
        if (!pass.name.starts_with("probe/blur/") && !pass.name.starts_with("hall/")) continue;
        for (const std::string& image : inputsOf(pass))
            EXPECT_TRUE(image != "probe.works" && image != "probe.mirrored") << pass.name;
    }

    const render::PersistentState kept = keptAfter(first);
    static const noise::NoiseTable table;
    const auto ofNoise = [](Scene& s) -> ParameterValues& { return s.sceneState.values[*museum().find("noise")]; };
    const auto changed = [&](const auto& change) {
        Scene other = scene;
        change(other);
        return other.plan(kept);
    };
    const FramePlan later = changed([&](Scene& s) {
        s.request.time = 5;
        s.see({0.6, 1.7, 1.9}, {0, 1.45, 0});
        ofNoise(s).set(table.animate, true);
    });
    for (const std::string& work : works)
        EXPECT_EQ(runs(later, work), work == "noise/reflected") << work << ": its own switch was changed";
    const FramePlan same = changed([&](Scene& s) { s.request.time = 5; });
    for (const std::string& work : works) EXPECT_EQ(reasonFor(same, work), "unchanged since it last ran") << work;
    for (const char* pass : {"probe/works/0", "probe/mirrored/0"})
        EXPECT_EQ(reasonFor(same, pass), "unchanged since it last ran");

    const FramePlan dusk = changed([&](Scene& s) { ofNoise(s).set(table.haze, 0.9); });
    EXPECT_TRUE(runs(dusk, "noise/reflected"));
    EXPECT_TRUE(runs(dusk, "probe/works/0"));
    EXPECT_FALSE(runs(dusk, "pixel_art/reflected"));
    EXPECT_FALSE(runs(dusk, "probe/things/0"));
    // While a value is dragged in the window, the last pictures stay.
    const FramePlan dragged = changed([&](Scene& s) {
        ofNoise(s).set(table.haze, 0.9);
        s.request.nonBlocking = true;
    });
    EXPECT_FALSE(runs(dragged, "noise/reflected"));
    EXPECT_FALSE(runs(dragged, "probe/works/0"));
    // Chalk shows no pictures.
    const FramePlan chalk = changed([](Scene& s) { s.object().set(test::sdfTable().roughness, 0.9); });
    EXPECT_EQ(reasonFor(chalk, "probe/works"), "no mirror in view is large enough to show them");
}

TEST(MuseumPlan, TheExhibitsShadowIsKeptWhileNothingInItMoves)
{
    Scene scene;
    shineOnTheExhibit(scene);
    const render::PersistentState kept = keptAfter(scene.plan());
    scene.see({0.5, 2, 3}, {0, 1.4, 0});
    scene.request.time = 5;
    for (const char* pass : {"exhibits/shadow", "sdf_morph/shadow"})
        EXPECT_EQ(reasonFor(scene.plan(kept), pass), "unchanged since it last ran") << pass;

    const auto runsAfter = [&](const auto& change) {
        Scene changed = scene;
        change(changed);
        return runs(changed.plan(kept), "sdf_morph/shadow") && runs(changed.plan(kept), "exhibits/shadow");
    };
    EXPECT_TRUE(runsAfter([](Scene& s) { s.object().set(test::sdfTable().morph, 0.1); }));
    EXPECT_TRUE(runsAfter([](Scene& s) { s.object().set(test::sdfTable().animate, true); }));
    EXPECT_TRUE(runsAfter([](Scene& s) { s.hall().set(test::hallTable().sunElevation, 0.2); }));
    EXPECT_TRUE(runsAfter([](Scene& s) { s.hall().set(test::hallTable().shadowMapSize, 512); }));
    EXPECT_TRUE(runsAfter([](Scene& s) {
        s.request.subject = s.sdf;
        s.request.exhibitTransform[1][1] = 1.2;
    }));
}

TEST(MuseumPlan, AloneThereIsNoHall)
{
    Scene scene;
    scene.request.alone = scene.sdf;
    scene.see(test::museum().subject(scene.sdf).bestView(scene.object()));
    const FramePlan plan = scene.plan();
    EXPECT_EQ(reasonFor(plan, "hall/walls"), "the exhibit is shown alone");
    EXPECT_EQ(reasonFor(plan, "hall/shadow"), "there is no hall to cast it");
    EXPECT_EQ(reasonFor(plan, "sdf_morph/march"), "it ran");
    EXPECT_EQ(reasonFor(plan, "sky"), "it ran");
    EXPECT_FALSE(runs(plan, "hall/"));
    EXPECT_FALSE(runs(plan, "probe/walls"));
}

TEST(MuseumPlan, AloneNoWallHidesIt)
{
    Scene scene;
    scene.request.alone = scene.sdf;
    for (const glm::dvec3 eye : {glm::dvec3(-3.7, 2, -13.5), glm::dvec3(12, 9, 36), glm::dvec3(-30, 1, 0)}) {
        scene.see(eye, {0, 0, 0});
        EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/march"), "it ran");
    }
}

TEST(MuseumPlan, AloneItsShadowIsDrawnOnlyForAMeshToFallOn)
{
    Scene scene;
    scene.request.alone = scene.sdf;
    scene.see(test::museum().subject(scene.sdf).bestView(scene.object()));
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "its output is not used");
    EXPECT_EQ(reasonFor(scene.plan(), "exhibits/shadow"), "its output is not used");
    scene.object().set(test::sdfTable().shownAs, SdfShown::mesh);
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "it ran");
}

TEST(MuseumPlan, TransparentLeavesOutTheSky)
{
    Scene scene;
    scene.request.transparent = true;
    EXPECT_EQ(reasonFor(scene.plan(), "sky"), "a transparent background is requested");
}

TEST(MuseumPlan, LinearLightIsNotToneMapped)
{
    Scene scene;
    scene.request.averageIn = AverageIn::radiance;
    EXPECT_EQ(reasonFor(scene.plan(), "tone"), "linear light is requested");
    EXPECT_EQ(scene.plan().images().at(radianceImage).format, render::Format::rgba32f);
}

TEST(MuseumPlan, ChannelsAreWrittenOnlyWhenAskedFor)
{
    Scene scene;
    const auto writes = [](const FramePlan& plan, const char* image) {
        for (const render::Pass& pass : plan.passes())
            for (const std::string& name : outputsOf(pass))
                if (name == image) return true;
        return false;
    };
    EXPECT_FALSE(writes(scene.plan(), normalImage));
    EXPECT_FALSE(writes(scene.plan(), evaluationsImage));
    EXPECT_FALSE(writes(scene.plan(), albedoImage));
    scene.request.channels = {true, true, true};
    EXPECT_TRUE(writes(scene.plan(), normalImage));
    EXPECT_TRUE(writes(scene.plan(), albedoImage));
    EXPECT_EQ(reasonFor(scene.plan(), "sdf_morph/count"), "it ran");
}

TEST(MuseumPlan, RunEverythingSkipsNothingThatWasPlanned)
{
    Scene scene;
    turnAway(scene);
    scene.request.runEverything = true;
    const FramePlan plan = scene.plan(keptAfter(scene.plan()));
    EXPECT_EQ(reasonFor(plan, "sdf_morph/march"), "it ran");
    EXPECT_TRUE(runs(plan, "probe/"));
    for (const render::CulledPass& skipped : plan.skipped()) {
        EXPECT_NE(skipped.reason, "its output is not used") << skipped.name;
        EXPECT_NE(skipped.reason, "unchanged since it last ran") << skipped.name;
        EXPECT_NE(skipped.reason, "out of view") << skipped.name;
    }
}

TEST(MuseumPlan, EveryPassAndEverySkipHasAReason)
{
    Scene scene;
    for (const bool alone : {false, true}) {
        if (alone) scene.request.alone = scene.sdf;
        const FramePlan plan = scene.plan();
        for (const render::Pass& pass : plan.passes()) EXPECT_FALSE(pass.reason.empty()) << pass.name;
        for (const render::CulledPass& skipped : plan.skipped()) EXPECT_FALSE(skipped.reason.empty()) << skipped.name;
    }
}

TEST(MuseumPlan, ReadsOnlyImagesThatAPassBeforeItWroteOrThatAreKept)
{
    for (const bool alone : {false, true}) {
        Scene scene;
        shineOnTheExhibit(scene);
        scene.object().set(test::sdfTable().shownAs, SdfShown::mesh);
        scene.request.channels = {true, true};
        scene.request.samples = 4;
        if (alone) scene.request.alone = scene.sdf;
        const FramePlan plan = scene.plan();
        std::set<std::string> written;
        for (const render::Pass& pass : plan.passes()) {
            for (const render::SampledTexture& input : pass.inputs)
                if (const auto* image = std::get_if<std::string>(&input.source)) {
                    EXPECT_TRUE(written.contains(*image)) << pass.name << " reads " << *image;
                }
            for (const std::string& image : outputsOf(pass)) {
                written.insert(image);
                EXPECT_TRUE(plan.images().contains(image)) << pass.name << " writes " << image;
            }
        }
    }
}

TEST(MuseumPlan, WhatIsTranslucentIsBlendedOverTheSky)
{
    // Translucent surfaces do not write depth: a sky drawn after them would cover them.
    Scene scene;
    const std::string order = toString(scene.plan());
    EXPECT_LT(order.find(" > sky"), order.find(" > hall/plaques")) << order;
    EXPECT_GT(order.find(" > sky"), order.find(" > sdf_morph/march")) << order;
}

TEST(MuseumPlan, SamplesOfOnePictureDifferInPositionOnly)
{
    Scene scene;
    scene.request.samples = 16;
    for (int i = 0; i < 16; ++i) {
        scene.request.sample = i;
        const FramePlan plan = scene.plan();
        EXPECT_EQ(plan.view.raster.jitter, render::samplePosition(i, 16));
        ASSERT_TRUE(plan.find("average"));
        EXPECT_FLOAT_EQ(plan.find("average")->state.meanWeight, 1.0F / static_cast<float>(i + 1));
    }
}

TEST(NextChange, StillLifeNeedsNoNewPicture)
{
    Scene scene;
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), never);
    scene.object().set(test::sdfTable().animate, true);
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), 0);
    scene.object().set(test::sdfTable().speed, 0.0);
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), never);
}

TEST(NextChange, WhatMovesUnseenNeedsNoNewPicture)
{
    Scene scene;
    scene.object().set(test::sdfTable().animate, true);
    hideTheSun(scene);
    turnAway(scene);
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), never);
    stepBehindTheWall(scene);
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), never);
}

TEST(NextChange, AMovingShadowOfWhatIsOutOfViewIsAChange)
{
    Scene scene;
    scene.object().set(test::sdfTable().animate, true);
    shineOnTheExhibit(scene);
    seeItsShadowOnly(scene);
    ASSERT_EQ(reasonFor(scene.plan(), "sdf_morph/shadow"), "it ran");
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), 0);
}

TEST(NextChange, APressedButtonMovesForATenthOfASecondDownAndBack)
{
    Scene scene;
    scene.request.sincePressed = {never, 0.19};
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), 0);
    scene.request.sincePressed = {never, 0.2};
    EXPECT_EQ(test::nextChange(test::museum(), scene.sceneState, scene.request), never);
}

TEST(Button, IsSquashedToATenthInATenthOfASecondAndComesBack)
{
    EXPECT_DOUBLE_EQ(buttonScale(0), 1);
    EXPECT_NEAR(buttonScale(0.05), 0.55, 1e-12);
    EXPECT_NEAR(buttonScale(0.1), 0.1, 1e-12);
    EXPECT_NEAR(buttonScale(0.15), 0.55, 1e-12);
    EXPECT_DOUBLE_EQ(buttonScale(0.2), 1);
    EXPECT_DOUBLE_EQ(buttonScale(1e9), 1);
    EXPECT_DOUBLE_EQ(buttonScale(-1), 1);
    EXPECT_DOUBLE_EQ(buttonScale(std::numeric_limits<double>::quiet_NaN()), 1);
}

TEST(Occluder, HidesExactlyWhatNoRayPasses)
{
    // Compared with rays: a hidden box has no corner and no inner point that is visible past the wall.
    test::Random random(4);
    int hidden = 0;
    for (int i = 0; i < 4000; ++i) {
        const Occluder wall{random.point(1), random.direction() * random.number(0.3, 3), {}};
        Occluder occluder = wall;
        occluder.halfV = glm::normalize(glm::cross(wall.halfU, random.direction())) * random.number(0.3, 3);
        const glm::dvec3 eye = random.point(4);
        const glm::dvec3 center = random.point(4);
        const glm::dvec3 half = glm::abs(random.point(0.4));
        if (!isBehind(occluder, {center - half, center + half}, eye)) continue;
        ++hidden;
        const glm::dvec3 normal = glm::normalize(glm::cross(occluder.halfU, occluder.halfV));
        for (int j = 0; j < 30; ++j) {
            const glm::dvec3 p = center + half * random.point(1);
            const double t = glm::dot(normal, occluder.center - eye) / glm::dot(normal, p - eye);
            const glm::dvec3 hit = eye + (p - eye) * t - occluder.center;
            EXPECT_TRUE(t > 0 && t < 1);
            EXPECT_LE(std::abs(glm::dot(hit, occluder.halfU)), glm::dot(occluder.halfU, occluder.halfU) * (1 + 1e-9));
            EXPECT_LE(std::abs(glm::dot(hit, occluder.halfV)), glm::dot(occluder.halfV, occluder.halfV) * (1 + 1e-9));
        }
    }
    EXPECT_GT(hidden, 100);
}

}  // namespace
}  // namespace vitrine
