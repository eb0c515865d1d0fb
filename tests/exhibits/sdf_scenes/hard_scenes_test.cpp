// Stability cases of tests/stability/README.md that a scene file can cause.

#include "exhibits/sdf_scenes/list_glsl.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_grid.h"
#include "tests/exhibits/sdf_scenes/ray_steps.h"

#include <cmath>
#include <regex>

namespace vitrine {
namespace {

using scenes::SceneField;

void expectNumbers(const SceneField& field, const std::string& what)
{
    test::Random random(71);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = i < 100 ? random.point(1e-4) : random.point(3);
        ASSERT_TRUE(std::isfinite(field.distance(p))) << what;
    }
    ASSERT_TRUE(std::isfinite(field.distance({0, 0, 0}))) << what;
    ASSERT_TRUE(std::isfinite(field.distance({1e5, -1e5, 1e5}))) << what;
}

/// Returns the number of steps until a ray through the center ends.
int stepsThrough(const SceneField& field)
{
    double t = 0;
    int steps = 0;
    for (; steps < 1000 && t < 20; ++steps) {
        const double d = field.distance({1e-7, 2e-7, 5 - t});
        if (d < 1e-6) break;
        t += d;
    }
    return steps;
}

std::string refusal(const std::string& root)
{
    const scenes::ReadScene read = test::readText(test::sceneText(root));
    EXPECT_FALSE(read.scene) << root;
    return test::findingsText(read);
}

TEST(HardScenes, TheSmallestShapesAreFiniteAndRaysPassThemQuickly)
{
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        if (kind.form != scenes::Form::shape) continue;
        for (const bool smallest : {true, false}) {
            std::string text = "{\"kind\": \"" + std::string(kind.name) + '"';
            for (const scenes::Field& field : kind.fields) {
                if (field.unit != Unit::meter || scenes::numbersOf(field.type) != 1 || field.low < 0) continue;
                const double size =
                    smallest ? std::max(field.low, scenes::FieldType::real == field.type ? 1e-4 : 0) : 1e4;
                text += ", \"" + std::string(field.name) + "\": " + std::to_string(size);
            }
            text += '}';
            if (!test::readText(test::sceneText(text)).scene) continue;  // Some numbers give no valid shape.
            const SceneField field = test::fieldOf(text);
            expectNumbers(field, text);
            EXPECT_TRUE(!smallest || stepsThrough(field) < 1000) << text;
        }
    }
    expectNumbers(test::fieldOf(R"({"kind": "capsule", "start": [1, 0, 0], "end": [1, 0, 0]})"), "equal ends");
    EXPECT_NEAR(test::fieldOf(R"({"kind": "capsule", "start": [1, 0, 0], "end": [1, 0, 0], "radius": 0.2})")
                    .distance({1, 2, 0}),
                1.8, 1e-12);
}

TEST(HardScenes, SizesAndScalesOfZeroOrLessAreRefused)
{
    for (const char* root : {R"({"kind": "sphere", "radius": 0})", R"({"kind": "sphere", "radius": -1})",
                             R"({"kind": "box", "size": [1, 0, 1]})", R"({"kind": "torus", "minorRadius": -0.1})",
                             R"({"kind": "sphere", "scale": 0})", R"({"kind": "sphere", "scale": [1, 0, 1]})"})
        EXPECT_NE(refusal(root).find("test.json:"), std::string::npos) << root;
    // An animated number is clamped to its range.
    const auto scene = test::sceneOf(R"({"kind": "sphere", "radius": "0.5 - t"})");
    EXPECT_NEAR(SceneField(scene, 10).distance({1, 0, 0}), 1, 1e-3);
}

TEST(HardScenes, TheEllipsoidIsExactAtItsCenterAndBlends)
{
    const SceneField thin = test::fieldOf(R"({"kind": "ellipsoid", "radii": [1, 0.01, 1]})");
    EXPECT_NEAR(thin.distance({0, 0, 0}), -0.01, 1e-7);
    const SceneField blended = test::fieldOf(R"({"kind": "union", "blendWidth": 0.2, "children": [
        {"kind": "ellipsoid", "radii": [1, 0.05, 1]}, {"kind": "box", "translate": [0, 0.6, 0]}]})");
    test::Random random(72);
    EXPECT_EQ(test::overshoots([&](const glm::dvec3& p) { return blended.distance(p); }, random, 2000), 0);
}

std::string twoOf(const std::string& kind, const std::string& blend, const std::string& k)
{
    return "{\"kind\": \"" + kind + "\", \"blend\": \"" + blend + "\", \"blendWidth\": " + k +
           R"(, "children": [{"kind": "sphere"}, {"kind": "box", "translate": [0.6, 0, 0]}]})";
}

TEST(HardScenes, BlendsOfAnyWidthStayNumbersAndAtZeroAreHard)
{
    const SceneField a = test::fieldOf(R"({"kind": "sphere"})");
    const SceneField b = test::fieldOf(R"({"kind": "box", "translate": [0.6, 0, 0]})");
    test::Random random(73);
    // Largest addition of each blend as a share of its width, at equal operands.
    const std::pair<const char*, double> most[] = {
        {"quadratic", 1.0 / 4}, {"cubic", 1.0 / 6}, {"circular", 1 - std::sqrt(0.5)}, {"exponential", 1.0}};
    for (const auto& [blend, share] : most) {
        const SceneField none = test::fieldOf(twoOf("union", blend, "0"));
        for (const char* k : {"1e-30", "1e-4", "0.5", "1e4"}) {
            const SceneField wide = test::fieldOf(twoOf("union", blend, k));
            expectNumbers(wide, std::string(blend) + k);
            for (int i = 0; i < 200; ++i) {
                const glm::dvec3 p = random.point(2);
                const double hard = std::min(a.distance(p), b.distance(p));
                ASSERT_EQ(none.distance(p), hard);
                ASSERT_LE(wide.distance(p), hard);
                ASSERT_GE(wide.distance(p), hard - share * std::min(std::stod(k), 1000.0) - 1e-12) << blend << k;
            }
            EXPECT_NEAR(wide.distance({1e5, 0, 0}), none.distance({1e5, 0, 0}), 1001) << blend;
        }
    }
}

TEST(HardScenes, NoStepOvershootsDeepCutsAndUnevenScales)
{
    test::Random random(74);
    for (
        const char* root :
        {R"({"kind": "subtraction", "children": [{"kind": "box", "size": 0.5}, {"kind": "sphere", "radius": 2}]})",
         R"({"kind": "sphere", "scale": [3, 0.2, 1]})",
         R"({"kind": "union", "scale": [0.3, 2, 1], "children": [{"kind": "torus", "rotate": [30, 40, 0], "scale": [1, 1, 4]}, {"kind": "box", "translate": [1, 0, 0]}]})"}) {
        const SceneField field = test::fieldOf(root);
        EXPECT_EQ(test::overshoots([&](const glm::dvec3& p) { return field.distance(p); }, random, 4000), 0) << root;
    }
    // A subtraction larger than the solid leaves no surface.
    const SceneField gone = test::fieldOf(
        R"({"kind": "subtraction", "children": [{"kind": "box", "size": 0.5}, {"kind": "sphere", "radius": 2}]})");
    for (int i = 0; i < 1000; ++i) ASSERT_GT(gone.distance(random.point(3)), 0);
}

TEST(HardScenes, ASolidWithoutItselfHasNoInside)
{
    test::Random random(75);
    const char* const box = R"({"kind": "box"})";
    const SceneField gone =
        test::fieldOf(std::string(R"({"kind": "subtraction", "children": [)") + box + ", " + box + "]}");
    const SceneField twice = test::fieldOf(std::string(R"({"kind": "union", "children": [)") + box + ", " + box + "]}");
    const SceneField once = test::fieldOf(box);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p = random.point(1);
        ASSERT_GE(gone.distance(p), 0);
        ASSERT_EQ(twice.distance(p), once.distance(p));
    }
}

TEST(HardScenes, ADepthOfTenThousandNeedsNoStack)
{
    std::string text = R"({"kind": "sphere"})";
    for (int depth = 0; depth < 10'000; ++depth) text = "{\"kind\": \"union\", \"children\": [" + text + "]}";
    const scenes::ReadScene read = test::readText(test::sceneText(text));
    ASSERT_TRUE(read.scene) << test::findingsText(read);
    const SceneField field(read.scene);
    EXPECT_EQ(field.distance({1, 0, 0}), 0.5);
    EXPECT_FALSE(scenes::sceneGlsl(field.program()).empty());
    // A node that only passes on its child needs no level of a list.
    EXPECT_EQ(scenes::ListVocabulary::of(field.program(), field.words()).results, 0U);
}

TEST(HardScenes, WithoutAnythingThatShowsThereIsBackground)
{
    for (const char* root :
         {R"({"kind": "sphere", "hidden": true})",
          R"({"kind": "subtraction", "children": [{"kind": "sphere", "hidden": true}, {"kind": "box"}]})"}) {
        const SceneField field = test::fieldOf(root);
        EXPECT_EQ(field.distance({0, 0, 0}), scenes::nothingNear);
        const auto near = scenes::sceneGrid(field.program(), field.words(),
                                            scenes::ListVocabulary::of(field.program(), field.words()), 16);
        EXPECT_TRUE(near->cells.cells.empty()) << root;
    }
}

TEST(HardScenes, CopiesFarFromTheOriginAreDistinct)
{
    const SceneField field = test::fieldOf(
        R"({"kind": "repeat", "spacing": [1, 0, 0], "count": [0, 0, 0], "child": {"kind": "sphere", "radius": 0.2}})");
    for (const double far : {0.0, 16'777'217.0, 1e9})
        for (const double aside : {0.0, 0.25, 0.5})
            EXPECT_NEAR(field.distance({far + aside, 0, 0}), aside - 0.2, 1e-6) << far;
}

/// Parameters that are read before they are written can only exist if functions have `out` parameters: generated ones
/// have none.
TEST(HardScenes, GeneratedShadersHaveNoParametersThatAreWritten)
{
    static const std::regex written(R"(\b(out|inout)\b)");
    test::Random random(76);
    for (int sample = 0; sample < 100; ++sample) {
        const SceneField field = test::fieldOf(test::randomTree(random, 4));
        EXPECT_FALSE(std::regex_search(scenes::sceneGlsl(field.program()), written));
        const std::vector<char> all(field.words().words.size(), 1);
        EXPECT_FALSE(std::regex_search(scenes::restingSceneGlsl(field.program(), field.words(), all), written));
        EXPECT_FALSE(std::regex_search(scenes::listGlsl(scenes::ListVocabulary::of(field.program(), field.words()), 2),
                                       written));
    }
    EXPECT_TRUE(std::regex_search(std::string("void f(out float d)"), written));
}

}  // namespace
}  // namespace vitrine
