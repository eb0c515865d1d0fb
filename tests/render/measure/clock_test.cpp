// Clocks of the present driver, and the counters of driver and plan.

#include "render/gl/frame_clock.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

namespace vitrine {
namespace {

using namespace test;

using Clock = GlTest;

TEST_F(Clock, OnASoftwareRendererTheProcessorIsTheClock)
{
    const render::ClockChoice& choice = render::gl::trustedClock(gallery().context.info().software);
    if (!gallery().context.info().software) GTEST_SKIP() << "a GPU";
    EXPECT_EQ(choice.method, render::ClockMethod::cpu);
    EXPECT_TRUE(choice.trusted) << choice.why;
    EXPECT_GT(choice.overheadSeconds, 0);
    EXPECT_LT(choice.overheadSeconds, 1e-3);
    EXPECT_NE(choice.why.find("times the work"), std::string::npos);
}

TEST_F(Clock, EveryReportNamesItsClockAndWhatItCosts)
{
    const render::FrameReport report = Shot().take().report;
    EXPECT_EQ(report.clock, render::gl::trustedClock(true).name);
    EXPECT_TRUE(report.clockTrusted);
    EXPECT_GT(report.milliseconds, 0);
    // A frame is timed as a whole: two marks, whatever the number of its passes.
    EXPECT_GT(report.ran.size(), 2U);
    EXPECT_DOUBLE_EQ(report.overheadMilliseconds, 1e3 * render::gl::trustedClock(true).overheadSeconds);
    // Timing costs less than 2 % of the smallest picture. Both are processor times, so that other programs have no
    // influence.
    EXPECT_LT(report.overheadMilliseconds, 0.02 * report.milliseconds);
}

TEST_F(Clock, TimesOfStepsAddUpToNoMoreThanTheFrame)
{
    Shot shot;
    shot.inHall();
    render::gl::Renderer& renderer = gallery().renderer;
    renderer.timeSteps(true);
    const render::FrameReport report =
        renderer.draw(test::planned(gallery().museum, shot.sceneState, shot.request.frame, renderer.persistentState()));
    renderer.timeSteps(false);
    double sum = 0;
    for (const render::StepReport& step : report.ran) {
        EXPECT_GE(step.milliseconds, 0) << step.name;
        sum += step.milliseconds;
    }
    EXPECT_LE(sum, report.milliseconds * (1 + 1e-9));
    EXPECT_GT(sum, 0);
}

/// Returns a plan with one pass that covers an image of this size.
render::FramePlan covering(glm::ivec2 size)
{
    render::FramePlan plan;
    plan.view = render::makeView({{0, 0, 1}, {0, 0, 0}, 1}, {.size = size});
    plan.image({.name = "source", .format = render::Format::rgba8});
    plan.image({.name = "target", .format = render::Format::rgba8});
    render::Pass pass;
    pass.name = "cover";
    pass.shader = {"lib/fullscreen.vert", "lib/copy.frag", "", {}};
    pass.inputs = {{12, std::string("source")}};
    pass.colors = {{"target", render::Load::clear, {}, -1, 0}};
    pass.draws = {render::Draw{}};
    plan.add(std::move(pass));
    return plan;
}

TEST_F(Clock, APassThatCoversThePictureLetsEachOfItsPixelsPassOnce)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(37, 19), glm::ivec2(128, 64)}) {
        render::FramePlan plan = covering(size);
        render::Pass pass = plan.passes().front();
        pass.countSamples = true;
        pass.name = "counted";
        pass.draws.resize(3);
        plan.add(std::move(pass));
        render::gl::Renderer renderer;
        const render::FrameReport report = renderer.draw(plan);
        EXPECT_EQ(report.counters.at("samples"), 3 * size.x * size.y) << "the pass that is not counted must not be";
    }
}

TEST_F(Clock, WorkThatThePlanKnowsIsAddedToTheCounters)
{
    render::FramePlan plan = covering({16, 8});
    render::Pass pass = plan.passes().front();
    pass.name = "again";
    pass.counts = {{"fetches", 1'000'000'000'000}, {"marchSteps", 7}};
    plan.add(pass);
    pass.name = "and again";
    pass.counts = {{"fetches", 1}};
    plan.add(pass);
    render::gl::Renderer renderer;
    const render::FrameReport report = renderer.draw(plan);
    EXPECT_EQ(report.counters.at("fetches"), 1'000'000'000'001);
    EXPECT_EQ(report.counters.at("marchSteps"), 7);
    EXPECT_EQ(report.counters.count("samples"), 0U) << "nobody asked for them";
    EXPECT_EQ(report.counters.at("draws"), 3);
}

}  // namespace
}  // namespace vitrine
