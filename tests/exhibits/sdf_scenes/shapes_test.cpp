// All shapes of scene files compared with their definition: sign, distance and slope, with all transforms.

#include "exhibits/sdf_scenes/scene_functions_cpu.h"
#include "tests/exhibits/sdf_scenes/solids.h"
#include "tests/exhibits/sdf_scenes/support.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using scenes::Exactness;
using scenes::Form;
using scenes::NodeKind;

struct Sample {
    std::string json;
    scenes::SceneField field;
    test::Inside inside;
};

/// Returns a valid shape with random numbers.
Sample sampleOf(const NodeKind& kind, test::Random& random, const std::string& further = "")
{
    while (true) {
        std::string json = test::randomNode(kind, random, further);
        const scenes::ReadScene read = test::readText(test::sceneText(json));
        if (!read.scene) continue;
        std::vector<double> v;
        for (std::size_t i = 0; i < kind.numbers(); ++i)
            v.push_back(read.scene->numbers[read.scene->nodes.front().numbers + i].value);
        return {std::move(json), scenes::SceneField(read.scene), test::insideOf(kind.name, v.data())};
    }
}

template <typename Visit> void eachShape(const Visit& visit)
{
    for (const NodeKind& kind : scenes::nodeKinds())
        if (kind.form == Form::shape && kind.name != "noise") visit(kind);
}

TEST(SceneShapes, AreThe16OfTheReferenceAndTheOtherExactOnes)
{
    for (const char* name :
         {"plane", "sphere", "box", "roundBox", "boxFrame", "cylinder", "capsule", "torus", "triangle",
          "triangularPrism", "link", "cone", "pyramid", "hexagonalPrism", "ellipsoid", "octahedron"})
        EXPECT_TRUE(scenes::findKind(name)) << name;
    for (const char* name : {"cappedTorus", "infiniteCylinder", "infiniteCone", "roundCylinder", "cappedCone",
                             "cappedConeBetween", "solidAngle", "cutSphere", "cutHollowSphere", "deathStar",
                             "roundCone", "roundConeBetween", "vesica", "rhombus", "quad"})
        EXPECT_TRUE(scenes::findKind(name)) << name;
}

TEST(SceneShapes, HaveTheSignOfTheirInside)
{
    test::Random random(11);
    eachShape([&](const NodeKind& kind) {
        for (int set = 0; set < 10; ++set) {
            const Sample sample = sampleOf(kind, random);
            ASSERT_TRUE(sample.inside) << kind.name;
            for (int i = 0; i < 500; ++i) {
                const glm::dvec3 p = random.point(1.5);
                const double d = sample.field.distance(p);
                if (std::abs(d) > 1e-9) {
                    ASSERT_EQ(d < 0, sample.inside(p))
                        << d << ' ' << p.x << ' ' << p.y << ' ' << p.z << ' ' << sample.json;
                }
            }
        }
    });
}

/// No point of the other side is nearer than the distance. The nearest point, down the gradient, is on the surface.
TEST(LongSceneShapes, AreExactWhereTheirTableSaysSo)
{
    test::Random random(12);
    eachShape([&](const NodeKind& kind) {
        int unlike = 0;
        int points = 0;
        for (int set = 0; set < 20; ++set) {
            const Sample sample = sampleOf(kind, random);
            for (int i = 0; i < 20; ++i, ++points) {
                const glm::dvec3 p = random.point(1.1);
                const double d = sample.field.distance(p);
                EXPECT_TRUE(test::isBound(sample.inside, p, d, random)) << d << ' ' << sample.json;
                const bool exact =
                    kind.exactness == Exactness::exact || (kind.exactness == Exactness::exactOutside && d > 0);
                if (!exact) continue;
                const glm::dvec3 nearest = p - d * test::gradientAt(sample.field, p);
                unlike += test::isOnSurface(sample.inside, nearest, 1e-4, random) ? 0 : 1;
            }
        }
        // If two points are equally near, the gradient leads to neither; few random points are there.
        EXPECT_LE(unlike, points / 50) << kind.name;
    });
}

/// Control: the same tests distinguish bounds from distances, and detect errors.
TEST(SceneShapesControl, BoundsAndFaultsAreFound)
{
    test::Random random(18);
    const glm::dvec3 radii(1, 0.3, 0.2);
    const double v[] = {radii.x, radii.y, radii.z};
    const test::Inside inside = test::insideOf("ellipsoid", v);
    int off = 0;
    int beyond = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = random.direction() * 1.2;
        const double bound = glsl::sdfEllipsoidBound(p, radii);
        off += test::isOnSurface(inside, p - bound * glm::normalize(p), 1e-4, random) ? 0 : 1;
        beyond += test::isBound(inside, p, 1.1 * glsl::sceneEllipsoid(p, radii), random) ? 0 : 1;
    }
    EXPECT_GT(off, 90);
    EXPECT_GT(beyond, 10);
}

TEST(SceneShapes, HaveAGradientOfLengthOneWhereTheyAreExact)
{
    test::Random random(13);
    eachShape([&](const NodeKind& kind) {
        int unlike = 0;
        for (int i = 0; i < 400; ++i) {
            const Sample sample = sampleOf(kind, random);
            const glm::dvec3 p = random.point(1.5);
            const bool counts = kind.exactness == Exactness::exact || sample.field.distance(p) > 0;
            const double slope = glm::length(test::gradientAt(sample.field, p));
            EXPECT_LE(slope, 1 + 1e-6) << sample.json;
            unlike += counts && std::abs(slope - 1) > 1e-6 ? 1 : 0;
        }
        // At creases of the field, differences are shorter; few random points are there.
        EXPECT_LE(unlike, 2) << kind.name;
    });
}

/// The transforms once more without the library: points are multiplied by the inverse matrix.
TEST(SceneShapes, AllTurnMoveAndScale)
{
    test::Random random(14);
    eachShape([&](const NodeKind& kind) {
        for (int set = 0; set < 10; ++set) {
            const glm::dvec3 t = random.point(1);
            const glm::dvec3 r = random.point(180);
            const double s = random.number(0.3, 3);
            const std::string place = ", \"translate\": [" + std::to_string(t.x) + "," + std::to_string(t.y) + "," +
                                      std::to_string(t.z) + "], \"rotate\": [" + std::to_string(r.x) + "," +
                                      std::to_string(r.y) + "," + std::to_string(r.z) +
                                      "], \"scale\": " + std::to_string(s);
            Sample sample = sampleOf(kind, random, place);
            const scenes::Node& node = sample.field.program().scene().nodes.front();
            const auto number = [&](std::uint32_t i) { return sample.field.program().scene().numbers[i].value; };
            glm::dmat4 world(1);
            world =
                glm::translate(world, {number(node.translate), number(node.translate + 1), number(node.translate + 2)});
            world = glm::rotate(world, number(node.rotate), {1, 0, 0});
            world = glm::rotate(world, number(node.rotate + 1), {0, 1, 0});
            world = glm::rotate(world, number(node.rotate + 2), {0, 0, 1});
            world = glm::scale(world, glm::dvec3(number(node.scale)));
            const glm::dmat4 local = glm::inverse(world);
            const std::string plain = sample.json.substr(0, sample.json.size() - place.size() - 1) + '}';
            const scenes::SceneField own = test::fieldOf(plain);
            for (int i = 0; i < 50; ++i) {
                const glm::dvec3 p = random.point(2);
                const double there = own.distance(glm::dvec3(local * glm::dvec4(p, 1)));
                EXPECT_NEAR(sample.field.distance(p), there * number(node.scale), 1e-9) << sample.json;
            }
            EXPECT_EQ(sample.field.program().nodes().front().exactness, kind.exactness);
        }
    });
}

TEST(SceneShapes, ScaledUnevenlyKeepTheirSignAndAreBounds)
{
    test::Random random(15);
    eachShape([&](const NodeKind& kind) {
        for (int set = 0; set < 5; ++set) {
            const glm::dvec3 s(random.number(0.5, 2), random.number(0.5, 2), random.number(0.5, 2));
            const Sample sample = sampleOf(kind, random,
                                           ", \"scale\": [" + std::to_string(s.x) + "," + std::to_string(s.y) + "," +
                                               std::to_string(s.z) + "]");
            const scenes::Scene& scene = sample.field.program().scene();
            const std::uint32_t first = scene.nodes.front().scale;
            const glm::dvec3 factors(scene.numbers[first].value, scene.numbers[first + 1].value,
                                     scene.numbers[first + 2].value);
            EXPECT_EQ(sample.field.program().nodes().front().exactness, Exactness::bound);
            for (int i = 0; i < 6; ++i) {
                const glm::dvec3 p = random.point(1.5);
                const double d = sample.field.distance(p);
                const auto inside = [&](const glm::dvec3& q) { return sample.inside(q / factors); };
                EXPECT_TRUE(std::abs(d) <= 1e-9 || (d < 0) == inside(p)) << sample.json;
                EXPECT_TRUE(test::isBound(inside, p, d, random)) << sample.json;
            }
        }
    });
}

TEST(SceneShapes, TheEllipsoidIsExactAtAnyAspect)
{
    test::Random random(16);
    for (int set = 0; set < 2000; ++set) {
        const glm::dvec3 r(std::pow(10, random.number(-2.5, 0)), std::pow(10, random.number(-2.5, 0)),
                           std::pow(10, random.number(-2.5, 0)));
        // Points along the normal of a surface point have known distances, until normals cross.
        const glm::dvec3 u = random.direction();
        const glm::dvec3 foot = u * r;
        const glm::dvec3 normal = glm::normalize(u / r);
        for (const double out : {0.001, 0.1, 3.0}) {
            EXPECT_NEAR(glsl::sceneEllipsoid(foot + normal * out, r), out, 2e-5 * (1 + out))
                << r.x << ' ' << r.y << ' ' << r.z;
        }
        const double least = std::min({r.x, r.y, r.z});
        const double curved = least * least / std::max({r.x, r.y, r.z});  // Smallest radius of curvature.
        EXPECT_NEAR(glsl::sceneEllipsoid(foot - normal * (0.9 * curved), r), -0.9 * curved, 2e-5);
        EXPECT_NEAR(glsl::sceneEllipsoid(glm::dvec3(0), r), -least, 1e-5);
    }
}

TEST(SceneShapes, TheNoiseNeverExceedsItsSlopeAndItsRange)
{
    test::Random random(17);
    double steepest = 0;
    double most = 0;
    for (int i = 0; i < 200000; ++i) {
        const glm::dvec3 p = random.point(50);
        const double h = 1e-5;
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0);
            step[axis] = h;
            gradient[axis] = (glsl::sceneValueNoise(p + step) - glsl::sceneValueNoise(p - step)) / (2 * h);
        }
        steepest = std::max(steepest, glm::length(gradient));
        most = std::max(most, std::abs(glsl::sceneValueNoise(p)));
    }
    EXPECT_LE(steepest, glsl::noiseSteepest(glsl::NOISE_VALUE));
    EXPECT_GE(steepest, 0.7 * glsl::noiseSteepest(glsl::NOISE_VALUE));  // The bound is tight.
    EXPECT_LE(most, 1);
    EXPECT_GE(most, 0.9);
}

}  // namespace
}  // namespace vitrine
