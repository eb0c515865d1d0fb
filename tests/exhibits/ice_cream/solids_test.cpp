// Solids of the ice cream: their dimensions, skipping most of them without a change, and steps that pass no surface.

#include "exhibits/framework/table/random_values.h"
#include "exhibits/ice_cream/ice_cream_cpu.h"
#include "exhibits/ice_cream/ice_cream_cpu32.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "tests/exhibits/ice_cream/every_solid.h"
#include "tests/exhibits/ice_cream/reference_shape.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vitrine::ice_cream {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::EverySolid;

const IceCreamTable& table()
{
    static const IceCreamTable made;
    return made;
}

/// Returns the values of the reference, with the candies where they floated in the air.
ParameterValues source()
{
    ParameterValues values = table().initial();
    const dvec3 inTheAir[]{{0.5, 1, 0.866}, {-1, 0.8, 0}, {0.5, 1.2, -0.866}};
    for (std::size_t i = 0; i < 3; ++i) {
        values.set(table().candies[7 + i].x, inTheAir[i].x);
        values.set(table().candies[7 + i].y, inTheAir[i].y);
        values.set(table().candies[7 + i].z, inTheAir[i].z);
    }
    values.set(table().lighting, IceCreamLighting::reference);
    test::setReferenceShape(table(), values);
    return values;
}

glsl::IceCream solidsOf(const IceCreamShape& shape)
{
    glsl::IceCream made;
    copyShape(made.shape, shape);
    return made;
}

/// Returns shapes with random parameters, parts and stages, without sprinkles. The first one is the reference's.
IceCreamShape randomShape(RandomNumbers& numbers, int i)
{
    if (i == 0) return iceCreamShape(table(), source(), 0);
    ParameterValues values = randomValues(table(), numbers, i % 2 == 0 ? 1 : 0.15);
    values.set(table().sprinkles, 0);
    values.set(table().animate, true);
    if (i % 3 != 0) values.set(table().stage, IceCreamStage::finished);
    if (i % 5 != 0) values.set(table().show, IceCreamParts::all);
    return iceCreamShape(table(), values, numbers.number(0, 100));
}

/// Returns a random point in the box enlarged by a half, or near a surface found from there.
dvec3 pointNear(const EverySolid& every, const render::Box& box, RandomNumbers& numbers)
{
    dvec3 p = numbers.point(box.center() - 1.5 * box.halfSize(), box.center() + 1.5 * box.halfSize());
    const dvec3 direction = glm::normalize(box.center() + box.halfSize() * numbers.point({-1, -1, -1}, {1, 1, 1}) - p);
    const int steps = numbers.index(40);
    for (int i = 0; i < steps; ++i) {
        const dvec3 next = p + direction * (0.5 * every.level(p));
        if (glm::length(next - box.center()) > 4 * glm::length(box.halfSize())) break;  // It has left the shape.
        p = next;
    }
    return p;
}

TEST(LongSolids, TheFewThatAreEvaluatedGiveWhatAllOfThemGive)
{
    RandomNumbers numbers(11);
    double largest = 0;
    std::int64_t asked = 0, all = 0;
    for (int i = 0; i < 120; ++i) {
        const IceCreamShape shape = randomShape(numbers, i);
        const EverySolid every(shape);
        glsl::IceCream few = solidsOf(shape);
        const render::Box box = boxOf(shape);
        for (int k = 0; k < 400; ++k) {
            const dvec3 p = pointNear(every, box, numbers);
            const double expected = every.level(p);
            if (expected > 1e8) continue;  // Nothing is shown.
            const double difference = std::abs(few.iceCreamLevel(p) - expected);
            EXPECT_LT(difference, 1e-9) << "shape " << i << " at " << p.x << ' ' << p.y << ' ' << p.z;
            largest = std::max(largest, difference);
            all += every.solids();
        }
        asked += few.solids;
    }
    EXPECT_LT(asked * 4, all);
    std::printf("largest difference %.1e, %.1f solids instead of %.1f\n", largest, double(asked) / 48000,
                double(all) / 48000);
}

/// If a lower bound equals an upper one, rounding must not skip the solid that both belong to.
TEST(Solids, AtFloat32NoneIsLostToRounding)
{
    RandomNumbers numbers(15);
    for (int stage = 0; stage <= static_cast<int>(IceCreamStage::finished); ++stage) {
        ParameterValues values = source();
        values.set(table().stage, static_cast<IceCreamStage>(stage));
        const IceCreamShape shape = iceCreamShape(table(), values, 0);
        const EverySolid every(shape);
        glsl32::IceCream rounded;
        copyShape(rounded.shape, shape);
        for (int k = 0; k < 4000; ++k) {
            // Many points are straight above and below the wafer.
            const double spread = k % 2 == 0 ? 0.2 : 1;
            const glm::vec3 p(numbers.point({-spread, -1, -spread}, {spread, 2, spread}));
            EXPECT_NEAR(rounded.iceCreamLevel(p), every.level(dvec3(p)), 1e-5) << "stage " << stage;
        }
    }
}

/// Control: one cone of each layer instead of two must be detected.
TEST(Solids, OneConeInsteadOfTwoWouldBeSeen)
{
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    IceCreamShape one = shape;
    for (CreamLayer& layer : one.layers) layer.blend = 0;
    RandomNumbers numbers(12);
    const EverySolid every(shape);
    glsl::IceCream few = solidsOf(one);
    int wrong = 0;
    for (int k = 0; k < 2000; ++k) {
        const dvec3 p = pointNear(every, boxOf(shape), numbers);
        wrong += std::abs(few.iceCreamLevel(p) - every.level(p)) > 1e-9;
    }
    EXPECT_GT(wrong, 20);
}

/// Returns the number of steps from random points that end beyond a surface.
int overshoots(const std::function<double(glsl::IceCream&, const dvec3&)>& step)
{
    RandomNumbers numbers(13);
    int beyond = 0;
    for (int i = 0; i < 150; ++i) {
        const IceCreamShape shape = randomShape(numbers, i);
        const EverySolid every(shape);
        glsl::IceCream few = solidsOf(shape);
        const render::Box box = boxOf(shape);
        for (int k = 0; k < 120; ++k) {
            const dvec3 p = pointNear(every, box, numbers);
            const double level = every.level(p);
            const double d = step(few, p);
            if (level > 1e8 || std::abs(level) < 1e-12) continue;  // There is nothing, or p is on the surface.
            EXPECT_EQ(d > 0, level > 0) << level << ' ' << d;
            for (int ray = 0; ray < 12; ++ray) {
                const dvec3 q = p + numbers.direction() * (0.999 * std::abs(d));
                beyond += level > 0 ? every.level(q) < 0 : every.level(q) > 0;
            }
        }
    }
    return beyond;
}

TEST(LongSolids, NoStepPassesASurfaceHoweverTheCreamIsTwisted)
{
    EXPECT_EQ(overshoots([](glsl::IceCream& solids, const dvec3& p) { return solids.iceCreamDistance(p); }), 0);
}

TEST(LongSolids, TheTwistedLevelItselfWouldPassSurfaces)
{
    EXPECT_GT(overshoots([](glsl::IceCream& solids, const dvec3& p) { return solids.iceCreamLevel(p); }), 20);
}

TEST(Solids, LieInTheirBox)
{
    RandomNumbers numbers(14);
    for (int i = 0; i < 200; ++i) {
        const IceCreamShape shape = randomShape(numbers, i);
        const EverySolid every(shape);
        const render::Box box = boxOf(shape);
        for (int k = 0; k < 200; ++k) {
            // On a face of the box, and a little beyond it.
            dvec3 p = numbers.point(box.low, box.high);
            const int axis = numbers.index(3);
            p[axis] = numbers.chance(0.5) ? box.low[axis] - 1e-4 : box.high[axis] + 1e-4;
            EXPECT_GT(every.level(p), 0) << "shape " << i;
        }
    }
}

// ---- Marches -------------------------------------------------------------------------------------

/// Returns the rays of the reference's first view.
dvec3 sourceRay(int x, int y, int width, int height)
{
    const dvec3 forward = glm::normalize(dvec3(0, 0.5, 0) - dvec3(0, 1.5, 2));
    const dvec3 right(1, 0, 0), up = glm::cross(right, forward);
    return glm::normalize(forward + right * ((x + 0.5 - 0.5 * width) / height) +
                          up * ((0.5 * height - y - 0.5) / height));
}

TEST(LongIceCreamMarch, ARayThatIsOutOfStepsIsNoHit)
{
    constexpr int width = 98, height = 55;
    constexpr double halfPixel = 0.5 / 441;  // In the reference's window.
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    const EverySolid every(shape);
    const render::Box box = boxOf(shape);
    glsl::IceCream solids = solidsOf(shape);
    glsl::Tracer tracer{[&](const dvec3& p) { return solids.iceCreamDistance(p); }};
    int phantoms = 0, missed = 0, ofTheReference = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const dvec3 eye(0, 1.5, 2), ray = sourceRay(x, y, width, height);
            // Closest distances to the ice cream, in pixels, and to the ground, found by short steps.
            double nearest = 1e9;
            for (double t = 0.5; t < 4.5; t += 0.006)
                nearest = std::min(nearest, every.level(eye + ray * t) / (2 * halfPixel * t));
            if (nearest < 2) continue;
            ++missed;
            const auto span = glsl::rayBox(eye, ray, box.low, box.high);
            for (const int steps : {2, 4, 8, 16, 64, 128}) {
                auto settings = tracer.marchSettings(span.x, span.y, halfPixel);
                settings.stepLimit = steps;
                phantoms += tracer.sphereTrace(eye, ray, settings).hit;
            }
            // Method of the reference: 128 steps with the ground included. A ray that has not gone far counts as a hit.
            double t = 1;
            bool hit = false;
            for (int i = 0; i < 128 && t < 1e8 && !hit; ++i) {
                const dvec3 p = eye + ray * t;
                const double d = std::min(every.level(p), p.y);
                hit = d < 1e-5 * t;
                if (!hit) t += d;
            }
            ofTheReference += !hit && t < 1e8;
        }
    EXPECT_GT(missed, 2000);
    EXPECT_EQ(phantoms, 0);
    EXPECT_GT(ofTheReference, 20) << "rays near the horizon run out of steps, and the reference takes them for hits";
}

TEST(IceCreamMarch, NormalsAtFloat32AreThoseOfFloat64ByTheStepOfTheTable)
{
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    glsl::IceCream exact = solidsOf(shape);
    glsl32::IceCream rounded;
    copyShape(rounded.shape, shape);
    glsl::Tracer march{[&](const dvec3& p) { return exact.iceCreamDistance(p); }};
    glsl::Tracer truth{[&](const dvec3& p) { return exact.iceCreamLevel(p); }};
    glsl32::Tracer tracer{[&](const glm::vec3& p) { return rounded.iceCreamLevel(p); }};
    const auto errors = [&](double step) {
        std::vector<double> degrees;
        for (int y = 0; y < 110; ++y)
            for (int x = 0; x < 196; ++x) {
                const dvec3 ray = sourceRay(x, y, 196, 110);
                const auto hit = march.sphereTrace({0, 1.5, 2}, ray, march.marchSettings(0.5, 5, 1e-7));
                if (!hit.hit) continue;
                const dvec3 p(glm::vec3(dvec3(0, 1.5, 2) + ray * hit.t));
                const dvec3 n = truth.fieldNormal(p, 1e-6, truth.NORMAL_CENTRAL, -ray);
                const dvec3 found(
                    tracer.fieldNormal(glm::vec3(p), static_cast<float>(step), tracer.NORMAL_CENTRAL, glm::vec3(-ray)));
                degrees.push_back(std::atan2(glm::length(glm::cross(n, found)), glm::dot(n, found)) * 180 /
                                  std::numbers::pi);
            }
        std::sort(degrees.begin(), degrees.end());
        return degrees;
    };
    const auto ours = errors(table().initial()[table().normalStep]);
    EXPECT_GT(ours.size(), 1500U);
    // The rest are pixels within a step of a crease, where both sides count.
    EXPECT_LT(ours[ours.size() * 95 / 100], 0.1);
    const auto sources = errors(1e-5);
    EXPECT_GT(sources[sources.size() / 2], 5 * ours[ours.size() / 2]) << "the reference's step drowns in rounding";
    EXPECT_GT(sources[sources.size() * 95 / 100], 5 * ours[ours.size() * 95 / 100]);
    std::printf("median, 95 %%: %.4f %.4f; the reference's step: %.3f %.3f degrees\n", ours[ours.size() / 2],
                ours[ours.size() * 95 / 100], sources[sources.size() / 2], sources[sources.size() * 95 / 100]);
}

// ---- Dimensions of the reference -----------------------------------------------------------------

/// Returns the first intersection of a straight line from outside with some of the parts.
double firstMet(int parts, const dvec3& from, const dvec3& direction)
{
    IceCreamShape shape = iceCreamShape(table(), source(), 0);
    shape.parts = parts;
    glsl::IceCream solids = solidsOf(shape);
    double t = 0;
    for (int i = 0; i < 20000 && t < 100; ++i) {
        const double d = solids.iceCreamDistance(from + direction * t);
        if (d < 1e-9) return t;
        t += d;
    }
    return -1;
}

/// Returns the radius of parts at a height, seen from an angle.
double radiusAt(int parts, double y, double angle = 0)
{
    const dvec3 out(std::cos(angle), 0, std::sin(angle));
    return 2 - firstMet(parts, out * 2.0 + dvec3(0, y, 0), -out);
}

TEST(IceCreamDimensions, OfTheWaferAreTheReferences)
{
    constexpr int foot = 1 << PART_FOOT, collar = 1 << PART_COLLAR, bowl = 1 << PART_BOWL;
    EXPECT_NEAR(radiusAt(foot, 1e-6), 0.20, 1e-5);
    EXPECT_NEAR(radiusAt(foot, 0.23), 0.225, 1e-5);
    EXPECT_NEAR(radiusAt(foot, 0.46 - 1e-6), 0.25, 1e-5);
    EXPECT_NEAR(firstMet(foot, {0, 2, 0}, {0, -1, 0}), 2 - 0.46, 1e-6);
    EXPECT_NEAR(firstMet(foot, {0, -2, 0}, {0, 1, 0}), 2, 1e-6);
    EXPECT_NEAR(radiusAt(collar, 0.46 + 1e-6), 0.2675, 1e-4);
    EXPECT_NEAR(radiusAt(collar, 0.50 - 1e-6), 0.2375, 1e-4);
    EXPECT_NEAR(firstMet(collar, {0, 2, 0}, {0, -1, 0}), 1.5, 1e-6);
    EXPECT_NEAR(firstMet(collar, {0, -2, 0}, {0, 1, 0}), 2.46, 1e-6);
    EXPECT_NEAR(radiusAt(bowl, 0.50 + 1e-6), 0.2535, 1e-4);
    EXPECT_NEAR(radiusAt(bowl, 0.6575 - 1e-4), 0.32175, 1e-4);
    EXPECT_NEAR(firstMet(bowl, {0, 2, 0}, {0, -1, 0}), 2 - 0.6575, 1e-4);
    for (const double y : {0.52, 0.56, 0.63})
        EXPECT_NEAR(radiusAt(bowl, y), std::sqrt(0.325 * 0.325 - (y - 0.7034) * (y - 0.7034)), 1e-4) << y;
}

/// Returns the number of local maxima above the mean, of a function on a circle or an interval.
int hills(const std::function<double(double)>& f, double from, double to, bool closed)
{
    constexpr int count = 3600;
    std::vector<double> at;
    double mean = 0;
    for (int i = 0; i < count; ++i) {
        at.push_back(f(from + (to - from) * i / count));
        mean += at.back() / count;
    }
    int found = 0;
    bool above = closed ? at.back() > mean : false;
    for (const double value : at) {
        found += value > mean && !above;
        above = value > mean;
    }
    return found;
}

TEST(IceCreamDimensions, ThreeRingsAndSevenBarsCrossTheFoot)
{
    constexpr int rings = 1 << PART_RINGS, bars = 1 << PART_BARS;
    for (const double y : {0.115, 0.23, 0.345}) EXPECT_NEAR(radiusAt(rings, y), 0.2 + 0.05 * y / 0.46 + 0.0075, 1e-6);
    EXPECT_GT(radiusAt(rings, 0.115 + 0.0076), 2) << "the tube is .0075 thick";
    EXPECT_NEAR(radiusAt(bars, 0.23), 0.225 + 0.01 * std::hypot(0.05, 0.46) / 0.46, 1e-6);
    const double turn = 2 * std::numbers::pi;
    const auto around = [](double y) { return [y](double a) { return radiusAt(31, y, a); }; };
    EXPECT_EQ(hills(around(0.17), 0, turn, true), 7);
    EXPECT_EQ(hills([](double y) { return radiusAt(31, y, 0.45) - (0.2 + 0.05 * y / 0.46); }, 0.02, 0.44, false), 3);
    // The same for other counts.
    ParameterValues other = source();
    other.set(table().bars, 12);
    other.set(table().rings, 5);
    const EverySolid every(iceCreamShape(table(), other, 0));
    EXPECT_EQ(hills(
                  [&](double a) {
                      return -every.wafer({0.223 * std::cos(a), 0.14, 0.223 * std::sin(a)});
                  },
                  0, turn, true),
              12);
}

TEST(IceCreamDimensions, TheLayersHaveSevenAndFiveLobes)
{
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    const EverySolid every(shape);
    const double turn = 2 * std::numbers::pi;
    for (const auto& [layer, y, r, lobes] : {std::tuple{0, 0.80, 0.36, 7}, std::tuple{1, 1.0, 0.2, 5}}) {
        const auto level = [&, layer = layer, y = y, r = r](double a) {
            return -every.layer(layer, {r * std::cos(a), y, r * std::sin(a)});
        };
        EXPECT_EQ(hills(level, 0, turn, true), lobes);
        // Rotating by one lobe changes nothing: the layer has the symmetry of its count.
        for (const double a : {0.1, 0.9, 2.2}) EXPECT_NEAR(level(a), level(a + turn / lobes), 1e-7);
        // Nor does rising while rotating by the twist: 5 and 6 radians per meter.
        EXPECT_FLOAT_EQ(shape.layers[static_cast<std::size_t>(layer)].twist, layer == 0 ? 5 : 6);
    }
}

TEST(IceCreamDimensions, TheConesLeanAndTwistAsInTheReference)
{
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    // Computed by hand from the reference's matrices: base and tip, before repetition and twist.
    const dvec3 lowerBase(0.1, 0.6875, 0.3), upperBase(-0.1561, 0.8536, 0.0839);
    const auto tipOf = [](double tilt, double yaw, double length) {
        return length * dvec3(std::sin(yaw) * std::sin(tilt), std::cos(tilt), std::cos(yaw) * std::sin(tilt));
    };
    const dvec3 bases[]{lowerBase, upperBase};
    const dvec3 tips[]{lowerBase + tipOf(-1, std::numbers::pi / 10, 0.34),
                       upperBase + tipOf(-0.33, -std::numbers::pi / 3, 0.54)};
    for (std::size_t i = 0; i < 2; ++i) {
        const CreamLayer& layer = shape.layers[i];
        const double a = double{layer.twist};
        // In twisted space: the position to which the untwisted point is rotated back.
        for (const auto& [q, expected] : {std::pair{bases[i], -0.03}, std::pair{tips[i], -0.03}}) {
            const double turned = a * q.y;
            const dvec3 p(std::cos(turned) * q.x - std::sin(turned) * q.z, q.y,
                          std::sin(turned) * q.x + std::cos(turned) * q.z);
            EXPECT_NEAR(EverySolid::lobe(layer, p, 0), expected, 2e-4) << i;
        }
        EXPECT_FLOAT_EQ(layer.corner, 0.03F);
        EXPECT_NEAR(layer.radius + layer.corner, i == 0 ? 0.16 : 0.10, 1e-6);
        EXPECT_NEAR(2 * layer.halfHeight + 2 * layer.corner, i == 0 ? 0.40 : 0.60, 1e-6);
    }
    EXPECT_FLOAT_EQ(shape.layers[0].blend, 0.01F);
    EXPECT_FLOAT_EQ(shape.layerBlend, 0.05F);
    EXPECT_FLOAT_EQ(shape.waferBlend, 0.01F);
}

TEST(IceCreamDimensions, InitialCandiesLieOnTheInitialCream)
{
    const IceCreamShape shape = iceCreamShape(table(), table().initial(), 0);
    const EverySolid every(shape);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(every.cream(dvec3(shape.candies[i].center)), 0, 0.012) << "candy " << i + 1;
}

TEST(IceCreamDimensions, NoCandyIsLostBehindTheCamera)
{
    const IceCreamShape shape = iceCreamShape(table(), source(), 0);
    const EverySolid every(shape);
    for (std::size_t i = 0; i < candyCount; ++i) {
        const Candy& candy = shape.candies[i];
        EXPECT_LT(glm::length(glm::vec2(candy.center.x, candy.center.z)), 1.01) << "candy " << i + 1;
        EXPECT_EQ(candy.halfSize, glm::vec3(0.02F, 0.03F, 0.01F));
        EXPECT_FLOAT_EQ(candy.corner, 0.007F);
        // Candies on the cream stand out of it.
        const double depth = every.cream(dvec3(candy.center));
        EXPECT_GT(depth, -0.012) << "candy " << i + 1;
        if (i < 7) {
            EXPECT_LT(depth, 0.012) << "candy " << i + 1;
        }
    }
    // Positions in the reference of the first candy and of the fifth one, all of whose corners are in the cream.
    EXPECT_GT(glm::length(dvec2(0.12, 16)), 1.01);
    EXPECT_LT(every.cream({-0.06, 1.1, -0.11}), -0.036);
}

TEST(IceCreamDimensions, CandiesSpinAndFloatAsTheReferenceTellsThem)
{
    ParameterValues values = source();
    values.set(table().animate, true);
    EXPECT_NEAR(candySpin(40), 0.07 * 40 + 0.05 * std::sin(40.0), 1e-12);
    const double t = 33;
    const IceCreamShape still = iceCreamShape(table(), source(), t), moved = iceCreamShape(table(), values, t);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(still.candies[i].center, moved.candies[i].center);
        EXPECT_EQ(still.candies[i].axisX, moved.candies[i].axisX);
    }
    const double bobs[]{0.07 * std::sin(0.15 * t), 0.05 * std::cos(0.13 * t), 0.06 * std::sin(0.17 * t)};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(moved.candies[7 + i].center.y - still.candies[7 + i].center.y, bobs[i], 1e-6) << i;
        // Rotations about x, y and z: this axis of the candy stays.
        const glm::vec3 before[]{still.candies[7 + i].axisX, still.candies[7 + i].axisY,
                                 glm::cross(still.candies[7 + i].axisX, still.candies[7 + i].axisY)};
        const glm::vec3 after[]{moved.candies[7 + i].axisX, moved.candies[7 + i].axisY,
                                glm::cross(moved.candies[7 + i].axisX, moved.candies[7 + i].axisY)};
        EXPECT_LT(glm::distance(before[i], after[i]), 1e-5) << i;
        EXPECT_NEAR(glm::dot(before[(i + 1) % 3], after[(i + 1) % 3]), std::cos(candySpin(t)), 1e-5) << i;
    }
}

}  // namespace
}  // namespace vitrine::ice_cream
