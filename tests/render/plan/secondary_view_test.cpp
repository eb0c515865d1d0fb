// Secondary views, as in mirrors and portals: the passes and images of a plan that they copy.

#include "render/plan/secondary_view.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>

namespace vitrine {
namespace {

using namespace render;

const View visitor = makeView({{1, 2, 6}, {0, 0.5, 0}, 0.9, {0.1, 0}}, {.size = {64, 36}});

/// Returns a plan with a shadow map, a depth pre-pass, a surface that reads both, a compute pass for particles, and
/// tone mapping.
FramePlan scene()
{
    FramePlan plan;
    plan.view = visitor;
    plan.image({.name = "shadow", .format = Format::depth32f, .size = {16, 16}, .persistent = true});
    plan.image({.name = "cones", .format = Format::r32f, .scale = 0.125});
    plan.image({.name = "blocks", .format = Format::r32f, .divisor = 4});
    plan.image({.name = "radiance"});
    plan.image({.name = "depth", .format = Format::depth32f});
    plan.buffer({.name = "particles", .bytes = 16});
    Pass shadow;
    shadow.name = "shadow";
    shadow.phase = PassPhase::shadow;
    shadow.depth = Attachment::cleared("shadow");
    plan.add(std::move(shadow));
    Pass move;
    move.name = "move";
    move.phase = PassPhase::simulate;
    move.work = Work::compute;
    move.buffers = {{1, std::string("particles"), Access::readWrite}};
    plan.add(std::move(move));
    Pass surface;
    surface.name = "surface";
    surface.phase = PassPhase::opaque;
    surface.inputs = {{0, std::string("shadow")}, {1, std::string("cones")}, {2, std::string("blocks")}};
    surface.buffers = {{1, std::string("particles")}};
    surface.colors = {Attachment::cleared("radiance")};
    surface.depth = Attachment::cleared("depth");
    plan.add(std::move(surface));
    for (const char* image : {"cones", "blocks"}) {
        Pass prepares;
        prepares.name = image;
        prepares.phase = PassPhase::prepare;
        prepares.colors = {Attachment::cleared(image)};
        plan.add(std::move(prepares));
    }
    return plan;
}

TEST(SecondaryView, CopiesWhatDependsOnTheViewIntoImagesOfItsOwn)
{
    FramePlan plan = scene();
    SecondaryView mirror{.name = "lake", .reason = "the lake mirrors it", .view = visitor};
    mirror.view.raster = {.size = {33, 20}};
    const std::map<std::string, std::string> names = addSecondaryView(plan, scene(), mirror);
    EXPECT_EQ(names, (std::map<std::string, std::string>{{"blocks", "lake.blocks"},
                                                         {"cones", "lake.cones"},
                                                         {"depth", "lake.depth"},
                                                         {"radiance", "lake.radiance"}}));
    EXPECT_TRUE(plan.errors().empty());

    Pass water;
    water.name = "water";
    water.phase = PassPhase::transparent;
    water.inputs = {{0, names.at("radiance")}};
    water.colors = {Attachment::whole("radiance")};
    plan.add(std::move(water));
    plan.prune({"radiance"});
    EXPECT_EQ(toString(plan),
              "move > shadow > cones > blocks > lake/cones > lake/blocks > lake/surface > surface > water");

    const Pass& copy = *plan.find("lake/surface");
    EXPECT_EQ(copy.reason, "the lake mirrors it");
    EXPECT_EQ(std::get<std::string>(copy.inputs[0].source), "shadow") << "the frame's own";
    EXPECT_EQ(std::get<std::string>(copy.inputs[1].source), "lake.cones");
    EXPECT_EQ(copy.depth->image, "lake.depth");
    EXPECT_EQ(copy.view->raster.size, glm::ivec2(33, 20));
    EXPECT_EQ(plan.images().at("lake.radiance").size, glm::ivec2(33, 20));
    EXPECT_EQ(plan.images().at("lake.cones").size, glm::ivec2(5, 3));
    EXPECT_EQ(plan.images().at("lake.blocks").size, glm::ivec2(9, 5));
    EXPECT_TRUE(plan.images().at("lake.blocks").hasOwnPixels());
    EXPECT_EQ(plan.find("lake/blocks")->view->raster.size, glm::ivec2(9, 5));
}

TEST(SecondaryView, TakesAndChangesWhatItIsToldTo)
{
    FramePlan plan = scene();
    SecondaryView light{.name = "lamp", .reason = "its light falls on it", .view = visitor};
    light.take = [](Pass& pass) {
        pass.colors.clear();
        return pass.depth.has_value();
    };
    EXPECT_EQ(addSecondaryView(plan, scene(), light), (std::map<std::string, std::string>{{"depth", "lamp.depth"}}));
    EXPECT_EQ(std::get<std::string>(plan.find("lamp/surface")->inputs[1].source), "cones")
        << "what is not drawn there is the frame's";
}

TEST(SecondaryView, CanBeItsDepthAlone)
{
    FramePlan seen = scene();
    Pass marched;
    marched.name = "marched";
    marched.shader = {.vertex = "box.vert", .fragment = "march.frag"};
    marched.colors = {Attachment::whole("radiance")};
    marched.depth = Attachment::whole("depth");
    marched.state.depthWrite = true;
    marched.inputs = {{0, std::string("shadow")}, {1, std::string("cones")}};
    marched.draws = {{.inputs = {{2, std::string("shadow")}}}};
    marched.triangleSamples = std::make_shared<std::vector<glm::vec3>>(100);
    marched.depthOnly = {{.vertex = "box.vert", .fragment = "depth.frag"}, {{1, std::string("cones")}}};
    seen.add(std::move(marched));
    for (const PassPhase phase : {PassPhase::opaque, PassPhase::transparent}) {
        Pass over;
        over.name = phase == PassPhase::opaque ? "sky" : "glass";
        over.phase = phase;
        over.colors = {Attachment::whole("radiance")};
        over.depth = Attachment::whole("depth");
        over.state.depthWrite = phase == PassPhase::transparent;
        seen.add(std::move(over));
    }

    FramePlan plan = scene();
    EXPECT_EQ(addSecondaryView(plan, seen, {.name = "lamp", .view = visitor, .depthOnly = true}),
              (std::map<std::string, std::string>{
                  {"blocks", "lamp.blocks"}, {"cones", "lamp.cones"}, {"depth", "lamp.depth"}}));
    EXPECT_TRUE(plan.errors().empty());
    const Pass* cheap = plan.find("lamp/marched");
    EXPECT_FALSE(cheap->triangleSamples) << "a depth has no light";
    ASSERT_TRUE(cheap);
    EXPECT_TRUE(cheap->colors.empty() && cheap->draws[0].inputs.empty());
    EXPECT_EQ(cheap->shader.fragment, "depth.frag");
    ASSERT_EQ(cheap->inputs.size(), 1U);
    EXPECT_EQ(std::get<std::string>(cheap->inputs[0].source), "lamp.cones");
    const Pass* whole = plan.find("lamp/surface");
    ASSERT_TRUE(whole) << "it clears the depth, and its own program is the only one that finds it";
    EXPECT_TRUE(whole->colors.empty());
    EXPECT_EQ(whole->inputs.size(), 3U);
    EXPECT_EQ(plan.find("lamp/sky"), nullptr) << "it hides nothing";
    EXPECT_EQ(plan.find("lamp/glass"), nullptr);

    Pass reader;
    reader.name = "reader";
    reader.phase = PassPhase::transparent;
    reader.inputs = {{0, std::string("lamp.depth")}};
    reader.colors = {Attachment::whole("radiance")};
    plan.add(std::move(reader));
    plan.prune({"radiance"});
    EXPECT_EQ(toString(plan), "move > shadow > cones > blocks > lamp/cones > lamp/blocks > lamp/surface > "
                              "lamp/marched > surface > reader");
}

TEST(SecondaryView, PreparesNothingThatADepthDoesNotAskFor)
{
    FramePlan seen;
    seen.image({.name = "depth", .format = Format::depth32f});
    seen.image({.name = "blur"});
    Pass blur;
    blur.name = "blur";
    blur.phase = PassPhase::prepare;
    blur.colors = {Attachment::cleared("blur")};
    seen.add(std::move(blur));
    Pass wall;
    wall.name = "wall";
    wall.depth = Attachment::cleared("depth");
    wall.state.depthWrite = true;
    wall.inputs = {{0, std::string("blur")}};
    wall.depthOnly = DepthOnly{{.vertex = "depth.vert"}};
    seen.add(std::move(wall));
    FramePlan plan;
    EXPECT_EQ(addSecondaryView(plan, seen, {.name = "lamp", .view = visitor, .depthOnly = true}),
              (std::map<std::string, std::string>{{"depth", "lamp.depth"}}));
}

TEST(SecondaryView, IsLeftOutWhenNothingReadsIt)
{
    FramePlan plan = scene();
    (void)addSecondaryView(plan, scene(), {.name = "lake", .view = visitor});
    plan.prune({"radiance"});
    EXPECT_EQ(plan.find("lake/surface"), nullptr);
    EXPECT_EQ(plan.findSkipped("lake/surface")->reason, "its output is not used");
}

}  // namespace
}  // namespace vitrine
