// The visitor's own objects: up to four, each at the place of its parameters.

#include "exhibits/framework/files/preset.h"
#include "render/files/assets.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/plan_text.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vitrine {
namespace {

using glm::dvec3;
using hall::HallTable;
using hall::mostOwnObjects;
using hall::ObjectStand;
using hall::OwnObjectParameters;
using namespace test;

const std::array<const char*, mostOwnObjects> modelParameters{"model", "secondModel", "thirdModel", "fourthModel"};
const std::array<const char*, mostOwnObjects> passes{"hall/visitor", "hall/visitor/2", "hall/visitor/3",
                                                     "hall/visitor/4"};

std::string bear()
{
    return render::asset("models/teddy.glb").string();
}

const HallTable& table()
{
    return test::hallTable();
}

/// Returns a scene with a bear at each of these places.
Scene withBears(std::initializer_list<std::size_t> places)
{
    Scene scene;
    for (const std::size_t which : places) scene.hall().set(table().objects[which].model, bear());
    scene.see(museum().initialSceneState().camera);
    return scene;
}

/// Returns the center of the lowest side of the only object.
dvec3 foot(const Scene& scene)
{
    const auto all = museum().surroundings().ownObjects(museum().prepare(scene.sceneState, scene.request));
    if (all.size() != 1) return dvec3(NAN);
    const render::Box& box = all.front().box;
    return {box.center().x, box.low.y, box.center().z};
}

std::optional<Pointed> pointedIn(const Scene& scene)
{
    return museum().surroundings().pick(museum().prepare(scene.sceneState, scene.request), scene.request, {0, 0});
}

TEST(LongOwnObjects, EmptyPlacesCostNothingAndAreSaidToBeEmpty)
{
    Scene scene;
    scene.see(museum().initialSceneState().camera);
    const render::FramePlan plan = scene.plan();
    EXPECT_FALSE(test::runs(plan, "hall/visitor"));
    EXPECT_EQ(reasonFor(plan, passes[0]), "the free plinth is empty");
    for (std::size_t which = 1; which < mostOwnObjects; ++which)
        EXPECT_EQ(reasonFor(plan, passes.at(which)), "no file is chosen for it");
    EXPECT_EQ(museum().assets().builds("hall.plinth"), 0) << "a plinth was made for nobody";
    // After adding and removing an object, the plan is the same.
    const std::string before = test::wholeText(plan);
    Scene again = withBears({1, 3});
    EXPECT_NE(test::wholeText(again.plan()), before);
    for (const std::size_t which : {1U, 3U}) again.hall().set(table().objects[which].model, std::string());
    EXPECT_EQ(test::wholeText(again.plan()), before);
}

TEST(OwnObjects, StandAtFourPlacesAndEachIsPickedAndVisitedByItself)
{
    const Scene scene = withBears({0, 1, 2, 3});
    const render::FramePlan plan = scene.plan();
    for (std::size_t which = 0; which < mostOwnObjects; ++which)
        EXPECT_EQ(reasonFor(plan, passes.at(which)), "it ran") << which;
    const auto prepared = museum().prepare(scene.sceneState, scene.request);
    const std::vector<OwnObjectShown> all = museum().surroundings().ownObjects(prepared);
    ASSERT_EQ(all.size(), mostOwnObjects);
    for (const OwnObjectShown& one : all) {
        SCOPED_TRACE(one.which);
        Scene before = scene;
        before.see(one.view);
        const auto found = pointedIn(before);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->exhibit, hallIndex);
        EXPECT_EQ(found->name, "Your object: teddy.glb");
        EXPECT_EQ(found->view, one.view) << "another one is in the middle of its view";
        EXPECT_TRUE(test::building().room().contains(one.view.eye)) << "it is looked at through a wall";
    }
}

TEST(OwnObjects, AreLeftOutWhereNoneSeesThem)
{
    Scene scene = withBears({1});
    ASSERT_EQ(reasonFor(scene.plan(), passes[1]), "it ran");
    scene.see({0, 1.65, 3}, {0, 1.65, 12});
    EXPECT_EQ(reasonFor(scene.plan(), passes[1]), "out of view");
}

TEST(OwnObjects, StandWhereTheirRowsSayAndWallsAndFurnitureKeepThemOff)
{
    Scene scene = withBears({2});
    const OwnObjectParameters& rows = table().objects[2];
    scene.hall().set(rows.modelAcross, 0.5);
    scene.hall().set(rows.modelAlong, 5.5);
    const dvec3 free = foot(scene);
    scene.hall().set(rows.modelAcross, 0.9);
    EXPECT_NEAR(foot(scene).x - free.x, 0.4, 1e-9);
    // On the floor it is lower by the height of its plinth.
    scene.hall().set(rows.modelStand, ObjectStand::floor);
    EXPECT_NEAR(free.y - foot(scene).y, 0.8, 1e-9);
    // Any of the objects can use the free plinth.
    scene.hall().set(rows.modelStand, ObjectStand::freePlinth);
    EXPECT_NEAR(glm::distance(foot(scene), foot(withBears({0}))), 0, 1e-9);
    // Into the wall, and into the free plinth: it is kept away by at least half of its width.
    scene.hall().set(rows.modelStand, ObjectStand::ownPlinth);
    const auto kept = [&](double x, double z) {
        scene.hall().set(rows.modelAcross, x);
        scene.hall().set(rows.modelAlong, z);
        return foot(scene);
    };
    EXPECT_LT(kept(5.6, 0).x, 5.75);
    const dvec3 aside = kept(3.1, -3.4);
    EXPECT_GT(std::max(std::abs(aside.x - 3), std::abs(aside.z + 3.4)), 0.45 + 0.18);
}

TEST(OwnObjects, AndTheirPlinthsStopTheVisitor)
{
    Scene scene = withBears({1, 2});
    const auto prepared = museum().prepare(scene.sceneState, scene.request);
    for (const OwnObjectShown& one : museum().surroundings().ownObjects(prepared)) {
        const dvec3 middle = one.box.center();
        const dvec3 from(middle.x, 1.65, middle.z + 1.6), to(middle.x, 1.65, middle.z);
        EXPECT_LT(glm::distance(museum().surroundings().walk(from, to), to), 1e-9) << "the bare hall stops one here";
        EXPECT_GT(museum().surroundings().walk(prepared, from, to).z, middle.z + 0.3);
    }
    // The hall without objects is unchanged.
    const Scene none = withBears({});
    const dvec3 from(-4.9, 1.65, -1.9), to(-4.9, 1.65, -3.5);
    EXPECT_EQ(museum().surroundings().walk(museum().prepare(none.sceneState, none.request), from, to),
              museum().surroundings().walk(from, to));
}

TEST(OwnObjects, ABadFileLeavesTheOthersAsTheyAreAndIsNamedOnce)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "noise.glb", std::string(300, '\x17'));
    Scene scene = withBears({0, 1, 3});
    const auto drawsOf = [&](const render::FramePlan& plan, const char* pass) {
        const render::Pass* drawn = plan.find(pass);
        return drawn ? drawn->draws.size() : 0;
    };
    const render::FramePlan good = scene.plan();
    scene.hall().set(table().objects[1].model, (folder / "noise.glb").string());
    const render::FramePlan bad = scene.plan();
    for (const std::size_t which : {0U, 3U}) {
        EXPECT_GT(drawsOf(good, passes.at(which)), 0U);
        EXPECT_EQ(drawsOf(bad, passes.at(which)), drawsOf(good, passes.at(which)));
    }
    EXPECT_EQ(reasonFor(bad, passes[1]), "its file has not been read");
    std::vector<std::string> said;
    for (const render::CulledPass& skipped : bad.skipped())
        if (!skipped.unreadable.empty()) said.push_back(skipped.unreadable);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].rfind("Second model of The hall: ", 0), 0U) << said[0];
    EXPECT_NE(said[0].find("noise.glb"), std::string::npos) << said[0];
}

TEST(OwnObjects, PresetsOfOneLoadAsTheFirstAndOfFourComeBack)
{
    const Preset old = parsePreset(R"({"format": "vitrine-preset", "version": 1, "app": "0.1.0", "exhibit": "hall",
        "name": "Mine", "values": {"model": "bear.glb", "modelSize": 1.5, "modelRotation": 0.5}})",
                                   "mine.json", "hall", table());
    EXPECT_EQ(old.values[table().objects[0].model], "bear.glb");
    EXPECT_EQ(old.values[table().objects[0].modelSize], 1.5);
    EXPECT_EQ(old.values[table().objects[0].modelRotation], 0.5);
    EXPECT_EQ(old.values[table().objects[0].modelStand], ObjectStand::freePlinth);
    for (std::size_t which = 1; which < mostOwnObjects; ++which)
        EXPECT_EQ(old.values[table().objects[which].model], "");

    Preset four = old;
    for (std::size_t which = 0; which < mostOwnObjects; ++which) {
        const OwnObjectParameters& rows = table().objects[which];
        four.values.set(rows.model, "m" + std::to_string(which) + ".glb");
        four.values.set(rows.modelAcross, 0.25 * static_cast<double>(which));
        four.values.set(rows.modelStand, ObjectStand::floor);
    }
    const std::string text = presetText(four);
    for (const char* row : modelParameters)
        EXPECT_NE(text.find('"' + std::string(row) + '"'), std::string::npos) << text;
    EXPECT_EQ(parsePreset(text, "four.json", "hall", table()).values, four.values);
}

}  // namespace
}  // namespace vitrine
