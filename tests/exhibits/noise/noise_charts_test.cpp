// Charts of the noise, tested with noise of known histogram, spectrum and directions.

#include "exhibits/noise/noise_charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::noise {
namespace {

using std::numbers::pi;

double integral(const ChartCurve& curve)
{
    double sum = 0;
    for (std::size_t i = 0; i + 1 < curve.x.size(); ++i)
        sum += 0.5 * (curve.y[i] + curve.y[i + 1]) * (curve.x[i + 1] - curve.x[i]);
    return sum;
}

double highestAt(const ChartCurve& curve)
{
    return curve.x[static_cast<std::size_t>(std::max_element(curve.y.begin(), curve.y.end()) - curve.y.begin())];
}

TEST(NoiseCharts, HistogramOfASineIsThatOfTheArcsine)
{
    const ChartCurve curve = noiseHistogram("sine", [](const glm::dvec3& p) { return std::sin(2 * pi * p.x); });
    double sum = 0;
    for (const double y : curve.y) sum += y * 2 / static_cast<double>(curve.y.size());
    EXPECT_NEAR(sum, 1, 1e-9);
    // Density 1 / (pi sqrt(1 - x^2)).
    for (std::size_t i = 5; i + 5 < curve.x.size(); ++i)
        EXPECT_NEAR(curve.y[i], 1 / (pi * std::sqrt(1 - curve.x[i] * curve.x[i])), 0.06) << curve.x[i];
}

TEST(NoiseCharts, SpectrumOfAWaveStandsAtItsFrequency)
{
    // A wave along every line: a function of the distance from the origin, far from it.
    const NoiseSample wave = [](const glm::dvec3& p) { return std::sin(2 * pi * 1.5 * glm::length(p + 1e6)); };
    const NoiseSample even = [](const glm::dvec3&) { return 0.3; };
    const ChartCurve curve = noiseSpectrum("wave", wave);
    EXPECT_LE(highestAt(curve), 1.6);
    EXPECT_NEAR(integral(curve), 1, 0.15);
    for (const double y : noiseSpectrum("even", even).y) EXPECT_EQ(y, 0);
    // Directions differ from the wave's, so that frequencies may be lower, but not higher.
    const double highest = *std::max_element(curve.y.begin(), curve.y.end());
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.x[i] > 1.7) {
            EXPECT_LT(curve.y[i], 0.01 * highest) << curve.x[i];
        }
    }
}

TEST(NoiseCharts, IsotropyShowsTheDirectionOfAWave)
{
    const ChartCurve curve = noiseIsotropy("wave", [](const glm::dvec3& p) { return std::sin(2 * pi * p.z); });
    EXPECT_NEAR(highestAt(curve), 90, 1e-9);
    EXPECT_NEAR(curve.y.front(), 0, 1e-9);
    EXPECT_NEAR(curve.y.back(), 0, 1e-9);
}

double spread(const ChartCurve& curve)
{
    const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
    return *high - *low;
}

TEST(NoiseCharts, ShowTheLatticeOfValueNoiseWhichSimplexHasNot)
{
    const NoiseTable table;
    ParameterValues values(table);
    values.set(table.work, NoiseWork::field);
    values.set(table.kind, NoiseKind::simplex);
    const std::vector<Chart> charts = noiseCharts(table, values);
    ASSERT_EQ(charts.size(), 3U);
    for (const Chart& chart : charts) ASSERT_EQ(chart.curves.size(), 2U) << chart.title;
    EXPECT_LT(spread(charts[2].curves[0]), 0.6 * spread(charts[2].curves[1]));
    // Value noise has waves of any length. Simplex noise has a band, but a line also shows longer ones.
    const auto lowest = [](const ChartCurve& c) { return c.y.front() / *std::max_element(c.y.begin(), c.y.end()); };
    EXPECT_LT(lowest(charts[1].curves[0]), 0.8);
    EXPECT_GT(lowest(charts[1].curves[1]), 0.9);
}

TEST(LongNoiseCharts, AreFiniteForEveryWorkAndThoseOfTheReferenceAreItsOwn)
{
    const NoiseTable table;
    for (int work = 0; work < 4; ++work) {
        ParameterValues values(table);
        values.set(table.work, static_cast<NoiseWork>(work));
        const std::vector<Chart> charts = noiseCharts(table, values);
        bool differ = false;
        for (const Chart& chart : charts) {
            for (const ChartCurve& curve : chart.curves) {
                ASSERT_EQ(curve.x.size(), curve.y.size());
                for (const double y : curve.y) ASSERT_TRUE(std::isfinite(y) && y >= 0) << chart.title << ' ' << work;
                EXPECT_TRUE(std::is_sorted(curve.x.begin(), curve.x.end()));
            }
            differ = differ || chart.curves[0].y != chart.curves[1].y;
        }
        EXPECT_TRUE(differ) << work;
        values.set(table.look, NoiseLook::reference);
        for (const Chart& chart : noiseCharts(table, values)) EXPECT_EQ(chart.curves[0].y, chart.curves[1].y);
    }
}

}  // namespace
}  // namespace vitrine::noise
