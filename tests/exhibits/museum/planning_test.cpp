// Planning only reads: the same prepared picture gives exactly the same plan, whatever was or is being planned
// elsewhere, and no file is opened.

#include "exhibits/framework/table/random_values.h"
#include "exhibits/fur/fur_table.h"
#include "exhibits/lenticular/lenticular_table.h"
#include "render/files/assets.h"
#include "tests/support/plan_text.h"
#include "tests/support/scenes_of_presets.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <thread>

namespace vitrine {
namespace {

using namespace test;

std::string textOf(const Museum& museum, const Scene& scene)
{
    return wholeText(test::planned(museum, scene.sceneState, scene.request));
}

/// Returns scenes with random values of each exhibit in turn, at random times, with the button pressed or not, from its
/// best view.
std::map<std::string, Scene> randomScenes(int ofEach)
{
    std::map<std::string, Scene> scenes;
    for (std::size_t i = 0; i < museum().subjects().size(); ++i) {
        const SceneObject& subject = museum().subject(i);
        for (int seed = 1; seed <= ofEach; ++seed) {
            RandomNumbers random(static_cast<std::uint64_t>(seed) * 1000 + i);
            Scene scene;
            scene.sceneState.values[i] = randomValues(subject.parameters(), random, 0.7);
            scene.see(museum().bestView(i, scene.sceneState.values[i]));
            scene.request.time = random.number(0, 20);
            if (random.chance(0.5)) scene.request.sincePressed.assign(museum().subjects().size(), random.number(0, 3));
            scene.request.channels = {random.chance(0.3), random.chance(0.3)};
            scene.request.runEverything = random.chance(0.2);
            if (i != hallIndex && random.chance(0.3)) {
                scene.request.alone = i;
                scene.see(subject.bestView(scene.sceneState.values[i]));
            }
            scenes.emplace(std::string(subject.name()) + " with random values " + std::to_string(seed),
                           std::move(scene));
        }
    }
    return scenes;
}

std::map<std::string, Scene> manyScenes(int randomOfEach)
{
    std::map<std::string, Scene> scenes = test::scenesOfPresets();
    scenes.merge(randomScenes(randomOfEach));
    return scenes;
}

TEST(LongPlanning, TwiceGivesTheSamePlanToTheLastByte)
{
    for (const auto& [name, scene] : manyScenes(3)) {
        SCOPED_TRACE(name);
        const Prepared prepared = museum().prepare(scene.sceneState, scene.request);
        const std::string first = wholeText(museum().plan(prepared, scene.request));
        EXPECT_EQ(wholeText(museum().plan(prepared, scene.request)), first);
        const double next = museum().nextChange(prepared, scene.request);
        EXPECT_EQ(museum().nextChange(prepared, scene.request), next);
        EXPECT_EQ(textOf(museum(), scene), first) << "it is prepared otherwise the second time";
    }
}

/// Returns the scenes of two users, who differ in everything that is resolved.
std::vector<Scene> twoUsers()
{
    const fur::FurTable fur;
    const lenticular::LenticularTable card;
    const sdf_morph::SdfMorphTable& sdf = test::sdfTable();
    std::vector<Scene> users(2);
    for (std::size_t u = 0; u < 2; ++u) {
        Scene& scene = users[u];
        ParameterValues& coat = scene.sceneState.values[*museum().find("fur")];
        ParameterValues& print = scene.sceneState.values[*museum().find("lenticular")];
        scene.object().set(sdf.shownAs, SdfShown::mesh);
        scene.object().set(sdf.tessellation, u == 0 ? 8 : 11);
        coat.set(fur.silhouette, fur::FurSilhouette::fins);
        coat.set(fur.frozenAt, u == 0 ? 0.6 : 0.0);
        coat.set(fur.toss, u == 0 ? 4 : 5);
        coat.set(fur.bouncePeriod, u == 0 ? 0.0 : 4.0);
        print.set(card.views, u == 0 ? 5 : 3);
        scene.hall().set(test::hallTable().environment,
                         render::asset("frames/turning_mug").string() + (u == 0 ? "/view_00.png" : "/view_01.png"));
        if (u == 0)
            coat.set(fur.ringModel, std::string("models/teddy.glb"));
        else
            scene.hall().set(test::hallTable().objects.front().model, render::asset("models/teddy.glb").string());
        // Both see everything.
        scene.request.runEverything = true;
        scene.request.time = 0.9;
    }
    return users;
}

TEST(LongPlanning, TwoUsersInTurnGetWhatEachGetsAloneAndNeverRebuildEachOthers)
{
    const std::vector<Scene> users = twoUsers();
    std::vector<std::string> alone;
    for (const Scene& user : users) {
        const Museum own(allExhibits());
        alone.push_back(textOf(own, user));
        EXPECT_TRUE(own.prepare(user.sceneState, user.request).unreadableFiles().empty());
    }
    EXPECT_NE(alone[0], alone[1]);
    const Museum shared(allExhibits());
    std::int64_t builds = 0;
    for (int round = 0; round < 4; ++round) {
        for (std::size_t u = 0; u < users.size(); ++u)
            EXPECT_TRUE(textOf(shared, users[u]) == alone[u]) << "user " << u << ", round " << round;
        if (round == 0) builds = shared.assets().builds();
        EXPECT_EQ(shared.assets().builds(), builds) << "round " << round;
    }
    for (const char* use : {"hall.environment", "fur.jump", "sdf_morph.mesh", "lenticular.views"})
        EXPECT_GE(shared.assets().builds(use), 2) << use;
    EXPECT_EQ(shared.assets().builds("fur.ringModel"), 1);
    EXPECT_EQ(shared.assets().builds("hall.model"), 1);
}

TEST(Planning, TheMeshDependsOnTheShapeAlone)
{
    const sdf_morph::SdfMorphTable& table = test::sdfTable();
    Scene scene;
    scene.object().set(table.shownAs, SdfShown::mesh);
    scene.object().set(table.tessellation, 6);
    const Museum own(allExhibits());
    (void)own.prepare(scene.sceneState, scene.request);
    ASSERT_EQ(own.assets().builds("sdf_morph.mesh"), 1);
    std::set<std::string> shape{"morph",         "majorRadius",  "minorRadius",     "mugRadius", "mugHeight",
                                "wallThickness", "handleRadius", "handleThickness", "blend",     "tessellation"};
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        const ParameterInfo& info = table.rows()[row];
        if (info.kind == Kind::color || info.name == "shownAs") continue;
        SCOPED_TRACE(info.name);
        Scene other = scene;
        const auto before = std::get<double>(scene.object().row(row));
        const double changed = info.kind == Kind::toggle   ? 1 - before
                               : info.kind == Kind::choice ? (before > 0 ? 0 : 1)
                               : info.kind == Kind::count  ? before + 1
                                                           : 0.9 * before + 0.001;
        other.object().setParameter(row, changed);
        ASSERT_NE(std::get<double>(other.object().row(row)), before);
        const std::int64_t builds = own.assets().builds("sdf_morph.mesh");
        (void)own.prepare(other.sceneState, other.request);
        EXPECT_EQ(own.assets().builds("sdf_morph.mesh") - builds, shape.contains(std::string(info.name)) ? 1 : 0);
    }
}

/// While an object exists, no file can be opened.
class NoFileCanBeOpened {
public:
    NoFileCanBeOpened()
    {
        getrlimit(RLIMIT_NOFILE, &before_);
        rlimit none = before_;
        none.rlim_cur = 0;
        setrlimit(RLIMIT_NOFILE, &none);
    }
    ~NoFileCanBeOpened() { setrlimit(RLIMIT_NOFILE, &before_); }
    NoFileCanBeOpened(const NoFileCanBeOpened&) = delete;
    NoFileCanBeOpened& operator=(const NoFileCanBeOpened&) = delete;

private:
    rlimit before_{};
};

TEST(LongPlanning, OpensNoFile)
{
    std::map<std::string, Scene> scenes = manyScenes(2);
    scenes.emplace("first user", twoUsers()[0]);
    scenes.emplace("second user", twoUsers()[1]);
    const Museum own(allExhibits());
    Scene unread;
    unread.hall().set(test::hallTable().environment, render::asset("frames/turning_mug/view_02.png").string());
    std::map<std::string, Prepared> prepared;
    std::map<std::string, std::string> expected;
    for (const auto& [name, scene] : scenes) {
        expected.emplace(name, textOf(museum(), scene));
        prepared.emplace(name, own.prepare(scene.sceneState, scene.request));
    }
    std::map<std::string, std::string> found;
    std::vector<Message> control;
    bool opened = true;
    {
        const NoFileCanBeOpened closed;
        const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        opened = file >= 0;
        if (opened) ::close(file);
        for (const auto& [name, scene] : scenes) {
            found.emplace(name, wholeText(own.plan(prepared.at(name), scene.request)));
            (void)own.nextChange(prepared.at(name), scene.request);
            (void)own.surroundings().pick(prepared.at(name), scene.request, {0.1, -0.1});
            (void)own.surroundings().lookedAt(prepared.at(name));
        }
        control = own.prepare(unread.sceneState, unread.request).unreadableFiles();
    }
    EXPECT_FALSE(opened) << "the control: files can be opened after all";
    EXPECT_EQ(control.size(), 1U) << "the control: preparing needs its file";
    for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name;
}

TEST(LongPlanning, ManyThreadsPrepareAndPlanAtOnce)
{
    const std::map<std::string, Scene> scenes = manyScenes(1);
    std::map<std::string, std::string> expected;
    for (const auto& [name, scene] : scenes) expected.emplace(name, textOf(museum(), scene));
    const Museum own(allExhibits());
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            // Each thread starts at another scene, so that all scenes are planned concurrently.
            auto at = std::next(scenes.begin(), static_cast<std::ptrdiff_t>(t * scenes.size() / 4));
            for (std::size_t n = 0; n < scenes.size(); ++n) {
                wrong += textOf(own, at->second) != expected.at(at->first);
                if (++at == scenes.end()) at = scenes.begin();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST(Planning, WhatWasNotPreparedForAViewIsLeftOutOfItAndTheFrameReportSaysSo)
{
    Scene scene;
    const std::size_t fur = *museum().find("fur");
    scene.see({-2, 1.65, 3}, {-6, 1.65, 3.2});
    scene.hall().set(test::hallTable().sunShadows, false);
    const Prepared prepared = museum().prepare(scene.sceneState, scene.request);
    ASSERT_EQ(test::reasonFor(museum().plan(prepared, scene.request), "fur"), "out of view");
    scene.see(museum().bestView(fur, scene.sceneState.values[fur]));
    EXPECT_EQ(test::reasonFor(museum().plan(prepared, scene.request), "fur"), "it was not prepared for this view");
    EXPECT_EQ(test::reasonFor(scene.plan(), "fur/coat"), "it ran");
}

}  // namespace
}  // namespace vitrine
