// Generated shaders compared with the evaluator: 1,024 points each, drawn into a float image.

#include "tests/exhibits/sdf_scenes/drawn_points.h"

#include <filesystem>

namespace vitrine {
namespace {

using SceneShaders = test::GlTest;

void compareBothWays(const std::shared_ptr<const scenes::Scene>& scene, double time, const std::string& what)
{
    const scenes::SceneField field(scene, time);
    test::compareAtPoints(field, scenes::sceneGlsl(field.program()), scenes::sceneBlock(field.words()),
                          what + " from the block: ");
    const std::vector<char> all(field.words().words.size(), 1);
    test::compareAtPoints(field, scenes::restingSceneGlsl(field.program(), field.words(), all), {}, what + " folded: ");
}

TEST_F(SceneShaders, OfTheShippedScenesAreTheEvaluator)
{
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes")) {
        if (entry.path().filename() == "scene.schema.json") continue;
        const scenes::ReadScene read = scenes::readSceneFile(entry.path());
        ASSERT_TRUE(read.scene) << test::findingsText(read);
        const std::string name = entry.path().stem().string();
        compareBothWays(read.scene, 1.25, name);
    }
}

/// Control: numbers of another time are detected.
TEST_F(SceneShaders, WithOtherNumbersAreNotTheEvaluator)
{
    const auto scene = test::sceneOf(R"json({"kind": "sphere", "radius": "0.5 + 0.0001 * t"})json");
    const scenes::SceneField field(scene, 0);
    const scenes::SceneField later(scene, 1);
    const std::vector<test::FoundAtPoint> found =
        test::drawn(scenes::sceneGlsl(field.program()), scenes::sceneBlock(later.words()));
    EXPECT_NEAR(found.front().distance, later.distance(test::pointOf(0, 0)), 1e-5);
    EXPECT_GT(std::abs(found.front().distance - field.distance(test::pointOf(0, 0))), 5e-5);
}

TEST_F(SceneShaders, OfEveryKindOfNodeAreTheEvaluator)
{
    const std::string head = R"("materials": {"red": {"model": "pbr", "color": [1, 0, 0], "roughness": 1},
        "blue": {"model": "pbr", "color": [0, 0, 1]}},)";
    test::Random random(61);
    std::vector<std::string> nodes;
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        std::string further = test::randomPlace(random, false);
        if (kind.form == scenes::Form::modifier || kind.form == scenes::Form::repeater)
            further += R"(, "child": {"kind": "capsule", "start": [0.3, 0, 0], "radius": 0.2})";
        else if (kind.form != scenes::Form::shape)
            further += R"(, "children": [{"kind": "sphere", "material": "red"}, {"kind": "box", "material": "blue"}])";
        std::string node = test::randomNode(kind, random, further);
        while (!test::readText(test::sceneText(node, head)).scene) node = test::randomNode(kind, random, further);
        nodes.push_back(node);
    }
    constexpr std::size_t together = 6;
    for (std::size_t first = 0; first < nodes.size(); first += together) {
        std::string root = R"({"kind": "union", "blend": "circular", "blendWidth": 0.1, "children": [)";
        for (std::size_t i = first; i < std::min(first + together, nodes.size()); ++i)
            root += (i > first ? ", " : "") + nodes[i];
        compareBothWays(test::sceneOf(root + "]}", head), 0, root);
    }
}

TEST_F(SceneShaders, OfRandomTreesAreTheEvaluator)
{
    test::Random random(62);
    for (int sample = 0; sample < 10; ++sample) {
        const std::string root = test::randomTree(random, 3);
        compareBothWays(test::sceneOf(root), 0, root);
    }
}

TEST_F(SceneShaders, HaveNothingThatTheSceneHasNot)
{
    const auto glslOf = [](const std::string& root) {
        return scenes::sceneGlsl(scenes::SceneProgram(test::sceneOf(root)));
    };
    const std::string ball = glslOf(R"({"kind": "sphere"})");
    for (const char* word : {"noise.glsl", "shapes.glsl", "sceneTurned", "for (", "sceneBlend", "sceneUnion"})
        EXPECT_EQ(ball.find(word), std::string::npos) << word << '\n' << ball;
    EXPECT_NE(glslOf(R"({"kind": "noise"})").find("noise.glsl"), std::string::npos);
    EXPECT_NE(glslOf(R"({"kind": "pyramid"})").find("shapes.glsl"), std::string::npos);
    // A parameter changes numbers of the block, and not the source code.
    const auto with = [&](const char* radius) {
        return glslOf(std::string(R"({"kind": "sphere", "radius": )") + radius + "}");
    };
    EXPECT_EQ(with("0.25"), with("0.75"));
}

}  // namespace
}  // namespace vitrine
