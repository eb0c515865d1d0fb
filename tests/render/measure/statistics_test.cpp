// Medians, intervals and power laws, compared with published tables and simulated measurements.

#include "render/measure/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace vitrine {
namespace {

using namespace render;

TEST(Statistics, MedianAndSpreadAreNotMovedByAnOutlier)
{
    const std::vector<double> samples{5, 1, 4, 2, 1000, 3, 6};
    const Summary s = summarize(samples);
    EXPECT_EQ(s.runs, 7U);
    EXPECT_EQ(s.median, 4);
    EXPECT_EQ(s.spread, 2);
    EXPECT_EQ(s.low, 1);
    EXPECT_EQ(s.high, 1000);
}

TEST(Statistics, QuantilesAreLinearBetweenNeighbors)
{
    const std::vector<double> samples{10, 20, 30, 40};
    EXPECT_EQ(quantile(samples, 0), 10);
    EXPECT_EQ(quantile(samples, 0.5), 25);
    EXPECT_EQ(quantile(samples, 1), 40);
    EXPECT_DOUBLE_EQ(quantile(samples, 0.25), 17.5);
}

TEST(Statistics, TheIntervalOfTheMedianIsThatOfThePublishedTable)
{
    // Ranks of the two-sided 95 % sign interval: n = 10: 2 and 9 with 97.85 %; n = 15: 4 and 12 with 96.48 %.
    std::vector<double> ten;
    for (int i = 1; i <= 10; ++i) ten.push_back(i);
    const Interval a = medianInterval(ten);
    EXPECT_EQ(a.low, 2);
    EXPECT_EQ(a.high, 9);
    EXPECT_NEAR(a.confidence, 0.9785, 1e-4);
    std::vector<double> fifteen = ten;
    for (int i = 11; i <= 15; ++i) fifteen.push_back(i);
    const Interval b = medianInterval(fifteen);
    EXPECT_EQ(b.low, 4);
    EXPECT_EQ(b.high, 12);
    EXPECT_NEAR(b.confidence, 0.9648, 1e-4);
}

TEST(Statistics, FewSamplesPromiseOnlyWhatTheyCan)
{
    const Interval three = medianInterval(std::vector<double>{3, 1, 2});
    EXPECT_EQ(three.low, 1);
    EXPECT_EQ(three.high, 3);
    EXPECT_DOUBLE_EQ(three.confidence, 0.75);
    EXPECT_EQ(medianInterval(std::vector<double>{3}).confidence, 0);
}

TEST(Statistics, TheIntervalHoldsTheMedianAsOftenAsItPromises)
{
    std::mt19937 random(5);
    std::lognormal_distribution<double> skewed(0, 1);  // Its median is 1.
    int held = 0;
    constexpr int trials = 4000;
    for (int t = 0; t < trials; ++t) {
        std::vector<double> samples(11);
        for (double& s : samples) s = skewed(random);
        held += medianInterval(samples).holds(1) ? 1 : 0;
    }
    // For n = 11 the probability is 98.8 %. Four standard deviations of 4000 trials are 0.7 %.
    EXPECT_NEAR(static_cast<double>(held) / trials, 0.98828, 0.007);
}

TEST(Statistics, StudentsQuantilesAreThoseOfTheTables)
{
    EXPECT_NEAR(studentQuantile(0.975, 1), 12.706, 0.001);
    EXPECT_NEAR(studentQuantile(0.975, 2), 4.303, 0.001);
    EXPECT_NEAR(studentQuantile(0.975, 3), 3.182, 0.002);
    EXPECT_NEAR(studentQuantile(0.975, 5), 2.571, 0.001);
    EXPECT_NEAR(studentQuantile(0.975, 10), 2.228, 0.001);
    EXPECT_NEAR(studentQuantile(0.995, 4), 4.604, 0.002);
    EXPECT_NEAR(studentQuantile(0.95, 30), 1.697, 0.001);
    EXPECT_NEAR(studentQuantile(0.975, 1e6), 1.960, 0.001);
}

TEST(Statistics, APowerLawIsFoundExactly)
{
    std::vector<double> x;
    std::vector<double> y;
    for (double v = 1; v < 100; v *= 2) {
        x.push_back(v);
        y.push_back(3 * std::pow(v, -1.5));
    }
    x.push_back(0);  // Has no logarithm, so it is ignored.
    y.push_back(1);
    const PowerLaw law = fitPowerLaw(x, y);
    EXPECT_EQ(law.points, 7U);
    EXPECT_NEAR(law.slope, -1.5, 1e-12);
    EXPECT_NEAR(std::exp(law.offset), 3, 1e-12);
    EXPECT_FALSE(fitPowerLaw(std::vector<double>{2, 2}, std::vector<double>{1, 3}).found());
}

TEST(Statistics, TheIntervalOfASlopeHoldsItAsOftenAsItPromises)
{
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0, 0.2);
    int held = 0;
    constexpr int trials = 2000;
    for (int t = 0; t < trials; ++t) {
        std::vector<double> x;
        std::vector<double> y;
        for (double v = 1; v < 200; v *= 2) {
            x.push_back(v);
            y.push_back(std::pow(v, -0.5) * std::exp(noise(random)));
        }
        held += fitPowerLaw(x, y).slopeInterval.holds(-0.5) ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(held) / trials, 0.95, 0.02);
}

TEST(Statistics, EveryRoundMeasuresEverythingOnceAndStartsElsewhere)
{
    std::set<std::size_t> first;
    for (std::size_t round = 0; round < 8; ++round) {
        std::vector<std::size_t> order = interleaved(8, round);
        first.insert(order.front());
        std::sort(order.begin(), order.end());
        for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(order[i], i);
    }
    EXPECT_GE(first.size(), 4U);
    EXPECT_TRUE(interleaved(0, 3).empty());
}

TEST(Statistics, MediansOfTheSameThingAreSeldomToldApartAndThoseOfDifferentThingsMostly)
{
    std::mt19937 random(1);
    const auto measured = [&](double mean) {
        std::normal_distribution<double> noise(mean, 1);
        std::vector<double> runs(15);
        for (double& run : runs) run = noise(random);
        runs[3] += 50;  // One run of fifteen is disturbed and must have little influence.
        return summarize(runs);
    };
    int sameToldApart = 0;
    int differentToldApart = 0;
    for (int i = 0; i < 1000; ++i) {
        sameToldApart += indistinguishable(measured(70), measured(70)) ? 0 : 1;
        differentToldApart += indistinguishable(measured(70), measured(72)) ? 0 : 1;
    }
    EXPECT_LT(sameToldApart, 100);       // Two standard errors: about 1 in 20, with the uncertain spread of few runs.
    EXPECT_GT(differentToldApart, 900);  // Means two deviations apart differ by four and a half standard errors.
}

}  // namespace
}  // namespace vitrine
