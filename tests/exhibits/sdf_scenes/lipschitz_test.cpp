// No step may pass a surface, whatever the scene file: random trees of all kinds.

#include "exhibits/sdf_scenes/scene_functions_cpu.h"
#include "tests/exhibits/sdf_scenes/ray_steps.h"

#include <cmath>

namespace vitrine {
namespace {

/// Returns the largest slope between nearby points.
template <typename Field> double steepest(const Field& field, test::Random& random, int pairs)
{
    double most = 0;
    for (int i = 0; i < pairs; ++i) {
        const glm::dvec3 p = random.point(3);
        const double apart = std::pow(10.0, random.number(-4, 0));
        const glm::dvec3 q = p + apart * random.direction();
        most = std::max(most, std::abs(field(p) - field(q)) / glm::length(p - q));
    }
    return most;
}

auto distanceOf(const scenes::SceneField& field)
{
    return [&field](const glm::dvec3& p) { return field.distance(p); };
}

TEST(SceneLipschitz, NoKindOfNodeIsSteeperThanOne)
{
    test::Random random(1);
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        int read = 0;
        for (int sample = 0; sample < 40 && read < 20; ++sample) {
            std::string further = test::randomPlace(random, false);
            if (kind.form == scenes::Form::modifier || kind.form == scenes::Form::repeater)
                further += ", \"child\": " + test::randomTree(random, 0);
            else if (kind.form != scenes::Form::shape)
                further += ", \"children\": [" + test::randomTree(random, 0) + ", " + test::randomTree(random, 0) + "]";
            const std::string root = test::randomNode(kind, random, further);
            const scenes::ReadScene made = test::readText(test::sceneText(root));
            if (!made.scene) continue;
            ++read;
            const scenes::SceneField field(made.scene);
            EXPECT_LE(steepest(distanceOf(field), random, 2000), 1 + 1e-6) << root;
        }
        EXPECT_GE(read, 5) << kind.name;
    }
}

TEST(LongSceneLipschitz, NoTreeIsSteeperThanOne)
{
    test::Random random(2);
    for (int sample = 0; sample < 10000; ++sample) {
        const std::string root = test::randomTree(random, 4);
        const scenes::SceneField field = test::fieldOf(root);
        ASSERT_LE(steepest(distanceOf(field), random, 200), 1 + 1e-6) << root;
    }
}

TEST(LongSceneLipschitz, NoRayPassesASurface)
{
    test::Random random(3);
    for (int sample = 0; sample < 2000; ++sample) {
        const std::string root = test::randomTree(random, 3);
        const scenes::SceneField field = test::fieldOf(root);
        ASSERT_EQ(test::overshoots(distanceOf(field), random, 50), 0) << root;
    }
}

/// Control: the same test detects a missing factor.
TEST(SceneLipschitzControl, FieldsWithoutTheirFactorAreFound)
{
    test::Random random(4);
    const glm::dvec3 half(0.5);
    const auto twisted = [&](const glm::dvec3& p) { return glsl::sdfBox(glsl::sceneTwist(p, 2), half); };
    const auto scaled = [&](const glm::dvec3& p) { return glsl::sdfBox(p / glm::dvec3(0.25, 1, 1), half); };
    const auto displaced = [&](const glm::dvec3& p) {
        return glsl::sdfBox(p, half) + 0.3 * glsl::sceneFractalNoise(p * 8.0, 1, 0.5);
    };
    // One copy only, of an asymmetric shape.
    const auto repeated = [&](const glm::dvec3& p) {
        const glm::dvec3 q(glsl::sceneCell(p.x, 0, 1, 0, 0, 1), p.y, p.z);
        return glsl::sdfSphere(q - glm::dvec3(0.4, 0, 0), 0.1);
    };
    EXPECT_GT(steepest(twisted, random, 20000), 1.2);
    EXPECT_GT(steepest(scaled, random, 20000), 1.2);
    EXPECT_GT(steepest(displaced, random, 20000), 1.2);
    EXPECT_GT(steepest(repeated, random, 20000), 1.2);
    EXPECT_GT(test::overshoots(scaled, random, 20000), 0);
    EXPECT_GT(test::overshoots(displaced, random, 20000), 0);
}

TEST(SceneLipschitz, EveryNodeSaysByHowMuchItWasDivided)
{
    const scenes::SceneField field =
        test::fieldOf(R"({"kind": "twist", "rate": 90, "child": {"kind": "sphere", "radius": 0.5}})");
    const glm::dvec3 p(0.9, 0.3, 0);
    const std::vector<scenes::NodeSample> nodes = field.nodes(p);
    ASSERT_EQ(nodes.size(), 2U);
    EXPECT_NEAR(nodes[0].lipschitz, 1 + std::acos(0.0) * 0.9, 1e-12);
    EXPECT_EQ(nodes[1].lipschitz, 1);
    EXPECT_LT(nodes[0].distance, nodes[1].distance);
    EXPECT_GT(nodes[0].distance * nodes[0].lipschitz, 0.6 * nodes[1].distance);
}

TEST(SceneBox, HoldsAllThatIsInside)
{
    test::Random random(5);
    int inside = 0;
    for (int sample = 0; sample < 3000; ++sample) {
        const std::string root = test::randomTree(random, 3);
        const scenes::SceneField field = test::fieldOf(root);
        const render::Box box = scenes::grown(field.box(), 1e-9);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p = random.point(4);
            if (field.distance(p) > 0) continue;
            ++inside;
            ASSERT_TRUE(box.contains(p)) << p.x << ' ' << p.y << ' ' << p.z << '\n' << root;
        }
    }
    EXPECT_GT(inside, 10000);
}

}  // namespace
}  // namespace vitrine
