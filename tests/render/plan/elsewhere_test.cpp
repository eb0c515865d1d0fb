// The scene seen from elsewhere: which passes and images of a plan it copies, and the views in mirrors and portals.

#include "render/plan/elsewhere.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>

namespace vitrine {
namespace {

using namespace render;

const View visitor = makeView({{1, 2, 6}, {0, 0.5, 0}, 0.9, {0.1, 0}}, {.size = {64, 36}});

/// A shadow map, a coarse pre-pass, a surface that reads both, a compute step for particles, a tone mapping.
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
    surface.draws = {{.mirrored = false}, {.mirrored = true}};
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

TEST(Elsewhere, CopiesWhatDependsOnTheViewIntoImagesOfItsOwn)
{
    FramePlan plan = scene();
    Elsewhere mirror{.name = "lake", .reason = "the lake mirrors it", .view = visitor, .mirrored = true};
    mirror.view.raster = {.size = {33, 20}};
    const std::map<std::string, std::string> names = addElsewhere(plan, scene(), mirror);
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
    EXPECT_TRUE(copy.draws[0].mirrored);
    EXPECT_FALSE(copy.draws[1].mirrored);
    EXPECT_EQ(copy.view->raster.size, glm::ivec2(33, 20));
    EXPECT_EQ(plan.images().at("lake.radiance").size, glm::ivec2(33, 20));
    EXPECT_EQ(plan.images().at("lake.cones").size, glm::ivec2(5, 3));
    EXPECT_EQ(plan.images().at("lake.blocks").size, glm::ivec2(9, 5));
    EXPECT_TRUE(plan.images().at("lake.blocks").hasOwnPixels());
    EXPECT_EQ(plan.find("lake/blocks")->view->raster.size, glm::ivec2(9, 5));
}

TEST(Elsewhere, TakesAndChangesWhatItIsToldTo)
{
    FramePlan plan = scene();
    Elsewhere light{.name = "lamp", .reason = "its light falls on it", .view = visitor};
    light.take = [](Pass& pass) {
        pass.colors.clear();
        return pass.depth.has_value();
    };
    EXPECT_EQ(addElsewhere(plan, scene(), light), (std::map<std::string, std::string>{{"depth", "lamp.depth"}}));
    EXPECT_EQ(std::get<std::string>(plan.find("lamp/surface")->inputs[1].source), "cones")
        << "what is not drawn there is the frame's";
}

TEST(Elsewhere, CanBeItsDepthAlone)
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
    EXPECT_EQ(addElsewhere(plan, seen, {.name = "lamp", .view = visitor, .depthOnly = true}),
              (std::map<std::string, std::string>{
                  {"blocks", "lamp.blocks"}, {"cones", "lamp.cones"}, {"depth", "lamp.depth"}}));
    EXPECT_TRUE(plan.errors().empty());
    const Pass* cheap = plan.find("lamp/marched");
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

TEST(Elsewhere, PreparesNothingThatADepthDoesNotAskFor)
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
    EXPECT_EQ(addElsewhere(plan, seen, {.name = "lamp", .view = visitor, .depthOnly = true}),
              (std::map<std::string, std::string>{{"depth", "lamp.depth"}}));
}

TEST(Elsewhere, IsLeftOutWhenNothingReadsIt)
{
    FramePlan plan = scene();
    (void)addElsewhere(plan, scene(), {.name = "lake", .view = visitor});
    plan.prune({"radiance"});
    EXPECT_EQ(plan.find("lake/surface"), nullptr);
    EXPECT_EQ(plan.findSkipped("lake/surface")->reason, "nothing reads what it writes");
}

glm::dvec2 placeIn(const View& view, const glm::dvec3& point)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(point, 1);
    return glm::dvec2(clip) / clip.w;
}

// A thing is seen in a mirror where the straight line from the eye to its reflected image passes; independently, where
// the path over the mirror is shortest (Fermat).
TEST(Mirror, ShowsAThingWhereThePathOverItIsShortest)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(number(random), 2 + number(random), number(random)));
        const glm::dvec4 plane(normal, 0.5 * number(random));
        const View mirror = mirroredView(visitor, plane);
        const glm::dvec3 thing = glm::dvec3(number(random), 0, number(random)) + normal * 2.0;
        const double eyeHeight = glm::dot(plane, glm::dvec4(visitor.eye, 1));
        const double thingHeight = glm::dot(plane, glm::dvec4(thing, 1));
        if (eyeHeight <= 0 || thingHeight <= 0) continue;
        const glm::dvec3 eyeFoot = visitor.eye - normal * eyeHeight;
        const glm::dvec3 thingFoot = thing - normal * thingHeight;
        const glm::dvec3 spot = eyeFoot + (thingFoot - eyeFoot) * (eyeHeight / (eyeHeight + thingHeight));
        EXPECT_LT(glm::distance(placeIn(mirror, thing), placeIn(visitor, spot)), 1e-9);
        EXPECT_GT(glm::dot(*mirror.clipPlane, glm::dvec4(thing, 1)), 0);
        EXPECT_LT(glm::dot(*mirror.clipPlane, glm::dvec4(thing - normal * (2 * thingHeight), 1)), 0)
            << "what is behind it";
        // Its eye is the reflected eye, whose rays go the same way.
        EXPECT_NEAR(glm::dot(plane, glm::dvec4(mirror.eye, 1)), -eyeHeight, 1e-12);
        EXPECT_LT(
            glm::distance(placeIn(mirror, mirror.eye + 3.0 * mirror.direction({0.3, -0.4})), glm::dvec2(0.3, -0.4)),
            1e-9);
    }
}

TEST(Portal, ShowsTheExitWhereTheEntryIs)
{
    const glm::dmat4 exitFromEntry =
        glm::translate(glm::dmat4(1), {10, 1, -4}) * glm::rotate(glm::dmat4(1), 1.2, {0, 1, 0});
    const View through = portalView(visitor, exitFromEntry, {0, 0, -1, -4});
    for (const glm::dvec3 point : {glm::dvec3(0), glm::dvec3(0.5, 1, 0.2), glm::dvec3(-1, 0.3, -2)}) {
        const glm::dvec3 there(exitFromEntry * glm::dvec4(point, 1));
        EXPECT_LT(glm::distance(placeIn(through, there), placeIn(visitor, point)), 1e-9);
    }
    EXPECT_LT(glm::distance(through.eye, glm::dvec3(exitFromEntry * glm::dvec4(visitor.eye, 1))), 1e-12);
    EXPECT_EQ(*through.clipPlane, glm::dvec4(0, 0, -1, -4));
}

}  // namespace
}  // namespace vitrine
