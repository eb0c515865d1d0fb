// Strands: evenly dense over a body, and equally long bent and straight. The shader's own code at float64.

#include "exhibits/fur/strand_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace vitrine::fur {
namespace {

using glm::dvec3;
using glsl::Strand;

using std::numbers::pi;

/// Returns evenly distributed points on a sphere: Fibonacci spiral (Gonzalez 2010).
dvec3 onSphere(int i, int n)
{
    const double y = 1 - 2 * (i + 0.5) / n;
    const double phi = 2 * pi * std::fmod(i * 0.6180339887498949, 1.0);
    const double r = std::sqrt(1 - y * y);
    return {r * std::cos(phi), y, r * std::sin(phi)};
}

/// Measures the share of the sphere's area that strands of fixed radius cover, in caps around many directions. Returns
/// the largest relative difference from the mean.
double unevenness(double cellSize, bool thinned)
{
    constexpr int samples = 2'000'000;
    constexpr int caps = 60;
    const double radius = 0.35;  // Radius of the body in meters.
    const double strand = 0.16 * cellSize;
    std::vector<dvec3> axes;
    for (int k = 0; k < caps; ++k) axes.push_back(onSphere(k, caps));
    std::vector<double> hits(caps), total(caps);
    for (int i = 0; i < samples; ++i) {
        const dvec3 n = onSphere(i, samples);
        const Strand s = glsl::strandAt(n * radius, n, cellSize, 0.6, 7);
        const bool in = (s.rooted || !thinned) && glm::length(s.offset) < strand;
        for (int k = 0; k < caps; ++k) {
            if (glm::dot(n, axes[static_cast<std::size_t>(k)]) < 0.94) continue;
            ++total[static_cast<std::size_t>(k)];
            hits[static_cast<std::size_t>(k)] += in;
        }
    }
    double mean = 0;
    for (int k = 0; k < caps; ++k)
        mean += hits[static_cast<std::size_t>(k)] / total[static_cast<std::size_t>(k)] / caps;
    double worst = 0;
    for (int k = 0; k < caps; ++k)
        worst = std::max(worst,
                         std::abs(hits[static_cast<std::size_t>(k)] / total[static_cast<std::size_t>(k)] / mean - 1));
    return worst;
}

TEST(LongStrands, AreAsDenseAtThePolesAsElsewhere)
{
    // A cap has about 1,100 strands, of which chance removes up to 4 in 10: a standard deviation of 2.4 %. The largest
    // of 60 such deviations stays below three of them, 7.3 %.
    const double cell = glsl::strandCellSize(60000);
    EXPECT_LT(unevenness(cell, true), 0.073);
    // Without dropping cells, the corners of the cube would be half as dense as its faces.
    EXPECT_GT(unevenness(cell, false), 0.15);
}

TEST(Strands, DifferInThicknessEvenlyAndWithoutRegardToLengthAndTint)
{
    // For 40,000 cells, the mean of numbers between 0 and 1 has a standard deviation of 0.0014. The product of two
    // independent ones, minus that of their means, has about 0.0005.
    const glsl::StrandLattice lattice = glsl::strandLattice(dvec3(0, 1, 0), 5);
    double mean = 0, squares = 0, withRank = 0, withTint = 0;
    constexpr int side = 200;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            const glsl::RootedStrand s = glsl::strandInCell(lattice, glm::dvec2(x + 0.5, y + 0.5), 0.8);
            ASSERT_GE(s.girth, 0);
            ASSERT_LT(s.girth, 1);
            mean += s.girth / (side * side);
            squares += s.girth * s.girth / (side * side);
            withRank += (s.girth - 0.5) * (s.rank - 0.5) / (side * side);
            withTint += (s.girth - 0.5) * (s.tint - 0.5) / (side * side);
        }
    }
    EXPECT_NEAR(mean, 0.5, 0.006);
    EXPECT_NEAR(squares, 1.0 / 3, 0.006);
    EXPECT_NEAR(withRank, 0, 0.002);
    EXPECT_NEAR(withTint, 0, 0.002);
}

TEST(LongStrands, AreAsManyAsAreAskedFor)
{
    for (const double density : {2000.0, 20000.0}) {
        const double cell = glsl::strandCellSize(density);
        const double radius = 0.35;
        // Roots are found by steps so fine that no cell is missed.
        std::set<std::tuple<double, double, double>> roots;
        const int samples = static_cast<int>(4 * pi * radius * radius * density * 200);
        for (int i = 0; i < samples; ++i) {
            const dvec3 n = onSphere(i, samples);
            const Strand s = glsl::strandAt(n * radius, n, cell, 0.8, 3);
            if (s.rooted && glm::length(s.offset) < 0.2 * cell) roots.insert({s.rank, s.tint, n.x > 0 ? 1.0 : -1.0});
        }
        const double expected = 4 * pi * radius * radius * density;
        EXPECT_NEAR(static_cast<double>(roots.size()) / expected, 1, 0.06) << density;
    }
}

TEST(Strands, HaveLengthsOfTheirOwn)
{
    // Cells 1000 apart and more, where a seed of x + 100 y would repeat, and 1e6 m away.
    for (const double far : {0.0, 1e6}) {
        std::set<double> ranks;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ranks.insert(glsl::strandAt(dvec3(far + 100 * x, 0, far + 100 * y), dvec3(0, 1, 0), 1, 0.5, 1).rank);
        EXPECT_GE(ranks.size(), 4094U) << far;
    }
}

TEST(Strands, OffsetsLieInTheSurface)
{
    for (int i = 0; i < 500; ++i) {
        const dvec3 n = onSphere(i, 500);
        const Strand s = glsl::strandAt(n * 0.3 + dvec3(0.1, 2, -3), n, 0.01, 0.8, 5);
        EXPECT_NEAR(glm::dot(s.offset, n), 0, 1e-15);
        EXPECT_LT(glm::length(s.offset), 0.01 * 3);
    }
}

TEST(Bending, OfNlerpHurriesAsPublished)
{
    // Published errors for quaternions, whose angle is half the rotation: at most 0.033 degrees at a rotation of 30,
    // 0.92 at 90, 8.1 at 180. Directions have the whole angle.
    const auto error = [](double turn) {
        double worst = 0;
        for (int i = 0; i <= 100; ++i) {
            const dvec3 root(0, 1, 0);
            const dvec3 tip(std::sin(turn), std::cos(turn), 0);
            const dvec3 d = glsl::strandDirection(root, tip, i / 100.0, glsl::STRAND_NLERP);
            worst = std::max(worst, std::abs(std::atan2(d.x, d.y) - turn * i / 100.0));
        }
        return worst * 180 / pi;
    };
    EXPECT_NEAR(2 * error(pi / 12), 0.033, 0.001);
    EXPECT_NEAR(2 * error(pi / 4), 0.92, 0.01);
    EXPECT_NEAR(2 * error(pi / 2), 8.1, 0.1);
}

TEST(Bending, StartsLateWhereTheCurvatureIsHigh)
{
    const dvec3 root(0, 1, 0);
    const dvec3 tip(1, 0, 0);
    double last = 1;
    for (const double curvature : {0.0, 0.5, 1.0, 2.0, 5.0}) {
        const double aside = glsl::strandPoint(root, tip, 0.5, curvature, glsl::STRAND_SLERP).x;
        EXPECT_LT(aside, last);
        last = aside;
    }
    // A quarter turn at constant curvature is a quarter circle of length 1.
    const dvec3 end = glsl::strandPoint(root, tip, 1, 1, glsl::STRAND_SLERP);
    EXPECT_NEAR(end.x, 2 / pi, 1e-4);
    EXPECT_NEAR(end.y, 2 / pi, 1e-4);
}

TEST(Pressing, LetsNoTipThroughThePlane)
{
    const dvec3 away(0, 1, 0);
    for (int i = 0; i < 300; ++i) {
        const dvec3 root = onSphere(i, 300);
        for (const double gap : {-0.2, 0.0, 0.3, 0.8, 1.5}) {
            for (int j = 0; j < 20; ++j) {
                const dvec3 tip = onSphere(j, 20);
                const dvec3 pressed = glsl::strandPressed(root, tip, away, gap);
                EXPECT_NEAR(glm::length(pressed), 1, 1e-12);
                EXPECT_GE(pressed.y, -std::clamp(gap, 0.0, 1.0) - 1e-12);
                if (-tip.y <= std::clamp(gap, 0.0, 1.0)) {
                    EXPECT_EQ(pressed, tip);
                }
            }
        }
    }
}

TEST(CoatLight, IsHalfLambertAndDarkBetweenTheRoots)
{
    EXPECT_EQ(glsl::halfLambert(1), 1);
    for (const double away : {0.0, -0.3, -1.0}) EXPECT_EQ(glsl::halfLambert(away), 0.25);
    EXPECT_EQ(glsl::coatOcclusion(0, 1.2, 0), 0);
    EXPECT_EQ(glsl::coatOcclusion(0, 1.2, 0.3), 0.3);
    EXPECT_EQ(glsl::coatOcclusion(1, 1.2, 0.3), 1);
    EXPECT_EQ(glsl::coatOcclusion(0, 0, 0), 1);
    EXPECT_LT(glsl::coatOcclusion(0.5, 3, 0), glsl::coatOcclusion(0.5, 1, 0));
}

TEST(Taper, RunsFromFullAtTheRootToNothingAtTheTip)
{
    for (const double roundness : {0.0, 0.45, 0.999}) {
        EXPECT_EQ(glsl::strandTaper(0, 0.7, roundness), 1);
        EXPECT_EQ(glsl::strandTaper(0.7, 0.7, roundness), 0);
        EXPECT_EQ(glsl::strandTaper(0.9, 0.7, roundness), 0);
        EXPECT_EQ(glsl::strandTaper(0, 0, roundness), 0);
    }
    EXPECT_NEAR(glsl::strandTaper(0.35, 0.7, 0), 0.5, 1e-12);
    EXPECT_GT(glsl::strandTaper(0.35, 0.7, 0.8), 0.8);
}

}  // namespace
}  // namespace vitrine::fur
