// Shapes on the floor: occluded ambient light, and the occluded share of the mirrored lobe, compared with rays at
// float64.
#include "exhibits/hall/hall_furniture.h"
#include "render/glsl/cpu.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vitrine::hall {
namespace {

using std::numbers::pi;

glsl::StandingShape inGlsl(const StandingShape& shape)
{
    return {glm::dvec3(shape.center), shape.kind,
            glm::dvec2(shape.axis),   glm::dvec2(shape.halfSize),
            double{shape.halfHeight}, double{shape.strength},
            double{shape.reach},      glm::dvec3(shape.color)};
}

/// Returns whether a ray from a point of the floor hits the shape. Each kind uses its own equation.
bool meets(const StandingShape& shape, const glm::dvec3& from, const glm::dvec3& direction)
{
    const glm::dvec3 o = from - glm::dvec3(shape.center);
    const auto height = static_cast<double>(shape.halfHeight);
    const auto radius = static_cast<double>(shape.halfSize.x);
    if (shape.kind == STANDING_SPHERE) {
        const double along = -glm::dot(o, direction);
        return along > 0 && glm::dot(o, o) - along * along < radius * radius;
    }
    const double yNear = (-height - o.y) / direction.y;
    const double yFar = (height - o.y) / direction.y;
    double enters = std::max(std::min(yNear, yFar), 0.0);
    double leaves = std::max(yNear, yFar);
    if (shape.kind == STANDING_CYLINDER) {
        const double a = direction.x * direction.x + direction.z * direction.z;
        const double b = o.x * direction.x + o.z * direction.z;
        const double c = o.x * o.x + o.z * o.z - radius * radius;
        const double root = b * b - a * c;
        if (root <= 0) return false;
        enters = std::max(enters, (-b - std::sqrt(root)) / a);
        leaves = std::min(leaves, (-b + std::sqrt(root)) / a);
        return enters < leaves;
    }
    const glm::dvec2 axes[2] = {glm::dvec2(shape.axis), {-shape.axis.y, shape.axis.x}};
    for (int i = 0; i < 2; ++i) {
        const double at = axes[i].x * o.x + axes[i].y * o.z;
        const double along = axes[i].x * direction.x + axes[i].y * direction.z;
        const double half = shape.halfSize[i];
        enters = std::max(enters, std::min((-half - at) / along, (half - at) / along));
        leaves = std::min(leaves, std::max((-half - at) / along, (half - at) / along));
    }
    return enters < leaves;
}

/// Returns the share of a uniform sky that the shape occludes: cosine-weighted directions on a grid.
double hiddenShare(const StandingShape& shape, const glm::dvec2& place)
{
    constexpr int rings = 400;
    constexpr int around = 800;
    int hidden = 0;
    for (int i = 0; i < rings; ++i) {
        const double sine = std::sqrt((i + 0.5) / rings);
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * (k + 0.37) / around;
            hidden += meets(shape, {place.x, 0, place.y},
                            {sine * std::cos(angle), std::sqrt(1 - sine * sine), sine * std::sin(angle)});
        }
    }
    return static_cast<double>(hidden) / (rings * around);
}

StandingShape named(int kind, const glm::dvec3& low, const glm::dvec3& high, double turn)
{
    StandingShape shape = standingBox({low, high}, glm::dvec3(0.5));
    if (kind != STANDING_BOX) shape = standingCylinder({low, high}, glm::dvec3(0.5));
    shape.kind = kind;
    shape.axis = {std::cos(turn), std::sin(turn)};
    return shape;
}

/// Returns a plinth over its recess, the foot of the card's stand, a bench's seat, and a lying body.
std::vector<StandingShape> examples()
{
    return {named(STANDING_BOX, {-0.4, 0.0, -0.4}, {0.4, 0.9, 0.4}, 0.3),
            named(STANDING_CYLINDER, {-0.21, 0, -0.21}, {0.21, 0.024, 0.21}, 0),
            named(STANDING_BOX, {-0.23, 0.405, -0.9}, {0.23, 0.45, 0.9}, 1.2),
            named(STANDING_SPHERE, {-0.3, 0, -0.3}, {0.3, 0.6, 0.3}, 0)};
}

/// Returns five places on the floor, from the outline to half a meter in front of it.
std::vector<glm::dvec2> probes(const StandingShape& shape)
{
    std::vector<glm::dvec2> places;
    for (const double beside : {0.02, 0.05, 0.1, 0.2, 0.5}) {
        const glm::dvec2 way(std::cos(7 * beside), std::sin(7 * beside));
        double far = 0.01;
        while (glsl::outlineDistance(inGlsl(shape), way * far) < beside) far += 1e-3;
        places.push_back(way * far);
    }
    return places;
}

TEST(Standing, TakesTheLightOfAnEvenSkyThatRaysSayItTakes)
{
    for (const StandingShape& shape : examples())
        for (const glm::dvec2& place : probes(shape)) {
            const double truth = hiddenShare(shape, place);
            EXPECT_NEAR(glsl::standingFormFactor(inGlsl(shape), place), truth, 0.03 * truth + 1e-3)
                << shape.kind << " at " << place.x << ' ' << place.y;
        }
    // Below the seat, where no side is visible.
    const StandingShape seat = examples()[2];
    EXPECT_NEAR(glsl::standingFormFactor(inGlsl(seat), {0.1, 0.2}), hiddenShare(seat, {0.1, 0.2}), 0.02);
    EXPECT_GT(glsl::standingFormFactor(inGlsl(examples()[0]), probes(examples()[0])[0]), 0.35);
}

TEST(Standing, ThrowsNoShadowBeyondItsReachAndNoneWithoutStrength)
{
    for (const StandingShape& shape : examples()) {
        glsl::StandingShape s = inGlsl(shape);
        s.reach = 0.2;
        EXPECT_EQ(glsl::contactShadow(s, probes(shape)[4]), 0);
        EXPECT_GT(glsl::contactShadow(s, probes(shape)[0]), 0);
        EXPECT_NEAR(glsl::contactShadow(s, probes(shape)[0]), glsl::standingFormFactor(s, probes(shape)[0]), 1e-12);
        s.strength = 0;
        EXPECT_EQ(glsl::contactShadow(s, probes(shape)[0]), 0);
    }
}

TEST(Standing, IsNoDarkerBelowThanAtItsEdge)
{
    // Filtering the map mixes both.
    for (const StandingShape& shape : {examples()[0], examples()[1]}) {
        const glsl::StandingShape s = inGlsl(shape);
        EXPECT_NEAR(glsl::standingFormFactor(s, {0.01, 0.02}), 1, 0.05);
        for (const double part : {0.0, 0.3, 0.9}) {
            const glm::dvec2 within(part * s.halfSize.x * 0.7, 0.01);
            EXPECT_GE(glsl::outlineDistance(s, glsl::besideOutline(s, within)), 0);
            EXPECT_LT(glsl::contactShadow(s, within), 0.52);
            EXPECT_GT(glsl::contactShadow(s, within), 0.35);
        }
    }
}

/// Returns the share of GGX facets (Walter et al. 2007, with the cosine of the normal) whose reflection hits the shape.
double metByFacets(const StandingShape& shape, const glm::dvec3& from, const glm::dvec3& mirrored, double alpha)
{
    constexpr int rings = 600;
    constexpr int around = 256;
    const glm::dvec3 toEye(-mirrored.x, mirrored.y, -mirrored.z);
    int met = 0;
    for (int i = 0; i < rings; ++i) {
        const double u = (i + 0.5) / rings;
        const double slope = alpha * std::sqrt(u / (1 - u));
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * (k + 0.37) / around;
            const glm::dvec3 facet = glm::normalize(glm::dvec3(-slope * std::cos(angle), 1, -slope * std::sin(angle)));
            glm::dvec3 way = glm::reflect(-toEye, facet);
            if (way.y < 1e-6) way.y = 1e-6;
            met += meets(shape, from, way);
        }
    }
    return static_cast<double>(met) / (rings * around);
}

TEST(LongStanding, MeetsTheShareOfAMirroredLobeThatFacetsSay)
{
    constexpr double alpha = 0.17 * 0.17;
    const StandingShape plinth = examples()[0];
    const StandingShape post = named(STANDING_CYLINDER, {-0.02, 0.03, -0.02}, {0.02, 0.9, 0.02}, 0);
    double most = 0;
    for (const StandingShape& shape : {plinth, post})
        for (const double ahead : {0.7, 2.0})
            for (const double aside : {-0.7, -0.4, 0.0, 0.02, 0.3, 0.55})
                for (const double rise : {0.15, 0.35, 0.6}) {
                    const glm::dvec3 from(aside, 0, ahead);
                    const glm::dvec3 mirrored = glm::normalize(glm::dvec3(0, rise, -1));
                    const glsl::MirrorLobe lobe{{from.x, from.z}, {0, -1}, rise, 2 * alpha};
                    const double found = glsl::mirroredShape(inGlsl(shape), lobe).share;
                    const double truth = metByFacets(shape, from, mirrored, alpha);
                    most = std::max(most, truth);
                    EXPECT_NEAR(found, truth, 0.08) << shape.kind << ' ' << ahead << ' ' << aside << ' ' << rise;
                }
    EXPECT_GT(most, 0.9);
}

TEST(Standing, LobesAreCutByAnEdgeAsTheirFacetsAre)
{
    // The share of GGX slopes below x, integrated over the plane of slopes.
    for (const double x : {-2.0, -0.5, 0.0, 0.3, 1.5}) {
        double below = 0;
        constexpr int n = 4000;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < 64; ++k) {
                const double u = (i + 0.5) / n;
                below += std::sqrt(u / (1 - u)) * std::cos(2 * pi * (k + 0.37) / 64) < x;
            }
        EXPECT_NEAR(glsl::lobeShare(x, 1), below / (n * 64.0), 4e-3) << x;
    }
}

TEST(Furniture, IsMadeOfThePiecesThatStandWhereCollidersAre)
{
    const Furniture& furniture = test::building().furniture();
    const auto at = [&](double x, double z, double y) {
        return std::any_of(furniture.shapes.begin(), furniture.shapes.end(), [&](const StandingShape& shape) {
            const render::Box box = boundsOf(shape);
            return box.contains({x, y, z});
        });
    };
    EXPECT_TRUE(at(0, 0, 0.5));        // the plinth in the middle
    EXPECT_TRUE(at(3, -3.4, 0.5));     // the free one
    EXPECT_TRUE(at(0.72, 0.62, 0.5));  // the post of a button
    EXPECT_TRUE(at(2.6, -5, 0.43));    // the seat of a bench, all its boards one
    EXPECT_FALSE(at(2.5, -5, 0.2));    // between its legs
    EXPECT_FALSE(at(0, 5, 0.01));      // the bare floor
    const auto seats = std::count_if(furniture.shapes.begin(), furniture.shapes.end(), [](const StandingShape& shape) {
        return std::abs(shape.center.y - 0.4275F) < 1e-3F && std::max(shape.halfSize.x, shape.halfSize.y) > 0.85F;
    });
    EXPECT_EQ(seats, 3);
    // Bars of the window as in hall_fittings.py.
    ASSERT_EQ(furniture.bars.upright.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        double nearest = 1;
        for (const glm::dvec2& bar : furniture.bars.upright)
            nearest = std::min(nearest, std::abs(bar.x - 0.6 * (static_cast<double>(i) - 1)));
        EXPECT_LT(nearest, 1e-3);
    }
    EXPECT_EQ(furniture.bars.level.size(), 6U);
    EXPECT_NEAR(furniture.bars.z, -12.56, 0.01);
}

TEST(Furniture, OfAStandIsAFlatFootAndASlenderPost)
{
    const std::vector<StandingShape>& stand = test::building().place(2)->standShapes;
    const auto foot = std::find_if(stand.begin(), stand.end(), [](const StandingShape& shape) {
        return shape.kind == STANDING_CYLINDER && shape.halfSize.x > 0.2F;
    });
    ASSERT_NE(foot, stand.end());
    EXPECT_LT(2 * foot->halfHeight, 0.03F);
    EXPECT_EQ(foot->strength, 1);
    EXPECT_TRUE(std::any_of(stand.begin(), stand.end(), [](const StandingShape& shape) {
        return shape.kind == STANDING_CYLINDER && shape.halfSize.x < 0.03F && 2 * shape.halfHeight > 0.95;
    }));
}

}  // namespace
}  // namespace vitrine::hall
