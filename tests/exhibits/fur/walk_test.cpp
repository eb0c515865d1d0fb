// Rays through a coat: the first strand that they hit, compared with steps so fine that none is missed, and with coarse
// steps, which the closed form replaces. The shaders' own code at float64.

#include "exhibits/framework/table/random_values.h"
#include "exhibits/fur/strand_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::fur {
namespace {

using glm::dvec2;
using glm::dvec3;
using glsl::CoatRay;
using glsl::CoatStrands;
using glsl::MetStrand;
using glsl::RootedStrand;
using glsl::ShellPoint;
using glsl::StrandLattice;

using std::numbers::pi;

/// Returns the coat of the ball at rest.
CoatStrands ballStrands(double clump)
{
    CoatStrands c{};
    c.cellSize = glsl::strandCellSize(60000);
    c.leastLength = 0.35;
    c.widest = 0.00225 / c.cellSize;
    c.roundness = 0.55;
    c.pixel = 0.05;
    c.jitter = 0.8;
    c.clump = clump;
    c.tuft = 10;
    return c;
}

/// Returns a straight ray over flat skin that passes `cells` cells while it sinks by `depth`, in 1 m.
CoatRay flatRay(RandomNumbers& random, const CoatStrands& c, double cells, double depth)
{
    const double angle = 2 * pi * random.number(0, 1);
    CoatRay ray{};
    ray.skin = {random.number(0, 1), 0, random.number(0, 1)};
    ray.passing = dvec3(std::cos(angle), 0, std::sin(angle)) * (cells * c.cellSize);
    ray.height = 0.3 + 0.7 * random.number(0, 1);
    ray.falling = -depth;
    return ray;
}

struct Hit {
    double height = 0, rank = 0, tint = 0;
};
using Found = std::optional<Hit>;

bool same(const Found& a, const Found& b)
{
    if (a.has_value() != b.has_value()) return false;
    return !a || (a->rank == b->rank && a->tint == b->tint);
}

/// Returns the strand that contains a point of the lattice, if this supersample draws it there.
Found inStrand(const CoatStrands& c, const StrandLattice& l, const dvec2& q, double height)
{
    const RootedStrand s = glsl::strandInCell(l, q, c.jitter);
    const double end = c.leastLength + (1 - c.leastLength) * s.rank;
    const double draw = glsl::fractBelowOne(s.tint + c.shuffle);
    if (!s.rooted || draw * c.pixel >= c.widest || height >= end || 1 - height / end <= draw * c.soft) return {};
    const double radius = std::max(c.widest * glsl::strandTaper(height, end, c.roundness), c.pixel);
    if (glm::dot(s.offset, s.offset) + s.along * s.along >= radius * radius) return {};
    return Hit{height, s.rank, s.tint};
}

const dvec3 up(0, 1, 0);

Found byFineSteps(const CoatRay& ray, const CoatStrands& c, const StrandLattice& l)
{
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        if (const Found hit = inStrand(c, l, glsl::rootPassed(ray, c, l, up, t), ray.height + ray.falling * t))
            return hit;
    }
    return {};
}

/// Steps by half a cell, up to 16 times, with the pull of the tufts at the ray's start.
Found byHalfCells(const CoatRay& ray, const CoatStrands& c, const StrandLattice& l)
{
    const dvec2 start = glsl::onLattice(l, ray.skin) / c.cellSize;
    const dvec2 drawn = (glsl::rootPassed(ray, c, l, up, 0) - start) / ray.height;
    const dvec2 pace = glsl::onLattice(l, ray.passing) / c.cellSize;
    const int steps = std::clamp(static_cast<int>(std::ceil(glm::length(pace) * 2.2)), 1, 16);
    for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double at = ray.height + ray.falling * t;
        if (const Found hit = inStrand(c, l, start + pace * t + drawn * at, at)) return hit;
    }
    return {};
}

TEST(StrandWalk, MeetsTheStrandThatFineStepsMeet)
{
    const StrandLattice l = glsl::strandLattice(up, 5);
    using Pair = std::pair<double, double>;
    for (const auto& [clump, soft] : {Pair(0, 0), Pair(0.75, 0), Pair(0.75, 0.4)}) {
        CoatStrands c = ballStrands(clump);
        c.soft = soft;
        c.shuffle = 0.4;
        RandomNumbers random(7);
        int right = 0, coarse = 0, met = 0;
        double off = 0;
        constexpr int rays = 1500;
        for (int i = 0; i < rays; ++i) {
            const CoatRay ray = flatRay(random, c, 5 * random.number(0, 1), 0.07);
            const Found truth = byFineSteps(ray, c, l);
            const MetStrand found = glsl::walkStrands(ray, c, l, up, dvec2(0, 1), 32);
            const Found walked = found.met ? Found(Hit{found.height, found.strand.rank, found.strand.tint}) : Found();
            right += same(walked, truth);
            coarse += same(byHalfCells(ray, c, l), truth);
            if (!truth || !same(walked, truth)) continue;
            ++met;
            off += std::abs(walked->height - truth->height);
        }
        std::printf("clump %.2f: of %d rays the walk finds the right strand for %d, half cells for %d\n", clump, rays,
                    right, coarse);
        EXPECT_GT(right, 0.97 * rays) << clump;
        EXPECT_LT(coarse, (clump > 0 ? 0.88 : 0.95) * rays) << "the coarse way would do as well";
        ASSERT_GT(met, rays / 3);
        EXPECT_LT(off / met, 0.002) << "of a strand's length, where it is met";
    }
}

TEST(StrandWalk, FadesOutTowardsTheTips)
{
    // Share of the supersamples that draw a strand at a height: it grows linearly from the tip down to the end of the
    // soft part, and is at most the share of a pixel that the strand covers.
    constexpr int draws = 10'000;
    constexpr double end = 0.7;
    using Pair = std::pair<double, double>;
    for (const auto& [pixel, soft] : {Pair(0.05, 0.7), Pair(0.05, 0), Pair(0.9, 0.3), Pair(3, 0.5)}) {
        CoatStrands c = ballStrands(0);
        c.pixel = pixel;
        c.soft = soft;
        for (const double h : {0.05, 0.3, 0.5, 0.62, 0.69}) {
            int drawn = 0;
            for (int i = 0; i < draws; ++i) drawn += h < glsl::drawnHeight(c, end, c.widest, (i + 0.5) / draws);
            const double fade = soft > 0 ? (1 - h / end) / soft : 1;
            EXPECT_NEAR(static_cast<double>(drawn) / draws, std::min({fade, c.widest / pixel, 1.0}), 1e-3)
                << pixel << ' ' << soft << ' ' << h;
        }
    }
}

TEST(StrandWalk, LooksIntoNoMoreCellsThanItMay)
{
    // Above the tips of a lawn nothing is hit, however many cells are visited; among its strands, the first one is hit.
    const StrandLattice l = glsl::strandLattice(up, 5);
    CoatStrands c = ballStrands(0);
    c.leastLength = 1;
    RandomNumbers random(3);
    int one = 0, many = 0;
    for (int i = 0; i < 300; ++i) {
        CoatRay ray = flatRay(random, c, 8, 0.05);
        ray.height = 1.1;
        EXPECT_FALSE(glsl::walkStrands(ray, c, l, up, dvec2(0, 1), 32).met);
        ray.height = 0.9;
        one += glsl::walkStrands(ray, c, l, up, dvec2(0, 1), 1).met;
        many += glsl::walkStrands(ray, c, l, up, dvec2(0, 1), 32).met;
    }
    EXPECT_LT(one, 0.5 * many);
}

/// Combed coat that lies in swirls over one triangle of a ball's skin. Positions are weighted from three corners, as in
/// a rasterizer, each in closed form. x, y: weights of the second and third corner.
struct TriangleCoat {
    std::array<dvec3, 3> corners;  ///< Unit vectors from the ball's center.
    double radius = 0.33, length = 0.2, bend = 0.8;

    template <typename Of> [[nodiscard]] dvec3 weighted(const dvec2& at, const Of& of) const
    {
        return of(corners[0]) * (1 - at.x - at.y) + of(corners[1]) * at.x + of(corners[2]) * at.y;
    }
    [[nodiscard]] static dvec3 tip(const dvec3& n)
    {
        const dvec3 swirl(std::sin(3 * n.y + 1), std::sin(4 * n.z), std::sin(3 * n.x + 2));
        return glm::normalize(n + swirl * 0.3 + dvec3(0.3, -0.8, 0.2));
    }
    [[nodiscard]] dvec3 skin(const dvec2& at) const
    {
        return weighted(at, [&](const dvec3& n) { return n * radius; });
    }
    [[nodiscard]] dvec3 place(const dvec2& at, double h) const
    {
        return weighted(at, [&](const dvec3& n) {
            return n * radius + length * glsl::strandPoint(n, tip(n), h, bend, glsl::STRAND_SLERP);
        });
    }
    [[nodiscard]] dvec3 way(const dvec2& at, double h) const
    {
        return weighted(at, [&](const dvec3& n) {
            return glsl::strandDirection(n, tip(n), std::pow(h, bend), glsl::STRAND_SLERP);
        });
    }
    [[nodiscard]] ShellPoint shellPoint(const dvec2& at, double h, double gap) const
    {
        ShellPoint s{};
        s.skin = skin(at);
        s.normal = glm::normalize(s.skin);
        s.height = h;
        s.way = way(at, h);
        s.turn = (way(at, h + gap / 2) - way(at, h - gap / 2)) / gap;
        const dvec2 x(1, 0), y(0, 1);
        s.placeX = place(at + x, h) - place(at, h);
        s.placeY = place(at + y, h) - place(at, h);
        s.wayX = way(at + x, h) - s.way;
        s.wayY = way(at + y, h) - s.way;
        s.skinX = skin(at + x) - s.skin;
        s.skinY = skin(at + y) - s.skin;
        return s;
    }
    /// Returns the weights and height of the point `p`, by Newton's method from a guess.
    [[nodiscard]] std::pair<dvec2, double> at(const dvec3& p, dvec2 xy, double h) const
    {
        for (int i = 0; i < 30; ++i) {
            const ShellPoint s = shellPoint(xy, h, 1e-3);
            const dvec3 change = glm::inverse(glm::dmat3(s.placeX, s.placeY, s.way * length)) * (p - place(xy, h));
            xy += dvec2(change);
            h += change.z;
        }
        return {xy, h};
    }
};

/// Returns a random triangle as large as those of the ball's mesh.
TriangleCoat someTriangle(RandomNumbers& random)
{
    const dvec3 n = random.direction();
    const dvec3 side = glsl::perpendicularTo(n);
    return {{n, glm::normalize(n + side * 0.2), glm::normalize(n + glm::cross(n, side) * 0.2)}};
}

/// First-order approximation in which the curvature stretches the skin evenly, as earlier shells used.
CoatRay firstOrderRay(const TriangleCoat& coat, const ShellPoint& s, const dvec3& v)
{
    const dvec3 n = s.normal;
    const double rise = std::max(glm::dot(s.way, n), 0.12);
    const double into = glm::dot(v, n);
    CoatRay ray{};
    ray.skin = s.skin;
    ray.height = s.height;
    ray.passing = (v - s.way * (into / rise)) / (1 + s.height * coat.length * rise / coat.radius);
    ray.falling = into / (rise * coat.length);
    const dvec3 along = v - n * into;
    ray.bulge = 0.5 * glm::dot(along, along) / (coat.radius * coat.length);
    return ray;
}

dvec3 rootAfter(const CoatRay& ray, double t)
{
    return ray.skin + (ray.passing + ray.bending * t) * t;
}

struct Misses {
    double ours, firstOrder, jump, firstOrderJump;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.at(values.size() / 2);
}

/// Returns the median distances in meters of the found roots from the true ones at the end of a shell's range, and the
/// jumps between shells.
Misses missesOf(double gap)
{
    RandomNumbers random(11);
    std::vector<double> ours, firstOrder, jump, firstOrderJump;
    constexpr int rays = 101;
    for (int i = 0; i < rays; ++i) {
        const TriangleCoat coat = someTriangle(random);
        const dvec2 here(random.number(0.2, 0.4), random.number(0.2, 0.4));
        const double h = random.number(0.5, 0.9);
        const ShellPoint s = coat.shellPoint(here, h, gap);
        const dvec3 v = glm::normalize(random.direction() - s.way * 1.5);
        const CoatRay ray = glsl::coatRay(s, v, coat.length);
        const dvec3 place = coat.place(here, h);
        const auto truth = [&](double t) { return coat.skin(coat.at(place + v * t, here, h).first); };
        const double half = glsl::coatStretch(ray, 0, gap / 2, gap).y;
        ours.push_back(glm::length(rootAfter(ray, half) - truth(half)));
        const double full = glsl::coatStretch(ray, 0, gap, gap).y;
        const CoatRay first = firstOrderRay(coat, s, v);
        firstOrder.push_back(glm::length(rootAfter(first, full) - truth(full)));
        // The next shell at its intersection with the ray covers the strands halfway to it.
        const auto [there, deeper] = coat.at(place + v * full, here, h - gap);
        const CoatRay next = glsl::coatRay(coat.shellPoint(there, deeper, gap), v, coat.length);
        jump.push_back(glm::length(rootAfter(next, half - full) - rootAfter(ray, half)));
        firstOrderJump.push_back(glm::length(coat.skin(there) - rootAfter(first, full)));
    }
    return {median(ours), median(firstOrder), median(jump), median(firstOrderJump)};
}

TEST(CoatRay, FindsTheRootsToTheSecondOrder)
{
    const double cell = glsl::strandCellSize(60000);
    const Misses ten = missesOf(1.0 / 9), twenty = missesOf(1.0 / 18);
    std::printf("roots miss by %.3f and %.3f cells with 10 and 19 shells, to the first order by %.3f and %.3f\n",
                ten.ours / cell, twenty.ours / cell, ten.firstOrder / cell, twenty.firstOrder / cell);
    EXPECT_LT(ten.ours, 0.01 * cell);
    EXPECT_GT(ten.firstOrder, 30 * ten.ours);
    EXPECT_GT(ten.ours, 3 * twenty.ours);
}

TEST(CoatRay, DoesNotJumpWhereOneShellHandsOverToTheNext)
{
    const double cell = glsl::strandCellSize(60000);
    const Misses ten = missesOf(1.0 / 9);
    std::printf("jumps of %.3f cells between shells, to the first order %.3f\n", ten.jump / cell,
                ten.firstOrderJump / cell);
    EXPECT_LT(ten.jump, 0.02 * cell);
    EXPECT_GT(ten.firstOrderJump, 30 * ten.jump);
}

TEST(CoatRay, RisesOverASkinThatCurvesAwayFromIt)
{
    // Upright fur on a ball: height and root in closed form.
    constexpr double radius = 0.33, length = 0.2, h = 0.6;
    const dvec3 n(0, 1, 0), x(1, 0, 0), z(0, 0, 1);
    const double out = radius + length * h;
    ShellPoint s{};
    s.skin = n * radius;
    s.normal = s.way = n;
    s.height = h;
    s.placeX = x * out;
    s.placeY = z * out;
    s.skinX = x * radius;
    s.skinY = z * radius;
    s.normalX = s.wayX = x;
    s.normalY = s.wayY = z;
    const dvec3 v = glm::normalize(dvec3(1, -0.3, 0.4));
    const CoatRay ray = glsl::coatRay(s, v, length);
    const auto miss = [&](double t, double bulge) {
        const double height = (glm::length(n * out + v * t) - radius) / length;
        return std::abs(ray.height + (ray.falling + bulge * t) * t - height);
    };
    EXPECT_LT(miss(0.02, ray.bulge), 1e-3);
    EXPECT_GT(miss(0.04, ray.bulge) / miss(0.02, ray.bulge), 6) << "of the third order";
    EXPECT_GT(miss(0.02, 0), 10 * miss(0.02, ray.bulge)) << "the skin might as well be flat";
}

TEST(CoatStretch, HandsEachRayOnHalfwayAndLosesNoneThatTurnsBack)
{
    CoatRay ray{};
    ray.height = 0.5;
    ray.falling = -2;
    // Straight down.
    dvec2 stretch = glsl::coatStretch(ray, 0.05, 0.05, 0.1);
    EXPECT_NEAR(stretch.x, -0.025, 1e-12);
    EXPECT_NEAR(stretch.y, 0.025, 1e-12);
    // Over a curved skin, the height at entry and exit must be exact.
    for (const double bulge : {-3.0, 4.0, 9.0}) {
        ray.bulge = bulge;
        stretch = glsl::coatStretch(ray, 0.05, 0.05, 0.1);
        EXPECT_NEAR((ray.falling + bulge * stretch.x) * stretch.x, 0.05, 1e-12) << bulge;
        EXPECT_NEAR((ray.falling + bulge * stretch.y) * stretch.y, -0.05, 1e-12) << bulge;
    }
    // A ray that turns before the next shell is followed until it leaves.
    ray.bulge = 11;
    stretch = glsl::coatStretch(ray, 0.05, 0.05, 0.1);
    EXPECT_GT(stretch.y, 1.0 / 11);
    EXPECT_NEAR((ray.falling + 11 * stretch.y) * stretch.y, 0.05, 1e-12);
}

}  // namespace
}  // namespace vitrine::fur
