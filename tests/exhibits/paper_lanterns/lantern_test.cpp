// A lantern: its dimensions, its paper, its flame.

#include "tests/exhibits/paper_lanterns/lake_at_float64.h"
#include "tests/exhibits/paper_lanterns/traced_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vitrine::paper_lanterns {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;
using namespace test;

double boxDistance(const dvec3& p, const dvec3& halfSize)
{
    const dvec3 q = glm::abs(p) - halfSize;
    return glm::length(glm::max(q, dvec3(0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

double cappedCylinder(const dvec3& p, double halfHeight, double radius)
{
    const dvec2 q(glm::length(dvec2(p.x, p.z)) - radius, std::abs(p.y) - halfHeight);
    return std::min(std::max(q.x, q.y), 0.0) + glm::length(glm::max(q, dvec2(0)));
}

/// The reference's three parts, with y up from the center of the base.
struct SourcesParts {
    double paper, wood, metal;
};

SourcesParts sourcesParts(const dvec3& p)
{
    SourcesParts parts{};
    const double shell = std::abs(cappedCylinder(p - dvec3(0, 1.5, 0), 1.5, 0.75)) - 0.03;
    parts.paper = std::max(shell, -boxDistance(p - dvec3(0, 4, 0), dvec3(2)));
    parts.wood = boxDistance(p, dvec3(1.1, 0.04, 1.1));
    const auto torus = [&](double y) {
        return glm::length(dvec2(glm::length(dvec2(p.x, p.z)) - 0.75, p.y - y)) - 0.05;
    };
    const dvec3 post(std::abs(p.x) - 0.75 * 0.707, p.y - 1, std::abs(p.z) - 0.75 * 0.707);
    const double rings = std::min(torus(0.08), torus(2.0));
    const double posts = cappedCylinder(post, 1.03, 0.05);
    const double h = std::clamp(0.5 + 0.5 * (rings - posts) / 0.1, 0.0, 1.0);
    parts.metal = rings * (1 - h) + posts * h - 0.1 * h * (1 - h);
    return parts;
}

/// Returns the number of random places, more than a millimeter from the surface, at which the solid differs from the
/// reference's.
int placesUnlikeTheReferences(glsl::Lake lake)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> side(-1.3, 1.3), up(-0.2, 2.3);
    int unlike = 0;
    for (int i = 0; i < 200000; ++i) {
        const dvec3 p(side(random), up(random), side(random));
        const SourcesParts parts = sourcesParts(p);
        const double nearest = std::min({parts.paper, parts.wood, parts.metal});
        if (std::abs(nearest) > 1e-3) unlike += (nearest < 0) != (lake.lanternField(p).distance < 0);
    }
    return unlike;
}

TEST(LanternShape, IsTheReferences)
{
    const glsl::Lake lake = lakeAtFloat64(lanternsTable().initial(), 0);
    EXPECT_EQ(placesUnlikeTheReferences(lake), 0);
    ParameterValues wider = lanternsTable().initial();
    wider.set(lanternsTable().paperRadius, 0.76);
    EXPECT_GT(placesUnlikeTheReferences(lakeAtFloat64(wider, 0)), 10);
}

/// Returns the distance to the change of the field's sign along a ray, by bisection.
double surfaceAlong(glsl::Lake& lake, const dvec3& from, const dvec3& direction)
{
    double t = 0;
    for (int i = 0; i < 400; ++i) t += lake.lanternField(from + direction * t).distance;
    return t;
}

TEST(LanternShape, HasTheDecodedDimensions)
{
    glsl::Lake lake = lakeAtFloat64(lanternsTable().initial(), 0);
    // Between two posts, outside and inside of the paper, which is 3 cm to each side of 75.
    const dvec3 across(1, 0, 0);
    EXPECT_NEAR(surfaceAlong(lake, {3, 1, 0}, -across), 3 - 0.78, 1e-6);
    EXPECT_NEAR(surfaceAlong(lake, {0, 1, 0}, across), 0.72, 1e-6);
    // The base, a ring from above, a post from outside along the diagonal.
    EXPECT_NEAR(surfaceAlong(lake, {1, 3, 1}, {0, -1, 0}), 3 - 0.04, 1e-6);
    EXPECT_NEAR(surfaceAlong(lake, {3, 0, 0}, -across), 3 - 1.1, 1e-6);
    EXPECT_NEAR(surfaceAlong(lake, {0.75, 3, 0}, {0, -1, 0}), 3 - 2.05, 1e-3);
    const dvec3 diagonal = glm::normalize(dvec3(1, 0, 1));
    EXPECT_NEAR(surfaceAlong(lake, 3.0 * diagonal + dvec3(0, 1, 0), -diagonal),
                3 - (0.75 * 0.707 * std::sqrt(2) + 0.05), 1e-3);
}

TEST(LanternShape, TellsTheNearestPartWithTheDistance)
{
    glsl::Lake lake = lakeAtFloat64(lanternsTable().initial(), 0);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> side(-1.3, 1.3), up(0.05, 1.9);
    int seen[4] = {};
    for (int i = 0; i < 20000; ++i) {
        const dvec3 p(side(random), up(random), side(random));
        const SourcesParts parts = sourcesParts(p);
        const auto found = lake.lanternField(p);
        ++seen[found.part];
        // The reference takes the nearest of the three. Rounded edges of the paper are left out.
        const double least = std::min({parts.paper, parts.wood, parts.metal});
        const double second =
            parts.paper + parts.wood + parts.metal - least - std::max({parts.paper, parts.wood, parts.metal});
        if (second - least < 0.05) continue;
        const int part = least == parts.paper ? PART_PAPER : least == parts.wood ? PART_WOOD : PART_METAL;
        EXPECT_EQ(found.part, part) << p.x << ' ' << p.y << ' ' << p.z;
    }
    EXPECT_GT(std::min({seen[PART_PAPER], seen[PART_WOOD], seen[PART_METAL]}), 500);
    // One evaluation of the field, where the reference evaluates again for each part.
    EXPECT_EQ(lake.evaluations, 20000);
    // Control: a wider tube has paper where the reference has none.
    ParameterValues wider = lanternsTable().initial();
    wider.set(lanternsTable().paperRadius, 0.9);
    glsl::Lake other = lakeAtFloat64(wider, 0);
    EXPECT_EQ(lake.lanternField({0.6, 1.0, 0.6}).part, PART_METAL);
    EXPECT_EQ(other.lanternField({0.9, 1.0, 0.1}).part, PART_PAPER);
    EXPECT_LT(other.lanternField({0.9, 1.0, 0.1}).distance, 0);
    EXPECT_GT(lake.lanternField({0.9, 1.0, 0.1}).distance, 0.1);
}

TEST(LanternShape, NeverOverestimates)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-2, 2), small(-0.1, 0.1);
    glsl::Lake lake = lakeAtFloat64(lanternsTable().initial(), 0);
    for (int i = 0; i < 100000; ++i) {
        const dvec3 a(side(random), 1 + side(random), side(random));
        const dvec3 b = a + dvec3(small(random), small(random), small(random));
        EXPECT_LE(std::abs(lake.lanternField(a).distance - lake.lanternField(b).distance),
                  glm::length(a - b) * (1 + 1e-9));
    }
}

TEST(Flame, FlickersBetweenTheReferencesNumbers)
{
    double low = 1, high = 0;
    for (int i = 0; i < 40000; ++i) {
        const double now = lakeAtFloat64(lanternsTable().initial(), 0).flickerOf(i / 40000.0);
        low = std::min(low, now);
        high = std::max(high, now);
        if (i % 400 == 0) {
            const double t = 4.0 * i / 40000.0;
            const double f = 0.15 * (std::cos(2 * pi * t) + 2) + 0.1 * (std::cos(3 * pi * t) + 1) +
                             0.1 * (std::cos(2.5 * pi * t) + 1);
            EXPECT_NEAR(now, 0.3 + 0.5 * f, 1e-6);
        }
    }
    EXPECT_NEAR(low, 0.399, 0.001);
    EXPECT_NEAR(high, 0.725, 0.001);
}

/// Returns the correlation of the brightness of two lanterns of the lattice over four seconds.
double correlation(const ParameterValues& values, int a, int b)
{
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    constexpr int count = 200;
    for (int i = 0; i < count; ++i) {
        glsl::Lake lake = lakeAtFloat64(values, 4.0 * i / count);
        const double x = lake.lanternOfCell({a, 3}).light, y = lake.lanternOfCell({b, 5}).light;
        sa += x;
        sb += y;
        saa += x * x;
        sbb += y * y;
        sab += x * y;
    }
    return (sab - sa * sb / count) / std::sqrt((saa - sa * sa / count) * (sbb - sb * sb / count));
}

TEST(Flame, HasAPhaseOfItsOwn)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().drift, 0.0);
    double sum = 0;
    for (int i = 0; i < 40; ++i) sum += correlation(values, i, i + 7) / 40;
    EXPECT_LT(std::abs(sum), 0.2);
    values.set(lanternsTable().flickerPhase, LakeFlicker::together);
    EXPECT_GT(correlation(values, 0, 7), 0.999);
}

TEST(Paper, KeepsAllLightThatItDoesNotAbsorb)
{
    for (const double scatter : {0.0, 1e-8, 0.01, 0.5, 1.6, 20.0, 1000.0})
        for (const double absorb : {0.0, 1e-9, 0.01, 0.3, 5.0, 400.0}) {
            const auto sheet = glsl::sheetOf(scatter, absorb);
            EXPECT_GE(sheet.reflected, 0);
            EXPECT_GE(sheet.transmitted, 0);
            EXPECT_LE(sheet.reflected + sheet.transmitted, 1 + 1e-9) << scatter << ' ' << absorb;
            if (absorb == 0) {
                EXPECT_NEAR(sheet.reflected + sheet.transmitted, 1, 1e-9) << scatter;
                EXPECT_NEAR(sheet.transmitted, 1 / (1 + scatter), 1e-9) << scatter;
            }
            // Two sheets act like one of twice the thickness: light is reflected back and forth between them.
            const auto both = glsl::sheetOf(2 * scatter, 2 * absorb);
            const double between = 1 / (1 - sheet.reflected * sheet.reflected);
            EXPECT_NEAR(both.transmitted, sheet.transmitted * sheet.transmitted * between, 1e-6);
            EXPECT_NEAR(both.reflected,
                        sheet.reflected + sheet.transmitted * sheet.transmitted * sheet.reflected * between, 1e-6);
        }
}

/// Returns the light transmitted and reflected by a sheet, traced photon by photon from side to side.
dvec2 tracedSheet(double scatter, double absorb, int photons)
{
    std::mt19937 random(8);
    std::exponential_distribution<double> free(scatter + absorb);
    std::uniform_real_distribution<double> even(0, 1);
    dvec2 left(0);
    for (int i = 0; i < photons; ++i) {
        double depth = 0, way = 1;
        while (true) {
            depth += way * free(random);
            if (depth < 0 || depth > 1) break;
            if (even(random) * (scatter + absorb) < absorb) {
                depth = -1e9;
                break;
            }
            way = -way;
        }
        if (depth > 1) left.y += 1.0 / photons;
        if (depth < 0 && depth > -1e8) left.x += 1.0 / photons;
    }
    return left;
}

TEST(Paper, IsWhatTracedLightSays)
{
    for (const dvec2 kind : {dvec2(1.6, 0.02), dvec2(1.6, 0.3), dvec2(0.4, 0.1), dvec2(6, 1)}) {
        const auto sheet = glsl::sheetOf(kind.x, kind.y);
        const dvec2 traced = tracedSheet(kind.x, kind.y, 200000);
        EXPECT_NEAR(sheet.reflected, traced.x, 0.005) << kind.x << ' ' << kind.y;
        EXPECT_NEAR(sheet.transmitted, traced.y, 0.005) << kind.x << ' ' << kind.y;
        // Beer's law, which ignores scattering back, is far off.
        EXPECT_GT(std::abs(std::exp(-kind.y) - traced.y), 0.05);
        // Traced in three dimensions, which two streams simplify.
        const test::SheetShares slab = test::tracedSlab(kind.x, kind.y, 100000, 1);
        EXPECT_NEAR(sheet.reflected, slab.reflected, 0.025) << kind.x << ' ' << kind.y;
        EXPECT_NEAR(sheet.transmitted, slab.transmitted, 0.025) << kind.x << ' ' << kind.y;
        EXPECT_GT(std::abs(std::exp(-kind.y) - slab.transmitted), 0.15);
    }
}

TEST(Paper, ScattersForwardsWithoutLoss)
{
    double all = 0, forward = 0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
        const double cosine = -1 + 2 * (i + 0.5) / steps;
        all += glsl::forwardLobe(cosine) * 4 * pi / steps;
        forward += cosine * glsl::forwardLobe(cosine) * 4 * pi / steps;
    }
    EXPECT_NEAR(all, 1, 1e-4);
    EXPECT_NEAR(forward, 0.8, 1e-4);
}

TEST(Paper, GlowsOnAverageAsFarLanternsDo)
{
    const PaperLanternsTable& t = lanternsTable();
    for (const double thickness : {0.3, 1.6, 6.0})
        for (const dvec3 shape : {dvec3(0.75, 2, 0.55), dvec3(0.4, 1.2, 0.5), dvec3(0.75, 2, 1)}) {
            ParameterValues values = t.initial();
            values.set(t.paperThickness, thickness);
            values.set(t.paperRadius, shape.x);
            values.set(t.paperHeight, shape.y);
            values.set(t.flameHeight, shape.z);
            glsl::Lake lake = lakeAtFloat64(values, 0);
            double sum = 0, brightest = 0, top = 0;
            constexpr int steps = 200;
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const double aside = shape.x * (-1 + 2 * (i + 0.5) / steps);
                    const double here = lake.paperProfile(aside, shape.y * (j + 0.5) / steps);
                    sum += here / (steps * steps);
                    brightest = std::max(brightest, here);
                    top = j + 1 == steps ? std::max(top, here) : top;
                }
            EXPECT_NEAR(sum, 1, 0.05) << thickness << ' ' << shape.x;
            // Thin paper shows where the flame is; thick paper hardly does.
            if (thickness < 2) {
                EXPECT_GT(brightest, 6 * top) << thickness << ' ' << shape.x;
            }
        }
}

TEST(Paper, HasNoSeam)
{
    double widest = 0, control = 0;
    for (int i = 0; i < 400; ++i) {
        const double y = 0.005 * i;
        const double e = 1e-9;
        const dvec3 before(0.75 * std::cos(pi - e), y, 0.75 * std::sin(pi - e));
        const dvec3 after(before.x, y, -before.z);
        const dvec3 a = glsl::paperFibers(before, 0.75, 0), b = glsl::paperFibers(after, 0.75, 0);
        widest = std::max({widest, std::abs(a.x - b.x), 0.01 * glm::length(a - b)});
        // The same noise without wrapping around.
        const auto at = [&](double turns) {
            const dvec2 q(turns * 18, y * 5), cell = glm::floor(q);
            return glsl::gradientNoise(glm::ivec2(cell), q - cell, glm::ivec2(0), 9U).value;
        };
        control = std::max(control, std::abs(at(0.5 - 1e-9) - at(-0.5 + 1e-9)));
    }
    EXPECT_LT(widest, 1e-6);
    EXPECT_GT(control, 0.1);
}

TEST(Paper, TiltsAsASurfaceWithThoseBumpsDoes)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> around(-pi, pi), up(0.1, 1.9);
    constexpr double height = 0.01;
    double worst = 1, control = 1;
    for (int i = 0; i < 2000; ++i) {
        const double angle = around(random), y = up(random);
        const auto place = [&](double a, double h) {
            const dvec3 flat(0.75 * std::cos(a), h, 0.75 * std::sin(a));
            const double r = 0.75 + height * glsl::paperFibers(flat, 0.75, 0).x;
            return dvec3(r * std::cos(a), h, r * std::sin(a));
        };
        constexpr double e = 1e-5;
        const dvec3 truth = glm::normalize(
            glm::cross(place(angle, y + e) - place(angle, y - e), place(angle + e, y) - place(angle - e, y)));
        const dvec3 flat(0.75 * std::cos(angle), y, 0.75 * std::sin(angle));
        const dvec3 fiber = glsl::paperFibers(flat, 0.75, 0);
        worst = std::min(worst, glm::dot(truth, glsl::paperNormal(flat, height * fiber)));
        // The method of the reference: the map's value is added to the normal in world axes.
        const dvec3 wrong = glm::normalize(dvec3(flat.x, 0, flat.z) / 0.75 + 0.35 * dvec3(fiber.x, fiber.x, fiber.x));
        control = std::min(control, glm::dot(truth, wrong));
    }
    EXPECT_GT(worst, std::cos(0.01));
    EXPECT_LT(control, std::cos(0.1));
}

}  // namespace
}  // namespace vitrine::paper_lanterns
