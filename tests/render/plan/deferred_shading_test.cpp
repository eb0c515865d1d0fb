#include "render/plan/frame_plan.h"
#include "shaders/lib/bindings.glsl"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine::render {
namespace {

/// A plan with a pass of 16 triangles for each sample.
FramePlan planOf(const std::vector<glm::vec3>& samples)
{
    FramePlan plan;
    plan.view = makeView({{0, 0, 0}, {0, 0, -1}, 1}, {.size = {8, 6}});
    plan.image({.name = "picture", .format = Format::rgba16f, .size = {8, 6}, .persistent = true});
    plan.image({.name = "normals", .format = Format::rgba16f, .size = {8, 6}});
    plan.image({.name = "depth", .format = Format::depth32f, .size = {8, 6}});
    Pass pass;
    pass.name = "walls";
    pass.shader = {.vertex = "surface.vert", .fragment = "surface.frag", .defines = {"WRITE_NORMAL", "LIGHTMAP"}};
    pass.colors = {Attachment::cleared("picture"), Attachment::cleared("normals")};
    pass.depth = Attachment::cleared("depth");
    pass.state.depthTest = DepthTest::nearer;
    pass.state.depthWrite = true;
    pass.inputs = {{UNIT_PROBE, std::string("picture")}};
    pass.blocks[BLOCK_LIGHT] = Bytes(16);
    pass.draws.resize(3);
    pass.triangleSamples = std::make_shared<std::vector<glm::vec3>>(samples);
    pass.contentHash = 7;
    plan.add(pass);
    Pass next;
    next.name = "next";
    next.colors = {Attachment::whole("picture")};
    plan.add(next);
    plan.prune({"picture", "normals"});
    return plan;
}

bool has(const std::vector<std::string>& defines, const std::string& define)
{
    return std::find(defines.begin(), defines.end(), define) != defines.end();
}

const std::vector<glm::vec3> inView(13, {0, 0, -1});

TEST(DeferredShading, StoresSurfacesThenLightsThem)
{
    const FramePlan plan = planOf(inView).withDeferredShading().value();
    EXPECT_EQ(toString(plan), "walls > walls/light > next");
    EXPECT_TRUE(plan.errors().empty()) << plan.errors().front();

    const Pass& surfaces = *plan.find("walls");
    ASSERT_EQ(surfaces.colors.size(), 5U);
    EXPECT_TRUE(has(surfaces.shader.defines, "STORE_SURFACE 2"));
    EXPECT_TRUE(has(surfaces.shader.defines, "WRITE_NORMAL"));
    EXPECT_EQ(surfaces.draws.size(), 3U);

    const Pass& light = *plan.find("walls/light");
    EXPECT_EQ(light.shader.fragment, "surface.frag");
    EXPECT_EQ(light.shader.vertex, "kit/stored_surface.vert");
    EXPECT_TRUE(has(light.shader.defines, "LIGHT_STORED"));
    EXPECT_TRUE(has(light.shader.defines, "LIGHTMAP"));
    EXPECT_FALSE(has(light.shader.defines, "WRITE_NORMAL")) << "the first step has written it";
    EXPECT_EQ(light.blocks, surfaces.blocks);
    EXPECT_EQ(light.contentHash, surfaces.contentHash) << "both are forgotten if the second is not drawn";
    EXPECT_EQ(light.draws.size(), 1U);
    ASSERT_EQ(light.colors.size(), 1U);
    EXPECT_EQ(light.colors[0].image, "picture");
    EXPECT_EQ(light.colors[0].load, Load::keep);
    EXPECT_EQ(light.state.blend, Blend::add);
    EXPECT_FALSE(light.depth) << "the stored roughness says where nothing is";
    EXPECT_FALSE(light.state.depthWrite);

    const std::vector<std::string> read = inputsOf(light);
    for (std::size_t i = 2; i < surfaces.colors.size(); ++i) {
        const std::string& name = surfaces.colors[i].image;
        EXPECT_EQ(surfaces.colors[i].load, Load::clear);
        EXPECT_TRUE(has(read, name));
        const ImageInfo& stored = plan.images().at(name);
        EXPECT_EQ(stored.size, glm::ivec2(8, 6));
        EXPECT_EQ(stored.format, Format::rgba32f);
        EXPECT_FALSE(stored.persistent);
    }
}

TEST(DeferredShading, LeavesPassesWithFewTrianglesInViewAsTheyAre)
{
    ASSERT_TRUE(planOf(inView).withDeferredShading());
    EXPECT_FALSE(planOf({}).withDeferredShading());
    EXPECT_FALSE(planOf({12, {0, 0, -1}}).withDeferredShading());
    EXPECT_FALSE(planOf({100, {0, 0, 1}}).withDeferredShading()) << "behind the eye";
    EXPECT_FALSE(planOf({100, {9, 0, -1}}).withDeferredShading()) << "beside the picture";
}

}  // namespace
}  // namespace vitrine::render
