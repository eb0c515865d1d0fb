// Rays among the lanterns: none is clipped, whatever the camera does.

#include "tests/exhibits/paper_lanterns/lake_at_float64.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace vitrine::paper_lanterns {
namespace {

using glm::dvec3;
using namespace test;

struct Missed {
    int rays = 0, hits = 0, missed = 0, wrong = 0;
};

/// Returns the errors of rays from cameras on 100 random paths among lanterns that fill their cells.
Missed missedBy(int repetition)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().lanterns, 900);
    Missed result;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> even(0, 1);
    for (int path = 0; path < 100; ++path) {
        glsl::Lake lake = lakeAtFloat64(values, 1.3 * path);
        lake.lake.tolerance = 0;
        const auto all = everyLantern(lake);
        const double size = lake.lake.cell * lake.lake.cells.x;
        const auto place = [&] {
            return dvec3(lake.lake.corner.x + size * even(random), 0.3 + 5 * even(random),
                         lake.lake.corner.y - size * even(random));
        };
        const dvec3 from = place(), to = place();
        for (int i = 0; i < 40; ++i) {
            glsl::Lake::LanternRay ray{};
            ray.origin = glm::mix(from, to, i / 40.0);
            ray.direction = glm::normalize(dvec3(even(random) - 0.5, 0.25 * (even(random) - 0.7), even(random) - 0.5));
            ray.to = 150;
            const double truth = nearestOfAll(lake, all, ray);
            const auto walk =
                repetition == REPEAT_CELL_WALL ? lake.walkLanterns(ray) : lake.walkNeighbors(ray, repetition, 4000);
            const double found = walk.part == PART_NONE ? ray.to : walk.distance;
            ++result.rays;
            result.hits += truth < ray.to;
            result.missed += found > truth + 0.01;
            result.wrong += found < truth - 0.01;
        }
    }
    return result;
}

TEST(Lattice, CutsNoLanternAlong100RandomPaths)
{
    const Missed ours = missedBy(REPEAT_CELL_WALL);
    EXPECT_GT(ours.hits, 1500);
    EXPECT_EQ(ours.missed, 0);
    EXPECT_EQ(ours.wrong, 0);
    const Missed nine = missedBy(REPEAT_3X3);
    EXPECT_EQ(nine.missed, 0);
    // Control: with the own cell only, like naive repetition, rays step over the neighbors.
    EXPECT_GT(missedBy(REPEAT_OWN_CELL).missed, 10);
}

TEST(LongLattice, LetsRaysPassTheEdgesThatTheyDoNotTouch)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().lanterns, 400);
    glsl::Lake lake = lakeAtFloat64(values, 2);
    lake.lake.tolerance = 0.1;
    lake.lake.stepLimit = values[lanternsTable().stepLimit];
    const auto all = everyLantern(lake);
    int edges = 0, early = 0, missed = 0;
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 120; ++x) {
            glsl::Lake::LanternRay ray{};
            ray.origin = {lake.lake.corner.x + 30, 3.5, lake.lake.corner.y + 6};
            ray.direction = glm::normalize(dvec3(0.008 * (x - 60), -0.004 * y, -1));
            ray.to = 120;
            ray.spread = glm::dvec2(0.008);
            const double truth = nearestOfAll(lake, all, ray);
            const double margin = 0.01 + 2 * ray.spread.x * truth;
            const auto distance = [&](const glsl::Lake::LanternWalk& walk) {
                return walk.part == PART_NONE ? ray.to : walk.distance;
            };
            early += distance(lake.walkLanterns(ray)) < truth - std::max(margin, 0.05 * truth);
            missed += distance(lake.walkLanterns(ray)) > truth + margin;
            // Control: like in the reference, a ray ends within the tolerance of any lantern.
            edges += distance(lake.walkNeighbors(ray, REPEAT_3X3, 4000)) < truth - std::max(margin, 0.05 * truth);
        }
    EXPECT_GT(edges, 100);
    EXPECT_LT(early, edges / 10);
    EXPECT_EQ(missed, 0);
}

TEST(Lattice, KeepsEveryLanternWithinItsCell)
{
    for (const double waves : {0.0, 1.0, 8.0}) {
        ParameterValues values = sourceLake();
        values.set(lanternsTable().waveHeight, waves);
        glsl::Lake lake = lakeAtFloat64(values, 4.2);
        std::mt19937 random(4);
        std::uniform_real_distribution<double> even(-1, 1);
        for (int i = 0; i < 400; ++i) {
            const glm::ivec2 cell(i % 20, i / 20);
            const auto l = lake.lanternOfCell(cell);
            const glm::dmat3 axes = lake.lakeFromLantern(l);
            for (int j = 0; j < 60; ++j) {
                const dvec3 p(1.2 * even(random), 1 + 1.2 * even(random), 1.2 * even(random));
                if (lake.lanternField(p).distance > 0) continue;
                const dvec3 at = axes * p + l.place;
                EXPECT_EQ(std::floor((at.x - lake.lake.corner.x) / lake.lake.cell), cell.x);
                EXPECT_EQ(std::floor((lake.lake.corner.y - at.z) / lake.lake.cell), cell.y);
                EXPECT_GE(at.y, lake.lake.low);
                EXPECT_LE(at.y, lake.lake.high);
            }
        }
    }
}

TEST(Lattice, HasNoneAndOneAndMany)
{
    ParameterValues values = sourceLake();
    values.set(lanternsTable().crowding, 0.0);
    EXPECT_FALSE(anyAfloat(lanternsTable(), values));
    EXPECT_LT(lakeAtFloat64(values, 0).lanternOfCell({1, 1}).light, 0);
    values.set(lanternsTable().crowding, 1.0);
    values.set(lanternsTable().lanterns, 1);
    EXPECT_EQ(lakeAtFloat64(values, 0).lake.cells, glm::ivec2(1));
    values.set(lanternsTable().lanterns, 1000000);
    const auto many = lakeAtFloat64(values, 0);
    EXPECT_EQ(many.lake.cells, glm::ivec2(LAKE_LATTICE));
    EXPECT_NEAR(many.lake.farRow, 1000 * many.lake.cell, 1e-2);
}

}  // namespace
}  // namespace vitrine::paper_lanterns
