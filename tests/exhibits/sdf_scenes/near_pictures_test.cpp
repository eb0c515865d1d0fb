// Pictures with lists of nearby shapes: equal to those with all shapes, with one program for many trees.

#include "render/files/assets.h"
#include "tests/exhibits/sdf_scenes/scene_shot.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

namespace vitrine {
namespace {

using glm::dvec3;
using scenes::SceneEvaluation;
using scenes::SceneHeatMap;
using scenes::SceneOcclusion;
using scenes::SceneShadow;
using namespace test;

class NearPicture : public test::GlTest {
protected:
    test::TemporaryFolder folder_;

    static render::Pass passOf(SceneShot& shot)
    {
        const render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, shot.request.frame);
        return *plan.find("sdf_scenes/scene");
    }
    SceneShot balls(int count, const char* camera = R"([0, 0, 6])")
    {
        std::string root = R"({"kind": "union", "blendWidth": 0.1, "children": [)";
        for (int i = 0; i < count; ++i)
            root += (i > 0 ? ", " : "") +
                    ("{\"kind\": \"sphere\", \"radius\": \"size\", \"translate\": [" +
                     std::to_string(0.3 * (i % 10) - 1.5) + ", " + std::to_string(0.3 * (i / 10) - 0.6) + ", 0]}");
        return SceneShot(
            test::writeScene(folder_, root + "]}",
                             std::string(R"("parameters": {"size": {"value": 0.1, "unit": "m", "range": [0.05, 0.3]}},
"camera": {"position": )") + camera +
                                 R"(, "target": [0, 0, 0], "fieldOfView": 40},)",
                             std::to_string(count) + ".json"));
    }
};

using LongNearPicture = NearPicture;

TEST_F(LongNearPicture, IsThatOfEveryShape)
{
    for (const char* name : {"primitives", "mercury", "still_life", "ambient_occlusion"}) {
        SceneShot shot(shippedScene(name));
        shot.values().set(scenesTable().evaluation, SceneEvaluation::shapes);
        shot.values().set(scenesTable().hitTolerance, 0.02);
        shot.values().set(scenesTable().stepLimit, 512);
        shot.values().set(scenesTable().shadowMethod, SceneShadow::none);
        shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
        const test::Picture every = shot.take();
        shot.values().set(scenesTable().evaluation, SceneEvaluation::near);
        EXPECT_TRUE(passOf(shot).shader.sources->textByPath().begin()->second.find("sceneListed") != std::string::npos)
            << name;
        const test::Picture near = shot.take();
        int apart = 0, solid = 0;
        every.each([&](int x, int y) {
            const double a = every.depth(x, y), b = near.depth(x, y);
            solid += a < 40 ? 1 : 0;
            // Infinite floors end at the limit of steps, or not at all.
            if (a > 40 && b > 40) return;
            apart += std::abs(a / b - 1) < 0.01 ? 0 : 1;
        });
        EXPECT_GT(solid, 500) << name;
        EXPECT_LE(apart, solid / 200) << name << ": of " << solid;
    }
}

TEST_F(NearPicture, HasOneProgramForAllTreesOfTheSameKindsAndAllNumbers)
{
    SceneShot some = balls(30), more = balls(31);
    EXPECT_EQ(passOf(some).shader, passOf(more).shader);
    EXPECT_NE(std::get<1>(passOf(some).buffers.back().source), std::get<1>(passOf(more).buffers.back().source));
    const auto solid = [](const test::Picture& p) {
        int pixels = 0;
        p.each([&](int x, int y) { pixels += p.depth(x, y) < 1000; });
        return pixels;
    };
    const int before = solid(some.take());
    const render::ShaderKey key = passOf(some).shader;
    some.set("size", 0.14);
    EXPECT_EQ(passOf(some).shader, key);
    EXPECT_GT(solid(some.take()), before * 5 / 4);
    EXPECT_GT(solid(more.take()), before);
}

TEST_F(LongNearPicture, OfMoreNumbersThanABlockHoldsIsDrawn)
{
    SceneShot many = balls(4200, "[0, 58, 150]");
    ASSERT_GT(many.shown().program->wordCount() * 4, 65'536U);
    EXPECT_LT(passOf(many).blocks.at(6).size(), 16'384U);
    const test::Picture p = many.size(192, 108).take();
    int solid = 0;
    p.each([&](int x, int y) { solid += p.depth(x, y) < 1000; });
    EXPECT_GT(solid, 10);
}

TEST_F(NearPicture, ShowsHowManyShapesWereAsked)
{
    SceneShot shot = balls(70);
    shot.values().set(scenesTable().heatMap, SceneHeatMap::shapes);
    shot.request.frame.channels.evaluations = true;
    const auto asked = [&](SceneEvaluation way) {
        shot.values().set(scenesTable().evaluation, way);
        const test::Picture p = shot.take();
        double sum = 0;
        p.each([&](int x, int y) { sum += static_cast<double>(p.image.at(x, y, 8)); });
        return sum / (p.width() * p.height());
    };
    const double all = asked(SceneEvaluation::shapes), near = asked(SceneEvaluation::near);
    EXPECT_GT(near, 0.5);
    EXPECT_GT(all, 20 * near);
}

/// Draws a scene whose shader has one text replaced by another.
render::Image drawnWith(SceneShot& shot, const char* file, const std::string& from, const std::string& to)
{
    render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, shot.request.frame,
                                           test::gallery().renderer.persistentState());
    plan.allSlices = true;
    std::ifstream stream(std::filesystem::path(VITRINE_SOURCE_DIR) / "shaders" / file);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    for (const render::Pass& pass : plan.passes()) {
        if (pass.name != "sdf_scenes/scene") continue;
        std::map<std::string, std::string> texts = pass.shader.sources->textByPath();
        texts[file] = text;
        // The plan of the program has no interface for this.
        const_cast<render::Pass&>(pass).shader.sources = std::make_shared<const render::ShaderSources>(texts);
    }
    test::gallery().renderer.draw(plan);
    return test::gallery().renderer.read(radianceImage);
}

/// Returns the mean difference of rows from the rows around them. Along a wall the occlusion of a floor changes
/// smoothly from row to row; with equal ray directions for all pixels it would have steps.
double stairs(const render::Image& picture, int first, int last)
{
    std::vector<double> rows;
    for (int y = first; y <= last; ++y) {
        double sum = 0;
        for (int x = 0; x < picture.width; ++x) sum += static_cast<double>(picture.at(x, y, 1));
        rows.push_back(sum / picture.width);
    }
    double worst = 0;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) worst += std::pow(rows[i + 1] - 2 * rows[i] + rows[i - 1], 2);
    return std::sqrt(worst / static_cast<double>(rows.size() - 2)) / rows.back();
}

TEST_F(NearPicture, OcclusionHasNoBandsWhereFixedDirectionsHave)
{
    const std::string head = R"("camera": {"position": [0, 2, 2.4], "target": [0, 0, 0.5], "fieldOfView": 40},
 "environment": {"kind": "sky", "zenith": [1, 1, 1], "horizon": [1, 1, 1], "ground": [1, 1, 1]},
 "materials": {"chalk": {"model": "pbr", "color": [0.5, 0.5, 0.5], "roughness": 1, "reflectance": 0}},)";
    SceneShot shot(test::writeScene(folder_, R"({"kind": "union", "material": "chalk", "children": [
      {"kind": "plane", "normal": [0, 1, 0]}, {"kind": "box", "size": [200, 2, 1], "translate": [0, 0, -0.5]}]})",
                                    head));
    shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::hemisphere);
    shot.values().set(scenesTable().occlusionRange, 1000.0);
    shot.values().set(scenesTable().occlusionRays, 16);
    shot.request.frame.raster.size = {256, 96};
    const char* const light = "sdf_scenes/light.glsl";
    const render::Image ours =
        drawnWith(shot, light, "float turn = pixelNumber(17u);", "float turn = pixelNumber(17u);");
    const render::Image fixed = drawnWith(shot, light, "float turn = pixelNumber(17u);", "float turn = 0.3;");
    // The floor in front of the wall.
    EXPECT_LT(stairs(ours, 52, 92), 0.5 * stairs(fixed, 52, 92)) << stairs(ours, 52, 92);
    EXPECT_GT(stairs(fixed, 52, 92), 0.01) << "control";
}

// llvmpipe ends all loops of a group of pixels after 65,535 iterations, which left a third of this picture black.
TEST_F(NearPicture, OfTheMostRaysHasNoBlackPixel)
{
    const auto darkest = [](SceneShot& shot) {
        const Picture p = shot.take();
        double least = 1;
        p.each([&](int x, int y) {
            if (p.hit(x, y)) least = std::min(least, p.luminance(x, y));
        });
        return least;
    };
    SceneShot few(render::asset("scenes/rotunda.json")), many(render::asset("scenes/rotunda.json"));
    few.values().set(scenesTable().shadowMethod, SceneShadow::area);
    few.values().set(scenesTable().shadowRays, 4);
    many.values().set(scenesTable().shadowMethod, SceneShadow::area);
    many.values().set(scenesTable().shadowRays, 64);
    many.values().set(scenesTable().occlusionMethod, SceneOcclusion::hemisphere);
    many.values().set(scenesTable().occlusionRays, 512);
    for (SceneShot* shot : {&few, &many}) shot->request.frame.raster.size = {48, 27};
    EXPECT_GT(darkest(few), 0.002) << "control";
    EXPECT_GT(darkest(many), 0.002);
}

TEST_F(NearPicture, GlassMirrorsTheSceneAtItsFirstSide)
{
    // The only light is a board behind the eye, of which the center of the ball reflects 4 %.
    const std::string head = R"("camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fieldOfView": 40},
 "environment": {"kind": "sky", "zenith": [0, 0, 0], "horizon": [0, 0, 0], "ground": [0, 0, 0]},
 "materials": {"glass": {"model": "pbr", "color": [1, 1, 1], "roughness": 0, "transmission": 1, "refractiveIndex": 1.5},
   "lamp": {"model": "pbr", "color": [1, 0.5, 0.25], "roughness": 1, "reflectance": 0, "emission": 5}},)";
    SceneShot shot(test::writeScene(
        folder_, R"({"kind": "union", "children": [{"kind": "sphere", "radius": 1, "material": "glass"},
        {"kind": "box", "size": [20, 20, 1], "translate": [0, 0, 9], "material": "lamp"}]})",
        head));
    shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
    shot.request.frame.raster.size = {33, 33};
    const dvec3 seen = shot.take().color(16, 16);
    EXPECT_NEAR(seen.x, 0.04 * 5, 0.02);
    EXPECT_NEAR(seen.y, 0.5 * seen.x, 0.01);
    shot.values().set(scenesTable().bounces, 0);
    EXPECT_LT(shot.take().color(16, 16).x, 0.01) << "control: without a bounce there is the environment";
}

TEST_F(NearPicture, ShadowsOfAllMethodsKeepNothingBehindTheLightAway)
{
    const auto middle = [&](SceneShadow method, const char* others) {
        const std::string head = R"("camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fieldOfView": 50},
 "lights": [{"kind": "point", "position": [0, 0, 3], "color": [1, 1, 1]}],
 "materials": {"chalk": {"model": "pbr", "color": [0.5, 0.5, 0.5], "roughness": 1}},)";
        SceneShot shot(test::writeScene(
            folder_,
            std::string(R"({"kind": "union", "material": "chalk", "children": [{"kind": "sphere", "radius": 1})") +
                others + "]}",
            head));
        shot.values().set(scenesTable().shadowMethod, method);
        shot.values().set(scenesTable().occlusionMethod, SceneOcclusion::none);
        shot.values().set(scenesTable().hitTolerance, 0.01);
        shot.request.frame.raster.size = {48, 48};
        return shot.take().luminance(17, 24);
    };
    const char* const behind = R"(, {"kind": "box", "size": [20, 20, 0.1], "translate": [0, 0, 9]})";
    const char* const before = R"(, {"kind": "box", "size": [0.3, 0.3, 0.01], "translate": [0, 0, 2.7]})";
    for (const SceneShadow method : {SceneShadow::hard, SceneShadow::classic, SceneShadow::improved,
                                     SceneShadow::signedDistance, SceneShadow::area}) {
        const double lit = middle(method, "");
        EXPECT_GT(lit, 0.01);
        EXPECT_NEAR(middle(method, behind) / lit, 1, 0.01) << static_cast<int>(method);
    }
    EXPECT_LT(middle(SceneShadow::hard, before), 0.9 * middle(SceneShadow::hard, "")) << "control: before it, one does";
}

}  // namespace
}  // namespace vitrine
