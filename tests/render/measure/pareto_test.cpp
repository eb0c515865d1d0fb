// Pareto fronts and knees of costs and errors.

#include "render/measure/pareto.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vitrine {
namespace {

using namespace render;

TEST(Pareto, TheFrontIsWhatNothingDominates)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<CostAndError> points(60);
        for (CostAndError& p : points) p = {std::round(20 * uniform(random)), std::round(20 * uniform(random))};
        const std::vector<std::size_t> front = paretoFront(points);
        for (std::size_t k = 1; k < front.size(); ++k) EXPECT_LT(points[front[k - 1]].cost, points[front[k]].cost);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool onFront = std::find(front.begin(), front.end(), i) != front.end();
            bool dominated = false;
            bool equalOnFront = false;
            for (std::size_t j = 0; j < points.size(); ++j) dominated = dominated || dominates(points[j], points[i]);
            for (const std::size_t f : front)
                equalOnFront = equalOnFront || (points[f].cost == points[i].cost && points[f].error == points[i].error);
            EXPECT_EQ(dominated, !onFront && !equalOnFront) << i;
        }
    }
}

TEST(Pareto, WhatIsNotFiniteIsOnNoFront)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::vector<CostAndError> points{{1, infinite}, {infinite, 0}, {2, std::nan("")}, {3, 1}};
    EXPECT_EQ(paretoFront(points), std::vector<std::size_t>{3});
}

TEST(Pareto, TheKneeIsWhereTwoLawsMeet)
{
    // The error falls with cost^-2 and then with cost^-0.2: the knee is at cost 16.
    std::vector<CostAndError> points;
    for (double cost = 1; cost <= 256; cost *= 2)
        points.push_back({cost, cost <= 16 ? std::pow(cost, -2) : std::pow(16.0, -2) * std::pow(cost / 16, -0.2)});
    const std::vector<std::size_t> front = paretoFront(points);
    ASSERT_EQ(front.size(), points.size());
    const auto place = knee(points, front);
    ASSERT_TRUE(place);
    EXPECT_EQ(points[front[*place]].cost, 16);
}

TEST(Pareto, AStraightLawHasNoKnee)
{
    std::vector<CostAndError> points;
    for (double cost = 1; cost <= 256; cost *= 2) points.push_back({cost, 1 / cost});
    EXPECT_FALSE(knee(points, paretoFront(points)));
    points.resize(2);
    EXPECT_FALSE(knee(points, paretoFront(points)));
}

TEST(Pareto, AnErrorOfZeroIsAPlaceOnTheChart)
{
    const std::vector<CostAndError> points{{1, 1}, {2, 0.01}, {100, 0}};
    const auto place = knee(points, paretoFront(points));
    ASSERT_TRUE(place);
    EXPECT_EQ(*place, 1U);
}

}  // namespace
}  // namespace vitrine
