// The fur's work in a frame: none while it is asleep or out of view, and no more than is visible.

#include "exhibits/fur/fur.h"
#include "exhibits/sdf_morph/sdf_morph.h"
#include "render/plan/diagnostics.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vitrine::fur {
namespace {

using namespace test;

const FurTable& furTable()
{
    static const FurTable made;
    return made;
}

/// Returns the hall with only the torus-mug and the fur, because other exhibits may be animated.
const Museum& museumOfFur()
{
    static const Museum opened = [] {
        std::vector<std::unique_ptr<Exhibit>> guests;
        guests.push_back(std::make_unique<sdf_morph::SdfMorph>());
        guests.push_back(std::make_unique<Fur>());
        return Museum(std::move(guests));
    }();
    return opened;
}

struct FurScene : test::Scene {
    std::size_t fur = *museumOfFur().find("fur");

    FurScene()
    {
        sceneState = museumOfFur().initialSceneState();
        see(museumOfFur().bestView(fur, values()));
    }
    [[nodiscard]] render::FramePlan plan(const render::PersistentState& kept = {}) const
    {
        return test::planned(museumOfFur(), sceneState, request, kept);
    }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[fur]; }
    void press(double since)
    {
        request.sincePressed.assign(fur + 1, never);
        request.sincePressed[fur] = since;
    }
    [[nodiscard]] double next() const { return test::nextChange(museumOfFur(), sceneState, request); }
};

TEST(FurPlan, AsleepTakesNoStepAndAsksForNoFrame)
{
    FurScene scene;
    const render::FramePlan plan = scene.plan();
    EXPECT_EQ(reasonFor(plan, "fur/motion"), "at rest");
    EXPECT_TRUE(runs(plan, "fur/coat"));
    EXPECT_EQ(scene.next(), never);
}

TEST(FurPlan, WakesWithinOneFrameOfTheButton)
{
    FurScene scene;
    for (const double since : {0.0, 1.0 / 240, 0.8}) {
        scene.press(since);
        EXPECT_EQ(scene.next(), 0) << since;
    }
    const render::FramePlan plan = scene.plan();
    const render::Pass* motion = plan.find("fur/motion");
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->work, render::Work::simulation);
    EXPECT_EQ(motion->reason, "woken by the button 0.8 s ago");
}

TEST(FurPlan, CountsTheStepsFromThePressToTheMomentWhoeverSimulatedThem)
{
    FurScene scene;
    scene.values().set(furTable().toss, 77);  // A jump that is not simulated yet.
    const auto steps = [](const render::FramePlan& plan) {
        const render::Pass* motion = plan.find("fur/motion");
        return motion ? motion->counts.at("simulationSteps") : -1;
    };
    const std::int64_t before = museumOfFur().assets().builds("fur.jump");
    for (const double since : {0.5, 0.5, 0.6, 0.1}) {
        scene.press(since);
        EXPECT_EQ(steps(scene.plan()), std::llround(240 * since));
    }
    EXPECT_EQ(museumOfFur().assets().builds("fur.jump"), before + 1) << "one jump is simulated once";
}

TEST(FurPlan, SleepsAgainWhenTheJumpIsOver)
{
    FurScene scene;
    const render::FramePlan before = scene.plan();
    for (const double since : {20.0, 3600.0, 1e9}) {
        scene.press(since);
        (void)scene.plan();  // Simulates the rest of the jump once.
        const render::FramePlan plan = scene.plan();
        EXPECT_EQ(reasonFor(plan, "fur/motion").rfind("at rest", 0), 0U) << reasonFor(plan, "fur/motion");
        EXPECT_EQ(scene.next(), never);
        EXPECT_EQ(plan.find("fur/coat")->draws[0].object, before.find("fur/coat")->draws[0].object)
            << "it woke somewhere else";
    }
}

TEST(FurPlan, OutOfViewTakesNoStepAndNoPass)
{
    FurScene scene;
    scene.press(0.8);
    scene.see({-2, 1.65, 3}, {-6, 1.65, 3.2});
    const render::FramePlan plan = scene.plan();
    EXPECT_FALSE(runs(plan, "fur/"));
    EXPECT_EQ(reasonFor(plan, "fur"), "out of view");
    EXPECT_EQ(reasonFor(plan, "fur/motion"), "not in the plan");
    scene.press(5);
    EXPECT_EQ(scene.next(), never);
}

TEST(FurPlan, DrawsOnlyTheBodyThatIsInView)
{
    FurScene scene;
    // Straight down at the ball, with a narrow field of view.
    const glm::dvec3 ball = glm::dvec3(museumOfFur().worldFromExhibit(scene.fur)[3]) + glm::dvec3(-0.62, 0.3, -0.02);
    scene.see({ball + glm::dvec3(-0.1, 1.3, 0.01), ball - glm::dvec3(0.1, 0, 0), 0.2});
    const render::FramePlan plan = scene.plan();
    const render::Pass* coat = plan.find("fur/coat");
    ASSERT_TRUE(coat);
    EXPECT_EQ(coat->reason, "in view: ball");
    EXPECT_EQ(coat->draws.size(), 1U);
}

TEST(FurPlan, DrawsEachBodyWithAllItsShellsInOneCall)
{
    FurScene scene;
    scene.values().set(furTable().levelOfDetail, false);
    for (const int shells : {1, 2, 16, 256}) {
        scene.values().set(furTable().shellCount, shells);
        const render::FramePlan plan = scene.plan();
        const render::Pass* coat = plan.find("fur/coat");
        ASSERT_EQ(coat->draws.size(), 3U);
        for (const render::Draw& draw : coat->draws) EXPECT_EQ(draw.instances, shells);
        EXPECT_EQ(coat->counts.at("shells"), 3 * shells);
    }
    scene.values().set(furTable().coats[furBall].length, 0.0);
    EXPECT_EQ(scene.plan().find("fur/coat")->draws[0].instances, 1) << "a bare skin has no shells";
}

TEST(FurPlan, DrawsFewerShellsFromAfar)
{
    FurScene scene;
    const auto shells = [&] { return scene.plan().find("fur/coat")->counts.at("shells"); };
    scene.request.raster.size = {1280, 720};
    const auto near = shells();
    scene.see({3.3, 1.65, 11.5}, {3.3, 0.1, 3});
    EXPECT_LT(shells(), near);
    scene.values().set(furTable().levelOfDetail, false);
    EXPECT_EQ(shells(), 3 * scene.values()[furTable().shellCount]);
}

TEST(FurPlan, AFrozenOrHandSetMomentNeverChangesByItself)
{
    FurScene scene;
    scene.values().set(furTable().frozenAt, 0.4);
    EXPECT_EQ(scene.next(), never);
    (void)scene.plan();
    EXPECT_EQ(reasonFor(scene.plan(), "fur/motion"), "frozen 0.4 s after the jump");
    scene.values().set(furTable().frozenAt, 0.0);
    scene.values().set(furTable().byHand, true);
    scene.press(0.3);
    EXPECT_EQ(scene.next(), never);
    EXPECT_EQ(reasonFor(scene.plan(), "fur/motion"), "set by hand");
}

TEST(FurPlan, MovesByItselfOnlyWhenAsked)
{
    for (const auto& ask : {+[](ParameterValues& v) { v.set(furTable().wind, 1.0); },
                            +[](ParameterValues& v) { v.set(furTable().growing, true); },
                            +[](ParameterValues& v) { v.set(furTable().bouncePeriod, 8.0); }}) {
        FurScene scene;
        ask(scene.values());
        EXPECT_EQ(scene.next(), 0);
    }
    FurScene steady;
    steady.values().set(furTable().wind, 1.0);
    steady.values().set(furTable().gustiness, 0.0);
    EXPECT_EQ(steady.next(), never) << "a draft without gusts leans on the fur and leaves it there";
}

TEST(FurPlan, PressingOneButtonWakesNoOtherExhibit)
{
    FurScene scene;
    scene.request.sincePressed.assign(scene.fur + 1, never);
    scene.request.sincePressed[*museumOfFur().find("sdf_morph")] = 0.8;
    EXPECT_EQ(reasonFor(scene.plan(), "fur/motion"), "at rest");
    EXPECT_EQ(scene.next(), never);
}

TEST(FurPlan, SurvivesABrokenClock)
{
    FurScene scene;
    const render::FramePlan rest = scene.plan();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1.0, -1e300, never}) {
        scene.press(bad);
        EXPECT_EQ(reasonFor(scene.plan(), "fur/motion"), "at rest") << bad;
        EXPECT_EQ(scene.plan().find("fur/coat")->draws[0].object, rest.find("fur/coat")->draws[0].object) << bad;
    }
}

TEST(FurPlan, TellsTheLogOncePerStretchOfABrokenClock)
{
    FurScene scene;
    render::Diagnostics log;
    const auto lines = [&](double time, double since) {
        scene.request.time = time;
        scene.press(since);
        return log.begun(scene.plan().skipped());
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(lines(0, never).empty());
    for (const double right : {0.0, 5e-324, 1.0 / 60, 10.0, 1e9}) EXPECT_TRUE(lines(right, right).empty()) << right;
    const std::vector<render::CulledPass> first = lines(nan, 0.5);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(lineOf(first[0]).rfind("fur/clock: the time is no number", 0), 0U) << lineOf(first[0]);
    // Continuing errors of the clock are reported once.
    for (const double bad : {nan, -1.0, -0.5, never}) EXPECT_TRUE(lines(bad == -0.5 ? 0.0 : nan, bad).empty()) << bad;
    EXPECT_TRUE(lines(0, -1e-300).empty());
    EXPECT_TRUE(lines(1, 0.5).empty());
    EXPECT_EQ(lines(1, -0.5).size(), 1U) << "a second stretch has a line of its own";
    EXPECT_EQ(reasonFor(scene.plan(), "fur/motion"), "at rest");
}

TEST(FurPlan, ABrokenClockMovesNothing)
{
    FurScene scene;
    scene.values().set(furTable().wind, 1.0);
    scene.values().set(furTable().growing, true);
    const auto body = [&](double time) {
        scene.request.time = time;
        return scene.plan().find("fur/coat")->draws[0].object;
    };
    const auto still = body(0);
    EXPECT_NE(body(0.7), still);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), never, -never})
        EXPECT_EQ(body(bad), still) << bad;
}

TEST(FurPlan, DressesAModelOfItsOwnByItsPlaceAmongTheAssets)
{
    FurScene scene;
    scene.values().set(furTable().ringModel, std::string("models/teddy.glb"));
    const render::FramePlan plan = scene.plan();
    const render::Pass* coat = plan.find("fur/coat");
    ASSERT_EQ(coat->draws.size(), 3U);
    EXPECT_EQ(coat->draws[2].mesh->name, "model");
    EXPECT_TRUE(render::Diagnostics().begun(plan.skipped()).empty());
    scene.values().set(furTable().silhouette, FurSilhouette::fins);
    EXPECT_EQ(scene.plan().find("fur/fins")->draws.size(), 3U) << "a model has fins as well";
}

}  // namespace
}  // namespace vitrine::fur
