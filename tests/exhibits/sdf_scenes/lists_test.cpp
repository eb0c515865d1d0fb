// Shaders that walk lists of steps, compared with the evaluator: 1,024 points each. With all steps, and with those of
// the point's cell.

#include "exhibits/sdf_scenes/list_glsl.h"
#include "exhibits/sdf_scenes/scene_evaluator.h"
#include "exhibits/sdf_scenes/scene_grid.h"
#include "shaders/lib/bindings.glsl"
#include "tests/exhibits/sdf_scenes/drawn_points.h"

#include <filesystem>

#ifdef VITRINE_RAPIDCHECK
#include <rapidcheck/gtest.h>  // After gtest, which it needs.
#endif

namespace vitrine {
namespace {

using SceneLists = test::GlTest;
using LongSceneListsProperty = test::GlTest;

bool fits(const scenes::ListVocabulary& v)
{
    return v.results <= scenes::ListVocabulary::mostResults && v.places <= scenes::ListVocabulary::mostPlaces;
}

/// Returns the vocabulary of every scene up to this nesting depth.
scenes::ListVocabulary everyVocabulary(std::uint32_t results, std::uint32_t places)
{
    scenes::ListVocabulary all{.results = results, .places = places};
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        if (kind.form == scenes::Form::shape) all.shapes.push_back(&kind);
        if (kind.form == scenes::Form::modifier || kind.form == scenes::Form::repeater) all.spaces.push_back(&kind);
        if (!kind.combine) continue;
        const scenes::Field& first = kind.fields.front();
        const std::size_t choices = first.type == scenes::FieldType::choice ? first.choices.size() : 1;
        for (std::size_t choice = 0; choice < choices; ++choice)
            all.joints.push_back({&kind, static_cast<int>(choice)});
    }
    return all;
}

/// Compares without cells, and with this many.
void compareLists(const scenes::SceneField& field, int across, const std::string& what)
{
    const scenes::ListVocabulary own = scenes::ListVocabulary::of(field.program(), field.words());
    ASSERT_TRUE(fits(own)) << what;
    const auto whole = scenes::sceneGrid(field.program(), field.words(), own, 0);
    test::compareAtPoints(field, scenes::listGlsl(own, 0), {}, what + " by lists: ", buffersOf(*whole));
    if (testing::Test::HasFatalFailure()) return;
    const auto near = scenes::sceneGrid(field.program(), field.words(), own, across);
    test::ByCells byCells;
    if (!near->cells.cells.empty()) byCells = {0.5 * glm::length(near->cells.cellSize()), near->cells.box, near->box};
    test::compareAtPoints(field, scenes::listGlsl(own, near->planes), {}, what + " by cells: ", buffersOf(*near),
                          byCells);
}

using LongSceneLists = SceneLists;

TEST_F(SceneLists, OfTheShippedScenesAreTheEvaluator)
{
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes")) {
        if (entry.path().filename() == "scene.schema.json") continue;
        const scenes::ReadScene read = scenes::readSceneFile(entry.path());
        ASSERT_TRUE(read.scene) << test::findingsText(read);
        compareLists(scenes::SceneField(read.scene, 1.25), 24, entry.path().stem().string());
        if (HasFatalFailure()) return;
    }
}

TEST_F(SceneLists, OfRandomTreesAreTheEvaluator)
{
    test::Random random(63);
    for (int sample = 0; sample < 12; ++sample) {
        const std::string root = test::randomTree(random, 3);
        compareLists(test::fieldOf(root), 16, root);
        if (HasFatalFailure()) return;
    }
}

/// A union of many in unions, subtractions and intersections, with planes beside it.
TEST_F(SceneLists, WithPlanesAndNestedOperationsAreTheEvaluator)
{
    const std::string root = R"({"kind": "union", "children": [
        {"kind": "plane", "height": -0.7}, {"kind": "sphere", "translate": [0.4, 0.2, 0]},
        {"kind": "union", "children": [{"kind": "plane", "normal": [1, 2, 0.5], "height": -3, "translate": [0.3, 0, 1], "rotate": [10, 20, 30], "scale": 1.5},
            {"kind": "union", "blend": "cubic", "blendWidth": 0.3, "scale": [0.7, 0.7, 0.7], "children": [
                {"kind": "box"}, {"kind": "subtraction", "blend": "circular", "blendWidth": 0.1, "translate": [1, 0, 0], "rotate": [0, 30, 20],
                    "children": [{"kind": "box"}, {"kind": "intersection", "scale": [0.5, 1, 0.8], "children": [{"kind": "sphere", "radius": 0.6}, {"kind": "box", "size": 0.9}]}]}]}]},
        {"kind": "twist", "rate": 60, "translate": [-1, 0.5, 1], "child": {"kind": "union", "blendWidth": 0.1, "children": [
            {"kind": "box", "size": [0.4, 1.5, 0.2]}, {"kind": "repeatAround", "count": 5, "child": {"kind": "sphere", "radius": 0.1, "translate": [0.3, 0, 0]}}]}}]})";
    const scenes::SceneField field = test::fieldOf(root);
    compareLists(field, 32, root);
}

/// A repeater is folded into its shape, unless it needs several copies or its shape has a transformation.
TEST_F(SceneLists, WithRepeatersFoldedIntoTheirShapesAreTheEvaluator)
{
    const auto petals = [](const char* more) {
        return std::string(R"({"kind": "repeatAround", "count": 7, "rotate": [10, 20, 0], "scale": [0.8, 0.8, 0.8],
            "child": {"kind": "vesica", "start": [0.1, 0, 0], "end": [0.9, 0.3, 0], "radius": 0.2)") +
               more + "}}";
    };
    const std::string folded = petals("");
    const std::string grid =
        R"({"kind": "repeat", "spacing": [0.8, 0.9, 1], "count": [3, 2, 2], "child": {"kind": "sphere", "radius": 0.3}})";
    const auto united = [](const std::string& a, const std::string& b) {
        return R"({"kind": "union", "blend": "cubic", "blendWidth": 0.1, "children": [)" + a + ", " + b + "]}";
    };
    const auto vocabularyOf = [](const std::string& root) {
        const scenes::SceneField field = test::fieldOf(root);
        return scenes::ListVocabulary::of(field.program(), field.words());
    };
    EXPECT_EQ(vocabularyOf(united(folded, grid)).folds.size(), 2U);
    EXPECT_EQ(vocabularyOf(united(folded, grid)).places, 0U);
    const std::string turned = petals(R"(, "rotate": [0, 0, 30])");
    const std::string aside = R"({"kind": "repeatAround", "count": 5, "child":
        {"kind": "capsule", "start": [0.2, 0, 0], "end": [0.8, 0, 0.4], "radius": 0.2}})";
    for (const std::string& other : {turned, aside}) {
        EXPECT_TRUE(vocabularyOf(other).folds.empty()) << other;
        EXPECT_EQ(vocabularyOf(united(folded, other)).places, 1U) << other;
    }
    for (const std::string& root :
         {folded, grid, united(folded, grid), united(folded, turned), united(aside, folded)}) {
        compareLists(test::fieldOf(root), 24, root);
        if (HasFatalFailure()) return;
    }
}

/// Copies of profiles that are infinite in one direction: their center is that of the finite directions.
TEST_F(SceneLists, EndlessProfilesAroundTheAxisAreTheEvaluator)
{
    for (const char* turned : {"[0, 0, 0]", "[0, 90, 0]", "[0, 30, 0]"}) {
        const std::string root = std::string(R"({"kind": "repeatAround", "count": 6, "child": {"kind": "hexagon",
            "inradius": 0.2, "translate": [-0.85, 0.05, 0.4], "rotate": )") +
                                 turned + "}}";
        const scenes::SceneField field = test::fieldOf(root);
        // A copy on each side; the nearest one's distance is at most that to its center line.
        for (const double side : {-1.0, 1.0})
            EXPECT_NEAR(field.sample(glm::dvec3(side * 0.85, 0.05, side * -0.4)).distance, -0.2, 1e-9) << root;
        compareLists(field, 16, root);
        if (HasFatalFailure()) return;
    }
}

/// One program for all kinds.
TEST_F(LongSceneLists, OfEveryKindAreTheEvaluatorInOneProgram)
{
    const scenes::ListVocabulary all = everyVocabulary(4, 3);
    const std::string glsl = scenes::listGlsl(all, 0);
    test::Random random(64);
    for (int sample = 0; sample < 40; ++sample) {
        const std::string root = test::randomTree(random, 3);
        const scenes::SceneField field = test::fieldOf(root);
        const scenes::ListVocabulary own = scenes::ListVocabulary::of(field.program(), field.words());
        if (own.results > all.results || own.places > all.places) continue;
        const auto near = scenes::sceneGrid(field.program(), field.words(), all, 0);
        test::compareAtPoints(field, glsl, {}, root, buffersOf(*near));
        if (HasFatalFailure()) return;
    }
}

#ifdef VITRINE_RAPIDCHECK
/// Random scenes, with the program of all kinds: 1,024 points each.
RC_GTEST_FIXTURE_PROP(LongSceneListsProperty, AnySceneIsTheEvaluator, (unsigned seed))
{
    static const scenes::ListVocabulary all = everyVocabulary(4, 3);
    static const std::string glsl = scenes::listGlsl(all, 0);
    test::Random random(seed);
    const std::string root = test::randomTree(random, 4);
    const scenes::SceneField field = test::fieldOf(root);
    const scenes::ListVocabulary own = scenes::ListVocabulary::of(field.program(), field.words());
    RC_PRE(own.results <= all.results && own.places <= all.places);
    const auto near = scenes::sceneGrid(field.program(), field.words(), all, 0);
    test::compareAtPoints(field, glsl, {}, root, buffersOf(*near));
    RC_ASSERT(!HasFatalFailure());
}
#endif

}  // namespace
}  // namespace vitrine
