// Pruning: steps that are left out in a part of space have no effect there.

#include "exhibits/sdf_scenes/pruning.h"
#include "exhibits/sdf_scenes/scene_grid.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "tests/exhibits/sdf_scenes/many_shapes.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#ifdef VITRINE_RAPIDCHECK
#include <rapidcheck/gtest.h>  // After gtest, which it needs.
#endif

namespace vitrine {
namespace {

/// Differences between two evaluations at points of a ball: with all steps, and with those kept for a ball `trusted`
/// times as large.
struct Differences {
    int points = 0, distances = 0, signs = 0, nodes = 0, leftOut = 0;
};

/// Returns several trees in one operation, at random distances.
std::string randomOperation(test::Random& random)
{
    const char* const kinds[] = {"union", "subtraction", "intersection", "xor"};
    const char* const blends[] = {"quadratic", "cubic", "circular", "exponential"};
    while (true) {
        std::string text =
            std::string("{\"kind\": \"") + kinds[random.below(4)] + "\", \"blend\": \"" + blends[random.below(4)] +
            "\", \"blendWidth\": " + std::to_string(random.below(3) * random.number(0.01, 0.3)) + ", \"children\": [";
        const int children = 2 + random.below(6);
        for (int i = 0; i < children; ++i) text += (i > 0 ? ", " : "") + test::randomTree(random, 2);
        text += "]}";
        if (test::readText(test::sceneText(text)).scene) return text;  // Some numbers give an infinite scene.
    }
}

void compare(const scenes::SceneField& field, test::Random& random, int points, double trusted, Differences& found)
{
    const glm::dvec3 center = random.point(2);
    const double radius = std::pow(10.0, random.number(-2.5, -0.5));
    scenes::Pruner pruner(field.program(), field.words());
    // First for a larger ball, like in the subdivision of large cells.
    const scenes::PrunedSteps outer = pruner.prune(field.program().steps(), center, 2 * radius * trusted);
    const glm::dvec3 inside = center + random.number(0, 1) * radius * random.direction();
    const scenes::PrunedSteps inner = pruner.prune(outer.steps, inside, radius * trusted);
    found.leftOut += inner.steps.size() < field.program().steps().size();
    scenes::SceneWalk walk(field.program(), field.words().words, true);
    for (int i = 0; i < points; ++i) {
        const glm::dvec3 p = inside + std::cbrt(random.number(0, 1)) * radius * random.direction();
        const scenes::SceneSample whole = field.sample(p);
        walk.run(inner.steps, p);
        const double distance = walk.state(0).distance;
        ++found.points;
        found.distances += !(std::abs(distance - whole.distance) <= 1e-11);
        found.signs += std::abs(whole.distance) > 1e-11 && (distance < 0) != (whole.distance < 0);
        found.nodes += walk.surface(0).node != whole.node;
    }
}

TEST(LongPruning, LeavesDistanceSignAndShapeAsTheyAreInTheBall)
{
    test::Random random(11);
    Differences found;
    for (int sample = 0; sample < 4000; ++sample) {
        const std::string root = sample % 2 == 0 ? test::randomTree(random, 4) : randomOperation(random);
        compare(test::fieldOf(root), random, 25, 1, found);
        ASSERT_EQ(found.distances + found.signs + found.nodes, 0) << root;
    }
    EXPECT_EQ(found.points, 100'000);
    EXPECT_GT(found.leftOut, 1000);
}

/// Control: the comparison detects pruning for too small a ball.
TEST(PruningControl, TooSmallARadiusIsFound)
{
    test::Random random(11);
    Differences found;
    for (int sample = 0; sample < 2000; ++sample)
        compare(test::fieldOf(randomOperation(random)), random, 25, 0.1, found);
    EXPECT_GT(found.distances, 100);
    EXPECT_GT(found.signs, 0);
    EXPECT_GT(found.nodes, 0);
}

/// Returns a row of balls in one operation, each `apart` from the next.
std::string rowOfBalls(int count, double apart, const std::string& operation)
{
    std::string text = "{" + operation + ", \"children\": [";
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") +
                ("{\"kind\": \"sphere\", \"radius\": 0.2, \"translate\": [" + std::to_string(i * apart) + ", 0, 0]}");
    return text + "]}";
}

std::size_t shapesLeft(const std::string& root, const glm::dvec3& center, double radius,
                       double tolerance = scenes::Pruner::exact)
{
    const scenes::SceneField field = test::fieldOf(root);
    return scenes::Pruner(field.program(), field.words(), tolerance)
        .prune(field.program().steps(), center, radius)
        .shapes;
}

TEST(Pruning, OfAUnionKeepsWhatIsWithinItsBlend)
{
    const glm::dvec3 atBall50(50, 0.2, 0);
    EXPECT_EQ(shapesLeft(rowOfBalls(100, 1, R"("kind": "union")"), atBall50, 0.1), 1U);
    EXPECT_EQ(shapesLeft(rowOfBalls(100, 1, R"("kind": "union", "blend": "cubic", "blendWidth": 0.5)"), atBall50, 0.1),
              1U);
    // Each ball blends with its neighbors, and so does the blend of all earlier ones: their effect fades.
    const std::string chain = rowOfBalls(100, 1, R"("kind": "union", "blend": "cubic", "blendWidth": 1.2)");
    EXPECT_LE(shapesLeft(chain, atBall50, 0.02), 10U);
    EXPECT_LE(shapesLeft(chain, atBall50, 0.02, scenes::Pruner::asShaders), 6U);
    EXPECT_GE(shapesLeft(chain, atBall50, 0.02, scenes::Pruner::asShaders), 3U);
}

TEST(Pruning, OfASubtractionKeepsTheHolesThatAreNear)
{
    std::string root = R"({"kind": "subtraction", "children": [
        {"kind": "box", "size": [200, 1, 1], "translate": [50, 0, 0]})";
    for (int i = 0; i < 100; ++i)
        root += ", {\"kind\": \"sphere\", \"radius\": 0.2, \"translate\": [" + std::to_string(i) + ", 0.5, 0]}";
    root += "]}";
    EXPECT_EQ(shapesLeft(root, {50, 0.5, 0.1}, 0.1), 2U);
    EXPECT_EQ(shapesLeft(root, {50.5, 0.5, 0}, 0.05), 1U);
}

TEST(Pruning, OfAnIntersectionKeepsTheNearestFace)
{
    const std::string root = R"({"kind": "intersection", "children": [
        {"kind": "plane", "normal": [1, 0, 0], "height": 1}, {"kind": "plane", "normal": [-1, 0, 0], "height": 1},
        {"kind": "plane", "normal": [0, 1, 0], "height": 1}, {"kind": "plane", "normal": [0, -1, 0], "height": 1}]})";
    EXPECT_EQ(shapesLeft(root, {1, 0, 0}, 0.2), 1U);
    EXPECT_EQ(shapesLeft(root, {1, 1, 0}, 0.2), 2U);
}

TEST(OccupiedBox, HoldsAllThatIsInsideAndIsNarrow)
{
    test::Random random(13);
    for (int sample = 0; sample < 300; ++sample) {
        const std::string root = test::randomTree(random, 3);
        const scenes::SceneField field = test::fieldOf(root);
        const render::Box box = scenes::occupiedBox(field.program(), field.words(), field.program().steps(),
                                                    {glm::dvec3(-3), glm::dvec3(3)})
                                    .box;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p = random.point(3);
            if (field.distance(p) > 0) continue;
            ASSERT_TRUE(!box.empty() && box.contains(p)) << root;
        }
    }
    // A thousand blended balls: bounds that add up all blends would be this large.
    const scenes::SceneField many = test::fieldOf(rowOfBalls(1000, 0.002, R"("kind": "union", "blendWidth": 0.1)"));
    EXPECT_GT(many.box().high.y, 10);
    const render::Box narrow =
        scenes::occupiedBox(many.program(), many.words(), many.program().steps(), many.box()).box;
    EXPECT_LT(narrow.high.y, 2);
}

void compareCells(const glm::ivec3& count)
{
    const scenes::SceneField field =
        test::fieldOf(rowOfBalls(64, 1, R"("kind": "union", "blend": "quadratic", "blendWidth": 0.3)"));
    const scenes::GridCells cells = scenes::pruneCells(field.program(), field.words(), field.program().steps(),
                                                       {{{-0.5, -0.5, -0.5}, {63.5, 0.5, 0.5}}, count});
    EXPECT_LE(cells.mostShapes, 2U);
    EXPECT_LE(cells.lists, 64U + 63U);
    EXPECT_LT(cells.meanShapes, 1.5);
    std::size_t withSteps = 0;
    for (const scenes::SceneCell& cell : cells.cells) withSteps += cell.count > 0;
    EXPECT_EQ(withSteps, cells.withSteps);
    EXPECT_LT(cells.withSurface, cells.withSteps);
    EXPECT_LT(cells.withSteps, cells.cells.size() / 2);
    test::Random random(12);
    scenes::SceneWalk walk(field.program(), field.words().words, false);
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p(random.number(-0.5, 63.5), random.number(-0.5, 0.5), random.number(-0.5, 0.5));
        const std::size_t index = cells.cellAt(p);
        const scenes::SceneCell& cell = cells.cells[index];
        const double truth = field.distance(p);
        if (cell.count == 0) {
            const double step = cells.clearance(index, p);
            EXPECT_GE(std::abs(truth), std::abs(step));
            EXPECT_GE(std::abs(step), 0.499 * glm::length(cells.cellSize()));
            EXPECT_EQ(truth < 0, step < 0);
            continue;
        }
        walk.run(cells.stepsOf(cell), p);
        EXPECT_NEAR(walk.state(0).distance, truth, scenes::Pruner::asShaders);
    }
}

TEST(PruningCells, SayWhatIsNearAndHowFarAnEmptyCellIsFromASurface)
{
    compareCells({512, 8, 8});
    compareCells({512, 16, 16});  // With two threads.
}

/// Costs of finding a scene's cells, for each cell with shapes.
struct CellCosts {
    double evaluations = 0, each = 0, bound = 0;
};

CellCosts costsOfCells(int shapes)
{
    const scenes::SceneField field = test::fieldOf(test::manyShapes(shapes));
    const scenes::ListVocabulary kinds = scenes::ListVocabulary::of(field.program(), field.words());
    const auto near =
        scenes::sceneGrid(field.program(), field.words(), kinds, scenes::cellsAcross(std::size_t(shapes)));
    const double all = double(near->cells.evaluations), cells = double(near->cells.withSteps);
    return {all, all / cells, double(near->cells.cells.size()) * shapes};
}

TEST(LongPruningCells, TakeHardlyMoreForEachCellOfManyShapes)
{
    const CellCosts of256 = costsOfCells(256), of1024 = costsOfCells(1024);
    EXPECT_LT(of1024.evaluations, 6.5e6);
    EXPECT_LT(of1024.each, 36);
    EXPECT_LT(of1024.each, 1.5 * of256.each) << "of four times as many shapes";
    EXPECT_GT(of1024.bound, 300 * of1024.evaluations) << "control: asking every shape for every cell";
}

/// Returns nested unions of eight, in which each ball is in the blend of all others.
std::string crowd(int depth)
{
    std::string text = R"({"kind": "union", "blend": "cubic", "blendWidth": 5, "children": [)";
    for (int i = 0; i < 8; ++i)
        text += (i > 0 ? ", " : "") + (depth > 1 ? crowd(depth - 1)
                                                 : R"({"kind": "sphere", "radius": 0.5, "translate": [)" +
                                                       std::to_string(0.01 * i) + ", 0, 0]}");
    return text + "]}";
}

TEST(LongPruneCells, EndWithTheirBudgetAndTheSceneIsWholeWithoutThem)
{
    const scenes::SceneField field = test::fieldOf(crowd(3));
    const auto& steps = field.program().steps();
    const render::Box box = scenes::occupiedBox(field.program(), field.words(), steps, field.box()).box;
    const auto pruned = [&](int across, const scenes::PruneBudget& budget) {
        return scenes::pruneCells(field.program(), field.words(), steps, {box, glm::ivec3(across)},
                                  scenes::Pruner::asShaders, budget);
    };
    for (const int across : {12, 48}) {  // With one thread, and with two.
        const scenes::GridCells all = pruned(across, {});
        EXPECT_TRUE(all.whole);
        EXPECT_GT(all.meanShapes, 250);  // The scene has 512 shapes.
        EXPECT_FALSE(pruned(across, {.bytes = 10'000}).whole);
        const scenes::GridCells few = pruned(across, {.evaluations = 50'000});
        EXPECT_FALSE(few.whole);
        EXPECT_LT(few.evaluations, 53'000U);
        EXPECT_TRUE(pruned(across, {all.steps.size() * 64, all.evaluations}).whole);
    }
}

TEST(SceneGrid, HasNoCellsWhereAllShapesAreInEach)
{
    const scenes::SceneField field = test::fieldOf(crowd(3));
    const auto near =
        scenes::sceneGrid(field.program(), field.words(), scenes::ListVocabulary::of(field.program(), field.words()),
                          96, {.evaluations = 1'000'000});
    EXPECT_TRUE(near->crowded);
    EXPECT_TRUE(near->cells.cells.empty());
    // If cells contain few of many shapes, larger cells are used.
    const scenes::SceneField many = test::fieldOf(test::manyShapes(600));
    const auto coarse =
        scenes::sceneGrid(many.program(), many.words(), scenes::ListVocabulary::of(many.program(), many.words()), 96,
                          {.evaluations = 1'000'000});
    EXPECT_FALSE(coarse->crowded);
    EXPECT_FALSE(coarse->cells.cells.empty());
    EXPECT_LT(std::max({coarse->cells.count.x, coarse->cells.count.y, coarse->cells.count.z}), 60);
}

TEST(SceneGrid, IsMadeAnewWhereARepeaterIsNoLongerFolded)
{
    const auto read = scenes::readScene(
        R"({"format": "vitrine-scene", "version": 1, "parameters": {"aside": {"value": 0, "range": [0, 1]}}, "root":
        {"kind": "union", "children": [{"kind": "boxFrame", "size": 3}, {"kind": "repeatAround", "count": 6, "child":
        {"kind": "capsule", "start": [0.1, 0, 0], "end": [0.9, 0, "aside"], "radius": 0.2}}]}})",
        "a.json", {});
    ASSERT_TRUE(read.scene);
    const scenes::SceneProgram program(read.scene);
    std::shared_ptr<const scenes::SceneGrid> former;
    for (const double aside : {0.0, 0.3, 0.0}) {
        const scenes::SceneConstants words = program.words(read.scene->numbersAt(0, std::vector<double>{aside}));
        const auto kinds = scenes::ListVocabulary::of(program, words);
        EXPECT_EQ(kinds.folds.size(), aside == 0 ? 1U : 0U);
        const auto grid = scenes::sceneGrid(program, words, kinds, 24, scenes::cellBudget, former.get());
        const auto whole = scenes::sceneGrid(program, words, kinds, 24);
        EXPECT_FALSE(grid->again);
        EXPECT_TRUE(*grid->records == *whole->records && *grid->lists == *whole->lists && *grid->grid == *whole->grid);
        former = grid;
    }
}

/// Returns the list of a cell, or of no cell, as the shader reads it.
std::vector<scenes::ListStep> listAt(const scenes::SceneGrid& grid, std::uint32_t first)
{
    std::vector<scenes::ListStep> list;
    if (first == ~std::uint32_t{0}) return list;
    for (std::size_t at = first * sizeof(scenes::ListStep);; at += sizeof(scenes::ListStep)) {
        if (at + sizeof(scenes::ListStep) > grid.lists->size()) ADD_FAILURE() << "a list has no end";
        list.emplace_back();
        std::memcpy(&list.back(), grid.lists->data() + at, sizeof(scenes::ListStep));
        if ((list.back().operation & scenes::moreSteps) == 0) return list;
    }
}

/// Returns the number of cells whose distance or list is another one.
std::size_t differentCells(const scenes::SceneGrid& a, const scenes::SceneGrid& b)
{
    const auto count = static_cast<std::size_t>(a.cells.count.x * a.cells.count.y * a.cells.count.z);
    if (a.grid->size() != b.grid->size() || a.cells.count != b.cells.count || *a.records != *b.records) return count;
    const std::size_t head = a.grid->size() - count * sizeof(glm::uvec2);
    if (std::memcmp(a.grid->data(), b.grid->data(), head) != 0) return count;
    std::size_t different = 0;
    const auto cell = [head](const scenes::SceneGrid& grid, std::size_t i) {
        glm::uvec2 entry;
        std::memcpy(&entry, grid.grid->data() + head + i * sizeof entry, sizeof entry);
        return entry;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const glm::uvec2 one = cell(a, i), other = cell(b, i);
        const std::vector<scenes::ListStep> left = listAt(a, one.x), right = listAt(b, other.x);
        const bool same = one.y == other.y && left.size() == right.size() &&
                          (left.empty() || std::memcmp(left.data(), right.data(), left.size() * sizeof left[0]) == 0);
        different += !same;
    }
    return different;
}

void moveAtRandom(int shapes)
{
    const auto read = scenes::readScene(
        R"({"format": "vitrine-scene", "version": 1, "root": )" + test::manyShapes(shapes) + "}", "a.json", {});
    ASSERT_TRUE(read.scene);
    const scenes::Scene& scene = *read.scene;
    const scenes::SceneProgram program(read.scene);
    const scenes::ListVocabulary kinds = scenes::ListVocabulary::of(program, program.words(scene.numbersAt(0)));
    const int across = shapes == 60 ? 32 : 72;  // With one thread, and with two.
    std::vector<double> numbers = scene.numbersAt(0);
    std::shared_ptr<const scenes::SceneGrid> grid = scenes::sceneGrid(program, program.words(numbers), kinds, across);
    ASSERT_TRUE(grid->hasCells());
    test::Random random(static_cast<unsigned>(shapes));
    int again = 0;
    double share = 0;
    constexpr int moves = 27;
    for (int i = 0; i < moves; ++i) {
        // A short way, anywhere within the scene, out of it, or all shapes: the width of their blend.
        const scenes::Node& node = scene.nodes[1 + std::size_t(random.number(0, shapes - 1e-9))];
        const double way = i % 4 == 0 ? 1 : 0.05;
        if (i % 13 == 12)
            numbers[scene.nodes[0].numbers + 1] *= 1.1;
        else
            for (std::uint32_t axis = 0; axis < 3; ++axis)
                numbers[node.translate + axis] = glm::clamp(numbers[node.translate + axis] + way * random.number(-1, 1),
                                                            -1.0, i % 10 == 9 ? 3.0 : 1.0);
        const scenes::SceneConstants words = program.words(numbers);
        const auto whole = scenes::sceneGrid(program, words, kinds, across);
        grid = scenes::sceneGrid(program, words, kinds, across, scenes::cellBudget, grid.get());
        ASSERT_EQ(differentCells(*grid, *whole), 0U) << shapes << " shapes, move " << i;
        EXPECT_EQ(grid->box.low, whole->box.low);
        EXPECT_EQ(grid->box.high, whole->box.high);
        again += grid->again;
        if (grid->again) share += double(grid->cells.evaluations) / double(whole->cells.evaluations);
    }
    EXPECT_GT(again, moves / 2) << "of " << shapes << " shapes, most moves leave the box of the scene as it is";
    if (shapes == 60) return;
    EXPECT_LT(share / again, 0.5) << "of the evaluations";
}

TEST(SceneGrid, MadeAgainAfterARandomMoveIsThatMadeFromNothing)
{
    moveAtRandom(60);
}

TEST(LongSceneGrid, MadeAgainAfterARandomMoveIsThatMadeFromNothing)
{
    moveAtRandom(300);
}

TEST(Pruning, OfManyOperandsLeavesTheSameDistance)
{
    const scenes::SceneField field = test::fieldOf(test::manyShapes(400));
    scenes::Pruner pruner(field.program(), field.words(), scenes::Pruner::asShaders);
    test::Random random(5);
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 center = random.point(1);
        const double radius = 0.05;
        const scenes::PrunedSteps left = pruner.prune(field.program().steps(), center, radius);
        EXPECT_LT(left.shapes, 60U);
        scenes::SceneWalk walk(field.program(), field.words().words, false);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 p = center + radius * random.number(0, 1) * random.direction();
            walk.run(left.steps, p);
            EXPECT_NEAR(walk.state(0).distance, field.distance(p), 2e-6);
        }
    }
}

#ifdef VITRINE_RAPIDCHECK
RC_GTEST_PROP(PruningProperty, LeavesAnyTreeAsItIsInTheBall, (unsigned seed))
{
    test::Random random(seed);
    Differences found;
    compare(test::fieldOf(randomOperation(random)), random, 50, 1, found);
    RC_ASSERT(found.distances + found.signs + found.nodes == 0);
}
#endif

}  // namespace
}  // namespace vitrine
