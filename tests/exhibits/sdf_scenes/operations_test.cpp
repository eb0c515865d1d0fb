// Effect of operations on distances and materials: without a blend, with an extreme one, with equal operands, in any
// order; copies, and operations on a single shape.

#include "exhibits/sdf_scenes/scene_functions_cpu.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include <cmath>
#include <functional>

namespace vitrine {
namespace {

using scenes::SceneField;

const std::string ball = R"({"kind": "sphere", "radius": 0.5})";
const std::string box = R"({"kind": "box", "size": [0.8, 0.6, 0.7], "translate": [0.3, 0.1, 0]})";
const std::string ring = R"({"kind": "torus", "translate": [-0.2, 0.2, 0.1], "rotate": [30, 0, 20]})";

std::string operation(const std::string& kind, const std::string& blend, const std::string& width,
                      const std::vector<std::string>& children)
{
    std::string text =
        "{\"kind\": \"" + kind + "\", \"blend\": \"" + blend + "\", \"blendWidth\": " + width + ", \"children\": [";
    for (std::size_t i = 0; i < children.size(); ++i) text += (i > 0 ? ", " : "") + children[i];
    return text + "]}";
}

const char* const kinds[] = {"union", "subtraction", "intersection", "xor"};
const char* const blends[] = {"quadratic", "cubic", "circular", "exponential"};

double hard(int kind, double a, double b)
{
    if (kind == 0) return std::min(a, b);
    if (kind == 1) return std::max(a, -b);
    if (kind == 2) return std::max(a, b);
    return std::max(std::min(a, b), -std::max(a, b));
}

template <typename Visit> void eachPoint(unsigned seed, int count, const Visit& visit)
{
    test::Random random(seed);
    for (int i = 0; i < count; ++i) visit(random.point(2));
}

TEST(SceneOperations, WithoutABlendAreHardToTheBit)
{
    const SceneField a = test::fieldOf(ball);
    const SceneField b = test::fieldOf(box);
    for (int kind = 0; kind < 4; ++kind)
        for (const char* blend : blends) {
            const SceneField both = test::fieldOf(operation(kinds[kind], blend, "0", {ball, box}));
            eachPoint(1, 500, [&](const glm::dvec3& p) {
                ASSERT_EQ(both.distance(p), hard(kind, a.distance(p), b.distance(p))) << kinds[kind] << ' ' << blend;
            });
        }
}

TEST(SceneOperations, BlendsAddAtMostTheirShareAndOnlyNearBoth)
{
    const double most[] = {0.25, 1.0 / 6, 1 - std::sqrt(0.5), 1};
    for (int profile = 0; profile < 4; ++profile)
        for (const double k : {1e-30, 1e-3, 0.2, 30.0, 1000.0, 1e30}) {
            const double width = std::min(k, 1000.0);
            eachPoint(2, 300, [&](const glm::dvec3& p) {
                const double united = glsl::sceneUnion(p.x, p.y, k, profile);
                ASSERT_LE(united, std::min(p.x, p.y)) << k;
                ASSERT_GE(united, std::min(p.x, p.y) - most[profile] * width - 1e-12) << k;
                if (profile < 3 && std::abs(p.x - p.y) >= width) {
                    ASSERT_EQ(united, std::min(p.x, p.y)) << k;
                }
                ASSERT_GE(glsl::sceneIntersection(p.x, p.y, k, profile), std::max(p.x, p.y));
                ASSERT_GE(glsl::sceneSubtraction(p.x, p.y, k, profile), std::max(p.x, -p.y));
            });
            // The whole addition at equal distances.
            EXPECT_NEAR(glsl::sceneUnion(0.3, 0.3, width, profile), 0.3 - most[profile] * width, 1e-9 * (1 + width));
        }
}

TEST(SceneOperations, DoNotCareForTheOrderOfTwo)
{
    for (const char* kind : {"union", "intersection", "xor"})
        for (const char* blend : blends) {
            const SceneField one = test::fieldOf(operation(kind, blend, "0.3", {ball, box}));
            const SceneField other = test::fieldOf(operation(kind, blend, "0.3", {box, ball}));
            eachPoint(3, 300,
                      [&](const glm::dvec3& p) { ASSERT_EQ(one.distance(p), other.distance(p)) << kind << blend; });
        }
}

TEST(SceneOperations, OfThreeGiveTheSameInAnyOrderWhereTheyCan)
{
    for (const char* blend : blends) {
        // The exponential blend does not depend on the order; the others agree up to their addition.
        const double tolerance = std::string(blend) == "exponential" ? 1e-12 : 0.3 * 0.3;
        const SceneField one = test::fieldOf(operation("union", blend, "0.3", {ball, box, ring}));
        const SceneField other = test::fieldOf(operation("union", blend, "0.3", {ring, ball, box}));
        const SceneField hardOne = test::fieldOf(operation("union", blend, "0", {ball, box, ring}));
        const SceneField hardOther = test::fieldOf(operation("union", blend, "0", {ring, ball, box}));
        eachPoint(4, 500, [&](const glm::dvec3& p) {
            ASSERT_NEAR(one.distance(p), other.distance(p), tolerance) << blend;
            ASSERT_EQ(hardOne.distance(p), hardOther.distance(p));
        });
    }
}

TEST(SceneOperations, EqualOperandsLeaveNothingOrThemselves)
{
    const SceneField own = test::fieldOf(box);
    const SceneField twice = test::fieldOf(operation("union", "quadratic", "0", {box, box}));
    const SceneField shared = test::fieldOf(operation("intersection", "quadratic", "0", {box, box}));
    const SceneField without = test::fieldOf(operation("subtraction", "quadratic", "0", {box, box}));
    const SceneField either = test::fieldOf(operation("xor", "quadratic", "0", {box, box}));
    eachPoint(5, 500, [&](const glm::dvec3& p) {
        ASSERT_EQ(twice.distance(p), own.distance(p));
        ASSERT_EQ(shared.distance(p), own.distance(p));
        ASSERT_GE(without.distance(p), 0);
        ASSERT_GE(either.distance(p), 0);
    });
}

TEST(SceneOperations, XorIsInAnOddNumberOfThree)
{
    const SceneField all = test::fieldOf(operation("xor", "quadratic", "0", {ball, box, ring}));
    const SceneField fields[] = {test::fieldOf(ball), test::fieldOf(box), test::fieldOf(ring)};
    eachPoint(6, 2000, [&](const glm::dvec3& p) {
        int inside = 0;
        for (const SceneField& field : fields) inside += field.distance(p) < 0 ? 1 : 0;
        ASSERT_EQ(all.distance(p) < 0, inside % 2 == 1);
    });
}

TEST(SceneOperations, NestToAnyDepth)
{
    std::string text = ball;
    for (int depth = 0; depth < 2000; ++depth)
        text = "{\"kind\": \"union\", \"children\": [" + text + (depth % 100 == 0 ? ", " + box : "") + "]}";
    const SceneField deep = test::fieldOf(text);
    const SceneField flat = test::fieldOf(operation("union", "cubic", "0", {ball, box}));
    eachPoint(7, 50, [&](const glm::dvec3& p) { ASSERT_EQ(deep.distance(p), flat.distance(p)); });
}

/// The derivative of a blend by its second operand is the weight of that material.
TEST(SceneOperations, SharesAreTheDerivativesOfBlends)
{
    using Function = double (*)(double, double, double, int);
    struct Pair {
        Function distance, share;
        double sign;
    };
    const Pair pairs[] = {{glsl::sceneUnion, glsl::sceneUnionShare, 1},
                          {glsl::sceneIntersection, glsl::sceneIntersectionShare, 1},
                          {glsl::sceneSubtraction, glsl::sceneSubtractionShare, -1}};
    for (const Pair& pair : pairs)
        for (int profile = 0; profile < 4; ++profile)
            eachPoint(8, 400, [&](const glm::dvec3& p) {
                const double h = 1e-6;
                if (std::abs(p.x - p.y) < 1e-3 || std::abs(p.x + p.y) < 1e-3)
                    return;  // The slope of the circle jumps there.
                const double slope =
                    (pair.distance(p.x, p.y + h, 0.4, profile) - pair.distance(p.x, p.y - h, 0.4, profile)) / (2 * h);
                ASSERT_NEAR(pair.share(p.x, p.y, 0.4, profile), pair.sign * slope, 1e-4) << profile;
            });
}

TEST(SceneOperations, BlendMaterialsWhereTheyBlendShapes)
{
    const std::string head = R"("materials": {
        "red": {"model": "pbr", "color": [1, 0, 0]}, "blue": {"model": "pbr", "color": [0, 0, 1]}},)";
    const auto ballAt = [](const char* x, const char* material) {
        return std::string(R"({"kind": "sphere", "radius": 0.5, "translate": [)") + x + ", 0, 0], \"material\": \"" +
               material + "\"}";
    };
    const SceneField field(
        test::sceneOf(operation("union", "quadratic", "0.6", {ballAt("-0.5", "red"), ballAt("0.5", "blue")}), head));
    EXPECT_EQ(field.sample({-1, 0, 0}).material[0], 1);
    EXPECT_EQ(field.sample({-1, 0, 0}).material[2], 0);
    EXPECT_EQ(field.sample({-1, 0, 0}).node, 1U);
    EXPECT_EQ(field.sample({1, 0, 0}).material[2], 1);
    EXPECT_EQ(field.sample({1, 0, 0}).node, 2U);
    EXPECT_NEAR(field.sample({0, 0.2, 0}).material[0], 0.5, 1e-12);
    double before = -1;
    for (double x = -0.9; x <= 0.9; x += 0.01) {
        const scenes::SceneSample sample = field.sample({x, 0.3, 0});
        EXPECT_EQ(sample.distance, field.distance({x, 0.3, 0}));
        EXPECT_GE(sample.material[2], before);
        before = sample.material[2];
    }
}

/// A repetition must equal the union of all its copies.
TEST(SceneOperations, RepetitionsAreTheUnionOfTheirCopies)
{
    test::Random random(9);
    for (int sample = 0; sample < 40; ++sample) {
        const double x = random.number(-0.4, 0.4);
        const double spacing = random.number(0.7, 1.5);
        const int count = 1 + random.below(6);
        const std::string child = "{\"kind\": \"capsule\", \"start\": [" + std::to_string(x) +
                                  ", 0, 0], \"end\": [0.2, 0.5, 0.1], \"radius\": 0.15}";
        const SceneField repeated =
            test::fieldOf("{\"kind\": \"repeat\", \"spacing\": [" + std::to_string(spacing) + ", 0, 1], \"count\": [" +
                          std::to_string(count) + ", 1, 2], \"child\": " + child + "}");
        std::vector<std::string> copies;
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < 2; ++k)
                copies.push_back(child.substr(0, child.size() - 1) + ", \"translate\": [" +
                                 std::to_string((i - 0.5 * (count - 1)) * std::stod(std::to_string(spacing))) +
                                 ", 0, " + std::to_string(k - 0.5) + "]}");
        const SceneField written = test::fieldOf(operation("union", "quadratic", "0", copies));
        eachPoint(10, 300, [&](const glm::dvec3& p) {
            ASSERT_NEAR(repeated.distance(p * 2.0), written.distance(p * 2.0), 1e-5);
        });
    }
}

TEST(SceneOperations, RepetitionsAroundAnAxisAreTheUnionOfTheirCopies)
{
    test::Random random(10);
    for (int sample = 0; sample < 40; ++sample) {
        const int count = 1 + random.below(12);
        const std::string child = "{\"kind\": \"box\", \"size\": [0.5, 0.3, " +
                                  std::to_string(random.number(0.1, 0.6)) + "], \"translate\": [" +
                                  std::to_string(random.number(0.3, 1)) + ", 0.1, " +
                                  std::to_string(random.number(-0.6, 0.6)) + "]}";
        const SceneField repeated = test::fieldOf("{\"kind\": \"repeatAround\", \"count\": " + std::to_string(count) +
                                                  ", \"child\": " + child + "}");
        std::vector<std::string> copies;
        for (int i = 0; i < count; ++i)
            copies.push_back("{\"kind\": \"union\", \"children\": [" + child + "], \"rotate\": [0, \"" +
                             std::to_string(-i) + " * 360deg / " + std::to_string(count) + "\", 0]}");
        const SceneField written = test::fieldOf(operation("union", "quadratic", "0", copies));
        eachPoint(11, 300, [&](const glm::dvec3& p) {
            ASSERT_NEAR(repeated.distance(p), written.distance(p), 1e-6) << child << count;
        });
    }
}

TEST(SceneOperations, OfBallsBeforeTheAxisOneCopyIsAskedHoweverFarTheyReach)
{
    test::Random random(14);
    const auto number = [&](double low, double high) { return std::to_string(random.number(low, high)); };
    for (int sample = 0; sample < 40; ++sample) {
        const std::string count = std::to_string(2 + random.below(12));
        // The second petal, a control, has an end beside the plane.
        const std::string start = number(0, 0.5) + ", " + number(-0.3, 0.3) + ", ";
        const std::string end = number(0.2, 1) + ", " + number(-0.5, 0.8) + ", ";
        const std::string radius = "\"radius\": " + number(0.05, 0.4);
        const std::string radii = "\"startRadius\": " + number(0.05, 0.4) + ", \"endRadius\": " + number(0.01, 0.3);
        const bool isVesica = sample % 2 != 0;
        const auto petal = [&](const char* z) {
            return std::string("{\"kind\": \"") + (isVesica ? "vesica" : "roundConeBetween") + "\", \"start\": [" +
                   start + "0], \"end\": [" + end + z + "], " + (isVesica ? radius : radii) +
                   ", \"translate\": [0.1, 0.2, 0]}";
        };
        const auto around = [&](const std::string& child) {
            return "{\"kind\": \"repeatAround\", \"count\": " + count + ", \"child\": " + child + "}";
        };
        const auto asked = [&](const std::string& child) {
            const auto scene = test::sceneOf(around(child));
            return scenes::SceneProgram(scene).words(scene->numbersAt(0)).asked.front();
        };
        EXPECT_EQ(asked(petal("0")), 1);
        EXPECT_GT(asked(petal("0.2")), 1) << "control";
        std::vector<std::string> copies;
        for (int i = 0; i < std::stoi(count); ++i)
            copies.push_back("{\"kind\": \"union\", \"children\": [" + petal("0") + "], \"rotate\": [0, \"" +
                             std::to_string(-i) + " * 360deg / " + count + "\", 0]}");
        const SceneField repeated = test::fieldOf(around(petal("0")));
        const SceneField written = test::fieldOf(operation("union", "quadratic", "0", copies));
        eachPoint(15, 300, [&](const glm::dvec3& p) {
            ASSERT_NEAR(repeated.distance(p), written.distance(p), 1e-6) << petal("0") << count;
        });
    }
}

TEST(SceneOperations, EndlessRepetitionsAreTheSameOneCellOnAlsoBelowZero)
{
    const SceneField field = test::fieldOf(R"({"kind": "repeat", "spacing": [1, 2, 1.5], "count": [0, 0, 0],
        "child": {"kind": "box", "size": [0.5, 0.7, 0.2], "translate": [0.2, 0.1, -0.3], "rotate": [10, 20, 30]}})");
    eachPoint(12, 500, [&](const glm::dvec3& p) {
        ASSERT_NEAR(field.distance(p), field.distance(p - glm::dvec3(5, 8, 6)), 1e-9);
        ASSERT_NEAR(field.distance(p), field.distance(p + glm::dvec3(1, 2, 1.5)), 1e-9);
    });
}

TEST(SceneOperations, CopiesThatMoveTooNearAreNotAskedWithoutEnd)
{
    const auto scene = test::sceneOf(R"({"kind": "repeat", "spacing": ["2 - t", "2 - t", "2 - t"], "count": [0, 0, 0],
        "child": {"kind": "sphere", "radius": 0.5, "translate": [0.1, 0, 0]}})");
    const scenes::SceneProgram program(scene);
    EXPECT_LE(program.words(scene->numbersAt(0)).asked.front(), scenes::mostCopiesAsked);
    const scenes::SceneConstants words = program.words(scene->numbersAt(1.999));
    EXPECT_GT(words.asked.front(), 1e6);
    const double* times = &words.words[program.nodes().front().numbers + 9];
    EXPECT_LE(times[0] * times[1] * times[2], scenes::mostCopiesAsked);
}

TEST(SceneOperations, TwistsInABlendAreBoundedUpToTheWidthAtWhichTheyNoLongerAre)
{
    // A wider blend reaches farther from the twisted child: once the bounds are endless, they stay so.
    const std::string turned =
        R"({"kind": "twist", "rate": 50, "child": {"kind": "union", "blendWidth": 0.03, "children": [)"
        R"({"kind": "box", "size": [0.24, 2.3, 0.24]},)"
        R"({"kind": "box", "size": [0.24, 2.3, 0.24], "rotate": [0, 45, 0]}]}})";
    std::string ends;
    for (int i = 0; i <= 40; ++i) {
        const double width = 0.02 * i;
        const auto field = test::fieldOf(operation("union", "cubic", std::to_string(width), {turned, box}));
        ends += field.box().high.y < 1e6 ? '.' : '-';
    }
    EXPECT_EQ(ends.find_last_of('.') + 1, std::min(ends.find('-'), ends.size())) << ends;
    EXPECT_GE(ends.find('-'), 15U) << ends;
}

TEST(SceneOperations, ProfilesAreExtrudedAndRevolvedToShapesThatAreKnown)
{
    struct Twin {
        const char *made, *known;
    };
    const Twin twins[] = {
        {R"({"kind": "extrude", "height": 0.6, "child": {"kind": "rectangle", "width": 0.8, "height": 0.4}})",
         R"({"kind": "box", "size": [0.8, 0.4, 0.6]})"},
        {R"({"kind": "extrude", "height": 0.6, "child": {"kind": "hexagon", "inradius": 0.4}})",
         R"({"kind": "hexagonalPrism", "inradius": 0.4, "height": 0.6})"},
        {R"({"kind": "revolve", "offset": 0.5, "child": {"kind": "circle", "radius": 0.2}})",
         R"({"kind": "torus", "majorRadius": 0.5, "minorRadius": 0.2})"},
        {R"({"kind": "round", "radius": 0.1, "child": {"kind": "box", "size": [0.4, 0.6, 0.5]}})",
         R"({"kind": "roundBox", "size": [0.6, 0.8, 0.7], "rounding": 0.1})"},
        {R"({"kind": "morph", "share": 0, "children": [{"kind": "sphere"}, {"kind": "box"}]})",
         R"({"kind": "sphere"})"},
        {R"({"kind": "morph", "share": 1, "children": [{"kind": "sphere"}, {"kind": "box"}]})", R"({"kind": "box"})"},
        {R"({"kind": "twist", "rate": 0, "child": {"kind": "box"}})", R"({"kind": "box"})"},
        {R"({"kind": "bend", "rate": 0, "child": {"kind": "box"}})", R"({"kind": "box"})"},
        {R"({"kind": "displace", "amplitude": 0, "child": {"kind": "box"}})", R"({"kind": "box"})"}};
    for (const Twin& twin : twins) {
        const SceneField made = test::fieldOf(twin.made);
        const SceneField known = test::fieldOf(twin.known);
        eachPoint(13, 300, [&](const glm::dvec3& p) {
            // A rounded box is equal outside; inside, it is nearer by the difference of the corners.
            const double d = known.distance(p);
            ASSERT_NEAR(std::max(made.distance(p), 0.0), std::max(d, 0.0), 1e-12) << twin.made;
            ASSERT_EQ(made.distance(p) < 0, d < 0) << twin.made;
        });
    }
}

TEST(SceneOperations, SayWhatIsExact)
{
    const auto exactness = [](const std::string& root) {
        return scenes::SceneProgram(test::sceneOf(root)).nodes().front().exactness;
    };
    using scenes::Exactness;
    EXPECT_EQ(exactness(ball), Exactness::exact);
    EXPECT_EQ(exactness(operation("union", "quadratic", "0", {ball, box})), Exactness::exactOutside);
    EXPECT_EQ(exactness(operation("union", "quadratic", "0.1", {ball, box})), Exactness::bound);
    EXPECT_EQ(exactness(operation("union", "quadratic", "\"0 * t\"", {ball, box})), Exactness::bound);
    EXPECT_EQ(exactness(operation("intersection", "quadratic", "0", {ball, box})), Exactness::bound);
    EXPECT_EQ(exactness(R"({"kind": "extrude", "child": {"kind": "rectangle"}})"), Exactness::exact);
    EXPECT_EQ(exactness(R"({"kind": "extrude", "child": {"kind": "sphere"}})"), Exactness::bound);
    EXPECT_EQ(exactness(R"({"kind": "round", "child": {"kind": "noise"}})"), Exactness::bound);
    EXPECT_EQ(exactness(R"({"kind": "box", "scale": 2})"), Exactness::exact);
    EXPECT_EQ(exactness(R"({"kind": "box", "scale": [2, 2, 1]})"), Exactness::bound);
}

TEST(SceneOperations, WhatIsHiddenIsNotThere)
{
    const SceneField field =
        test::fieldOf(R"({"kind": "subtraction", "children": [{"kind": "sphere", "hidden": true}, {"kind": "box"}]})");
    EXPECT_EQ(field.distance({0, 0, 0}), 1e9);
    EXPECT_EQ(field.sample({0, 0, 0}).node, scenes::noIndex);
    EXPECT_TRUE(field.program().nodes().empty());
    const SceneField kept =
        test::fieldOf(R"({"kind": "subtraction", "children": [{"kind": "sphere"}, {"kind": "box", "hidden": true}]})");
    EXPECT_EQ(kept.distance({0, 0, 0}), -0.5);
}

TEST(SceneOperations, AreFiniteWhereverTheyAreAsked)
{
    test::Random random(14);
    for (int sample = 0; sample < 500; ++sample) {
        const std::string root = test::randomTree(random, 3);
        const SceneField field = test::fieldOf(root);
        for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(1e-300), glm::dvec3(1e7, -1e7, 3), glm::dvec3(0, 1e5, 0)})
            ASSERT_TRUE(std::isfinite(field.distance(p))) << root;
    }
}

}  // namespace
}  // namespace vitrine
