#include "render/plan/frame_plan.h"
#include "tests/support/plan_steps.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace render;
using test::reasonFor;

Pass pass(std::string name, std::vector<std::string> reads, std::string writes, Load load = Load::keep)
{
    Pass p;
    p.name = std::move(name);
    for (std::string& image : reads) p.inputs.push_back({0, std::move(image)});
    p.colors = {{std::move(writes), load, {}, -1, 0}};
    return p;
}

TEST(FramePlan, APassThatCanChangeNothingIsNotRunUnlessEverythingIs)
{
    for (const bool everything : {false, true}) {
        FramePlan plan;
        plan.runEverything = everything;
        Pass invisible = pass("invisible", {}, "a");
        invisible.bound = boundOf(0, 1, {{0, "its strength is 0"}});
        plan.add(std::move(invisible));
        Pass faint = pass("faint", {}, "a");
        faint.bound = boundOf(0, 1, {{1e-12, "its strength is 0"}});
        plan.add(std::move(faint));
        plan.prune({"a"});
        EXPECT_EQ(toString(plan), everything ? "invisible > faint" : "faint");
        if (!everything) {
            EXPECT_EQ(reasonFor(plan, "invisible"), "its strength is 0");
            EXPECT_TRUE(plan.findSkipped("invisible")->boundIsZero);
        }
    }
}

TEST(FramePlan, DropsWhatNothingReadsAndSaysSo)
{
    FramePlan plan;
    plan.add(pass("used", {}, "a"));
    plan.add(pass("dead", {}, "b"));
    plan.add(pass("deadToo", {"b"}, "c"));
    plan.add(pass("last", {"a"}, "frame"));
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "used > last");
    EXPECT_EQ(reasonFor(plan, "dead"), "its output is not used");
    EXPECT_EQ(reasonFor(plan, "deadToo"), "its output is not used");
    EXPECT_EQ(reasonFor(plan, "used"), "it ran");
}

TEST(FramePlan, KeepsEveryWriterOfAnImageThatIsOnlyAddedTo)
{
    FramePlan plan;
    plan.add(pass("first", {}, "frame", Load::clear));
    plan.add(pass("second", {}, "frame"));
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "first > second");
}

TEST(FramePlan, LosesInterestInWhatAClearWipesAway)
{
    FramePlan plan;
    plan.add(pass("wasted", {}, "frame"));
    plan.add(pass("fresh", {}, "frame", Load::clear));
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "fresh");
    EXPECT_EQ(reasonFor(plan, "wasted"), "its output is not used");
}

TEST(FramePlan, AClearOfOneLayerOrLevelLeavesTheOthersOfInterest)
{
    for (const bool layer : {true, false}) {
        FramePlan plan;
        plan.add(pass("whole", {}, "cube"));
        Pass part = pass("part", {}, "cube", Load::clear);
        (layer ? part.colors[0].layer : part.colors[0].level) = 1;
        plan.add(std::move(part));
        plan.prune({"cube"});
        EXPECT_EQ(toString(plan), "whole > part");
    }
}

TEST(FramePlan, SortsByStageAndKeepsTheOrderWithinOne)
{
    FramePlan plan;
    for (const auto& [name, stage] :
         std::initializer_list<std::pair<const char*, PassPhase>>{{"tone", PassPhase::resolve},
                                                                  {"b", PassPhase::opaque},
                                                                  {"shadow", PassPhase::shadow},
                                                                  {"a", PassPhase::opaque}}) {
        Pass p = pass(name, {}, "frame");
        p.phase = stage;
        plan.add(std::move(p));
    }
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "shadow > b > a > tone");
}

/// Returns a plan with a persistent shadow map that `last` reads.
FramePlan withPersistentMap(std::uint64_t key, bool kept = true)
{
    FramePlan plan;
    plan.image({.name = "map", .size = {8, 8}, .persistent = kept});
    Pass map = pass("map", {}, "map", Load::clear);
    map.contentHash = key;
    plan.add(std::move(map));
    plan.add(pass("last", {"map"}, "frame"));
    return plan;
}

TEST(FramePlan, SkipsWhatIsKeptAndUnchanged)
{
    FramePlan same = withPersistentMap(7);
    same.prune({"frame"}, {.passes = {{"map", 7}}});
    EXPECT_EQ(toString(same), "last");
    EXPECT_EQ(reasonFor(same, "map"), "unchanged since it last ran");

    FramePlan changed = withPersistentMap(8);
    changed.prune({"frame"}, {.passes = {{"map", 7}}});
    EXPECT_EQ(toString(changed), "map > last");

    FramePlan never = withPersistentMap(7);
    never.prune({"frame"});
    EXPECT_EQ(toString(never), "map > last");
}

TEST(FramePlan, RunsAgainWhenTheImageItWroteWasNotKept)
{
    FramePlan plan = withPersistentMap(7, false);
    plan.prune({"frame"}, {.passes = {{"map", 7}}});
    EXPECT_EQ(toString(plan), "map > last");
}

TEST(FramePlan, DropsWhatFedOnlyAnUnchangedPass)
{
    FramePlan plan;
    plan.image({.name = "map", .persistent = true});
    plan.add(pass("feeds", {}, "temporary", Load::clear));
    Pass map = pass("map", {"temporary"}, "map", Load::clear);
    map.contentHash = 7;
    plan.add(std::move(map));
    plan.add(pass("last", {"map"}, "frame"));
    plan.prune({"frame"}, {.passes = {{"map", 7}}});
    EXPECT_EQ(toString(plan), "last");
    EXPECT_EQ(reasonFor(plan, "feeds"), "its output is not used");
}

TEST(FramePlan, RunsEverythingWhenAskedTo)
{
    FramePlan plan = withPersistentMap(7);
    plan.add(pass("dead", {}, "unread"));
    plan.runEverything = true;
    plan.prune({"frame"}, {.passes = {{"map", 7}}});
    EXPECT_EQ(toString(plan), "map > last > dead");
    EXPECT_TRUE(plan.skipped().empty());
}

TEST(FramePlan, CountsSimulationStatesAndDepthAsOutputs)
{
    FramePlan plan;
    Pass step;
    step.name = "step";
    step.work = Work::simulation;
    step.writes = {"springs"};
    plan.add(std::move(step));
    Pass idle;
    idle.name = "idle";
    idle.work = Work::simulation;
    idle.writes = {"smoke"};
    plan.add(std::move(idle));
    Pass draw = pass("draw", {}, "frame");
    draw.reads = {"springs"};
    draw.depth = Attachment{"depth", Load::clear, {}, -1, 0};
    plan.add(std::move(draw));
    plan.prune({"depth"});
    EXPECT_EQ(toString(plan), "step > draw");
    ASSERT_TRUE(plan.findSkipped("idle"));
    EXPECT_EQ(plan.findSkipped("idle")->work, Work::simulation);
}

TEST(FramePlan, ReadsWhatItsDrawsRead)
{
    FramePlan plan;
    plan.add(pass("map", {}, "map"));
    Pass draw = pass("draw", {}, "frame");
    Draw one;
    one.inputs = {{3, std::string("map")}};
    draw.draws = {one};
    plan.add(std::move(draw));
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "map > draw");
}

}  // namespace
}  // namespace vitrine
