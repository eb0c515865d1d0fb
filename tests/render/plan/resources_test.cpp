// Histories, work over several frames, buffers and handles in plans, without a GPU.

#include "render/plan/frame_plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace vitrine {
namespace {

using namespace render;

Pass drawn(std::string name, std::vector<std::string> reads, std::string writes, Load load = Load::clear)
{
    Pass pass;
    pass.name = std::move(name);
    for (std::string& image : reads) pass.inputs.push_back({0, std::move(image)});
    pass.colors = {{std::move(writes), load, {}, -1, 0}};
    return pass;
}

// ---- histories

struct Accumulated {
    Camera camera{{0, 1, 5}, {0, 1, 0}};
    Raster raster{.size = {64, 36}};
    double time = 1;
    bool cut = false;
    std::uint64_t values = 7;
    History history{.image = {.name = "mist"}, .dependencies = {}};

    [[nodiscard]] FramePlan plan(const PersistentState& kept = {}) const
    {
        FramePlan plan;
        plan.view = makeView(camera, raster);
        plan.time = time;
        plan.resetHistory = cut;
        History declared = history;
        declared.dependencies = {{"a value changed", values}};
        const ResourceId mist = plan.history(std::move(declared));
        plan.image({.name = "frame"});
        plan.add(drawn("march", {previous(mist)}, mist));
        plan.add(drawn("show", {mist}, "frame"));
        plan.prune({"frame"}, kept);
        return plan;
    }
    /// Returns the persistent state of a renderer that drew the plan.
    [[nodiscard]] PersistentState persistentState() const
    {
        const FramePlan last = plan();
        const HistoryState& state = last.histories().at("mist");
        return {.histories = {{"mist", {state.history.image, last.view, last.time, state.history.dependencies}}}};
    }
    [[nodiscard]] std::string resetAfter(const Accumulated& last) const
    {
        return plan(last.persistentState()).histories().at("mist").reset;
    }
};

TEST(History, StartsWithNothingAndIsValidInTheNextFrame)
{
    const Accumulated scene;
    const FramePlan first = scene.plan();
    EXPECT_FALSE(first.histories().at("mist").valid);
    EXPECT_FALSE(first.find("march")->temporal.valid);
    EXPECT_NE(first.find("march")->reason.find("its history starts again: nothing was drawn before"),
              std::string::npos);

    const FramePlan second = scene.plan(scene.persistentState());
    EXPECT_TRUE(second.find("march")->temporal.used);
    EXPECT_TRUE(second.find("march")->temporal.valid);
    EXPECT_EQ(second.find("march")->reason.find("starts again"), std::string::npos);
    EXPECT_FALSE(second.find("show")->temporal.used) << "it reads this frame's content only";
    EXPECT_TRUE(second.errors().empty());
}

TEST(History, FollowsACameraThatMovesALittle)
{
    const Accumulated last;
    Accumulated now;
    now.camera.eye = {0.2, 1, 5};
    now.raster.jitter = {0.25, -0.25};
    now.time = 1.2;
    const FramePlan plan = now.plan(last.persistentState());
    EXPECT_TRUE(plan.histories().at("mist").valid) << plan.histories().at("mist").reset;
    EXPECT_EQ(plan.find("march")->temporal.lastView.eye, last.camera.eye) << "what to reproject from";
}

TEST(History, IsResetByWhateverMakesItWorthless)
{
    const Accumulated last;
    const auto reset = [&](const auto& change) {
        Accumulated now;
        change(now);
        return now.resetAfter(last);
    };
    EXPECT_EQ(reset([](Accumulated& a) { a.camera.eye.x = 1.5; }), "the camera jumped");
    EXPECT_EQ(reset([](Accumulated& a) { a.camera.target = {5, 1, 4}; }), "the camera turned too far");
    EXPECT_EQ(reset([](Accumulated& a) { a.camera.fovY = 0.5; }), "the field of view changed");
    EXPECT_EQ(reset([](Accumulated& a) { a.raster.size = {65, 36}; }), "the size of the picture changed");
    EXPECT_EQ(reset([](Accumulated& a) { a.raster.tile = {32, 36}; }), "another tile is drawn");
    EXPECT_EQ(reset([](Accumulated& a) { a.time = 0.9; }), "the clock jumped");
    EXPECT_EQ(reset([](Accumulated& a) { a.time = 9; }), "the clock jumped");
    EXPECT_EQ(reset([](Accumulated& a) { a.time = std::numeric_limits<double>::quiet_NaN(); }), "the clock jumped");
    EXPECT_EQ(reset([](Accumulated& a) { a.cut = true; }), "the frame does not continue the last one");
    EXPECT_EQ(reset([](Accumulated& a) { a.values = 8; }), "a value changed");
    EXPECT_EQ(reset([](Accumulated& a) { a.history.image.format = Format::rgba32f; }), "the image has another form");
    EXPECT_EQ(reset([](Accumulated&) {}), "");
}

TEST(History, WithItsOwnPixelsOutlivesAnotherTile)
{
    Accumulated last;
    last.history.image.divisor = 4;
    Accumulated now = last;
    now.raster.tile = {32, 36};
    EXPECT_EQ(now.resetAfter(last), "");
}

TEST(History, ThatOnlyTheNextFrameReadsIsWrittenAllTheSame)
{
    FramePlan plan;
    plan.history({.image = {.name = "moments"}});
    plan.image({.name = "frame"});
    plan.add(drawn("before", {previous("moments")}, "frame"));
    plan.add(drawn("moments", {}, "moments"));  // After its reader: a walk from the end meets it first.
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "before > moments");

    FramePlan unread;
    unread.history({.image = {.name = "moments"}});
    unread.image({.name = "frame"});
    unread.add(drawn("picture", {}, "frame"));
    unread.add(drawn("moments", {previous("moments")}, "moments"));
    unread.prune({"frame"});
    EXPECT_EQ(toString(unread), "picture") << "a history that feeds itself alone is called for by nothing";
}

// ---- slices

FramePlan baked(std::uint64_t key, const PersistentState& kept = {}, bool allSlices = false)
{
    FramePlan plan;
    plan.allSlices = allSlices;
    plan.image({.name = "volume", .type = TextureType::volume, .size = {8, 8}, .layers = 8});
    plan.image({.name = "light", .persistent = true});
    plan.image({.name = "frame"});
    Pass bake = drawn("bake", {}, "volume");
    bake.reason = "the density is baked";
    bake.sliceCount = 3;
    bake.contentHash = key;
    plan.add(std::move(bake));
    Pass light = drawn("light", {"volume"}, "light");
    light.contentHash = key + 100;
    plan.add(std::move(light));
    plan.add(drawn("show", {"volume", "light"}, "frame"));
    plan.prune({"frame"}, kept);
    return plan;
}

TEST(Parts, RunOnePerFrameAndSaySo)
{
    const FramePlan first = baked(1);
    EXPECT_EQ(first.find("bake")->reason, "the density is baked, part 1 of 3");
    EXPECT_EQ(first.find("bake")->colors[0].load, Load::clear);
    EXPECT_TRUE(first.unfinished());
    EXPECT_FALSE(first.find("show")->temporal.valid) << "nothing whole was ever made";
    EXPECT_TRUE(first.find("light")->temporal.provisional) << "what is made of it must be made again";

    const FramePlan third = baked(1, {.slices = {{"bake", {1, 2, false}}}});
    EXPECT_EQ(third.find("bake")->reason, "the density is baked, part 3 of 3");
    EXPECT_EQ(third.find("bake")->colors[0].load, Load::keep) << "what the other parts drew stays";
    EXPECT_FALSE(third.unfinished());
    EXPECT_TRUE(third.find("show")->temporal.valid);
    EXPECT_FALSE(third.find("light")->temporal.provisional);

    const FramePlan after = baked(1, {.passes = {{"bake", 1}, {"light", 101}}, .slices = {{"bake", {1, 3, true}}}});
    EXPECT_EQ(toString(after), "show");
    EXPECT_TRUE(after.find("show")->temporal.valid);
    EXPECT_FALSE(after.unfinished());
}

TEST(Parts, StartAgainWhenTheirKeyChangesWhileTheLastWholeResultIsRead)
{
    const FramePlan half = baked(2, {.slices = {{"bake", {1, 2, false}}}});
    EXPECT_EQ(half.find("bake")->temporal.firstSlice, 0);
    EXPECT_FALSE(half.find("show")->temporal.valid);
    const FramePlan whole = baked(2, {.passes = {{"bake", 1}}, .slices = {{"bake", {1, 3, true}}}});
    EXPECT_EQ(whole.find("bake")->temporal.firstSlice, 0);
    EXPECT_TRUE(whole.find("show")->temporal.valid);
    EXPECT_TRUE(whole.unfinished());
}

TEST(Parts, AreDoneAtOnceForPicturesThatAreNotRedrawn)
{
    const FramePlan plan = baked(1, {.slices = {{"bake", {1, 1, false}}}}, true);
    EXPECT_EQ(plan.find("bake")->reason, "the density is baked, parts 2 to 3 of 3");
    EXPECT_FALSE(plan.unfinished());
    EXPECT_TRUE(plan.find("show")->temporal.valid);
}

// ---- buffers

Pass writesBuffer(std::string name, const std::string& buffer, Access access)
{
    Pass pass;
    pass.name = std::move(name);
    pass.work = Work::compute;
    pass.buffers = {{0, buffer, access}};
    return pass;
}

TEST(Buffers, AreFollowedLikeImages)
{
    FramePlan plan;
    const ResourceId places = plan.buffer({.name = "places", .bytes = 64});
    plan.buffer({.name = "unread", .bytes = 64});
    plan.image({.name = "frame"});
    plan.add(writesBuffer("wiped", places, Access::readWrite));
    plan.add(writesBuffer("place", places, Access::write));
    plan.add(writesBuffer("move", places, Access::readWrite));
    plan.add(writesBuffer("dead", "unread", Access::write));
    Pass draw = drawn("draw", {}, "frame");
    draw.draws = {{.instances = 4, .buffers = {{0, places}}}};
    plan.add(std::move(draw));
    EXPECT_TRUE(plan.errors().empty());
    plan.prune({"frame"});
    EXPECT_EQ(toString(plan), "place > move > draw");
}

TEST(Buffers, ThatAreKeptNeedNotBeWrittenAgain)
{
    for (const bool isKept : {true, false}) {
        FramePlan plan;
        plan.buffer({.name = "places", .bytes = 64, .persistent = isKept});
        Pass place = writesBuffer("place", "places", Access::write);
        place.contentHash = 3;
        plan.add(std::move(place));
        Pass draw = drawn("draw", {}, "frame");
        draw.buffers = {{0, std::string("places")}};
        plan.add(std::move(draw));
        plan.prune({"frame"}, {.passes = {{"place", 3}}});
        EXPECT_EQ(toString(plan), isKept ? "draw" : "place > draw");
    }
}

// ---- names

TEST(Errors, NameWhatNobodyDeclared)
{
    FramePlan plan;
    const ResourceId frame = plan.image({.name = "frame"});
    plan.add(drawn("typo", {"radianse"}, frame));
    EXPECT_EQ(plan.errors(),
              std::vector<std::string>{"typo uses the image \"radianse\", which the plan does not declare"});

    FramePlan noHistory;
    noHistory.image({.name = "frame"});
    noHistory.add(drawn("past", {previous("frame")}, "frame"));
    EXPECT_EQ(noHistory.errors().size(), 1U) << "an image that is no history has no last frame";

    FramePlan noBuffer;
    noBuffer.add(writesBuffer("place", "placez", Access::write));
    EXPECT_EQ(noBuffer.errors(),
              std::vector<std::string>{"place uses the buffer \"placez\", which the plan does not declare"});
}

}  // namespace
}  // namespace vitrine
