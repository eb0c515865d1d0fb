// Differences of pictures, compared with values computed by hand.

#include "render/measure/distance.h"

#include "render/image/srgb.h"
#include "render/measure/structure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace vitrine {
namespace {

using namespace render;

Image noiseBetween(int channels, unsigned seed, double low = 0, double high = 1)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(low, high);
    Image image(64, 48, channels);
    for (float& p : image.pixels) p = static_cast<float>(uniform(random));
    return image;
}

Image plus(Image image, float offset)
{
    for (float& p : image.pixels) p += offset;
    return image;
}

TEST(Metrics, EqualPicturesAreAtDistanceZero)
{
    const Image a = noiseBetween(3, 1);
    const ColorDifference d = colorDifference(a, a);
    EXPECT_EQ(d.rmse, 0);
    EXPECT_EQ(d.max, 0);
    EXPECT_EQ(d.beyond, 0);
    EXPECT_EQ(d.psnr(), std::numeric_limits<double>::infinity());
}

TEST(Metrics, AConstantOffsetIsTheRmsError)
{
    const Image a = noiseBetween(3, 1, 0.25, 0.5);
    const ColorDifference d = colorDifference(a, plus(a, 0.125F));
    EXPECT_NEAR(d.rmse, 0.125, 1e-7);
    EXPECT_NEAR(d.max, 0.125, 1e-7);
    EXPECT_NEAR(d.psnr(), 20 * std::log10(8.0), 1e-5);
    EXPECT_EQ(d.beyond, 1);
}

TEST(Metrics, UniformNoiseHasTheRmsErrorOfItsVariance)
{
    const Image a(64, 48, 3, 0.5F);
    Image b = a;
    const Image n = noiseBetween(3, 7, -0.1, 0.1);
    for (std::size_t i = 0; i < b.pixels.size(); ++i) b.pixels[i] += n.pixels[i];
    // The variance of a uniform distribution over 0.2 is 0.2² / 12. With 9216 samples the estimate has a spread of 0.5
    // %.
    EXPECT_NEAR(colorDifference(a, b).rmse, 0.2 / std::sqrt(12.0), 0.02 * 0.2 / std::sqrt(12.0));
}

TEST(Metrics, OneCodeOfSrgbIsTheThresholdOfWhatIsBeyond)
{
    const auto pictureOf = [](double code) { return Image(4, 4, 3, static_cast<float>(linearFromSrgb(code / 255))); };
    EXPECT_EQ(colorDifference(pictureOf(100), pictureOf(100.99)).beyond, 0);
    EXPECT_EQ(colorDifference(pictureOf(100), pictureOf(101.01)).beyond, 1);
    EXPECT_EQ(colorDifference(pictureOf(3), pictureOf(4.01)).beyond, 1)
        << "in the dark, where a linear threshold would miss it";
    Image one = pictureOf(100);
    one.at(1, 2, 2) = 1;
    EXPECT_EQ(colorDifference(pictureOf(100), one).beyond, 1.0 / 16);
}

TEST(Metrics, TheColorOfWhatIsNotThereCountsNothing)
{
    Image a(2, 1, 4, 0.0F);
    Image b(2, 1, 4, 0.0F);
    b.at(0, 0, 0) = 0.9F;
    EXPECT_EQ(colorDifference(a, b).max, 0);
    b.at(0, 0, 3) = 0.5F;
    EXPECT_NEAR(colorDifference(a, b).max, 0.45, 1e-7);
}

TEST(Metrics, WhatIsFiniteInOnePictureOnlyIsInfinitelyFar)
{
    Image a(2, 1, 3, 0.5F);
    Image b = a;
    b.at(0, 0, 1) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(colorDifference(a, b).max, std::numeric_limits<double>::infinity());
    EXPECT_EQ(colorDifference(a, b).beyond, 0.5);
    EXPECT_EQ(colorDifference(b, b).rmse, 0);
}

TEST(Metrics, NormalsTurnedByAnAngleAreThatFarApart)
{
    Image a(3, 1, 3, 0.0F);
    Image b(3, 1, 3, 0.0F);
    const double angle = 1e-4;  // An arc cosine of floats would be 0 here.
    a.at(0, 0, 2) = 1;
    b.at(0, 0, 2) = static_cast<float>(std::cos(angle));
    b.at(0, 0, 0) = static_cast<float>(std::sin(angle));
    a.at(1, 0, 1) = 1;
    const NormalDifference d = normalDifference(a, b, 0);
    EXPECT_NEAR(d.mean, angle * 180 / std::numbers::pi, 1e-9);
    EXPECT_EQ(d.missing, 0.5);
}

TEST(Metrics, DepthsAreComparedWhereBothHitSomething)
{
    const float none = std::numeric_limits<float>::infinity();
    Image a(4, 1, 1, none);
    Image b(4, 1, 1, none);
    a.at(0, 0) = 2;
    b.at(0, 0) = 2.5;
    a.at(1, 0) = 3;
    b.at(1, 0) = 3;
    a.at(2, 0) = 7;
    const DepthDifference d = depthDifference(a, b, 0);
    EXPECT_NEAR(d.rms, std::sqrt(0.25 / 2), 1e-12);
    EXPECT_EQ(d.max, 0.5);
    EXPECT_NEAR(d.missing, 1.0 / 3, 1e-12);
}

TEST(Metrics, RelativeErrorsAreThoseOfTheFormulas)
{
    Image a(2, 1, 3, 0.5F), b = a;
    b.at(0, 0, 1) = 0.75F;
    a.at(1, 0, 2) = 0;
    b.at(1, 0, 2) = 0.01F;
    const ColorDifference d = colorDifference(a, b);
    EXPECT_NEAR(d.mape, (0.25 / 0.51 + 0.01 / 0.01) / 6, 1e-7);
    EXPECT_NEAR(d.relativeMse, (0.0625 / 0.26 + 0.0001 / 0.01) / 6, 1e-8);
    const Image map = relativeDifferenceMap(a, b);
    EXPECT_NEAR(map.at(0, 0), 0.25 / 0.51 / 3, 1e-6);
    EXPECT_NEAR(map.at(1, 0), 1.0 / 3, 1e-6);
    a.at(0, 0, 0) = std::numeric_limits<float>::infinity();
    EXPECT_EQ(colorDifference(a, b).mape, std::numeric_limits<double>::infinity());
    b.at(0, 0, 0) = std::numeric_limits<float>::infinity();
    EXPECT_NEAR(colorDifference(a, b).mape, d.mape, 1e-7) << "equal infinities are no difference";
}

/// Structural similarity as in the paper, written out for one pixel: sums over the window of 11 x 11.
double similarityAt(const Image& a, const Image& b, int x, int y)
{
    double all = 0, meanA = 0, meanB = 0;
    const auto eachInWindow = [&](const auto& visit) {
        for (int v = y - 5; v <= y + 5; ++v)
            for (int u = x - 5; u <= x + 5; ++u)
                visit(std::exp(-(std::pow(u - x, 2) + std::pow(v - y, 2)) / (2 * 1.5 * 1.5)),
                      srgbFromLinear(a.at(u, v)), srgbFromLinear(b.at(u, v)));
    };
    eachInWindow([&](double w, double p, double q) {
        all += w;
        meanA += w * p;
        meanB += w * q;
    });
    meanA /= all;
    meanB /= all;
    double varianceA = 0, varianceB = 0, covariance = 0;
    eachInWindow([&](double w, double p, double q) {
        varianceA += w / all * (p - meanA) * (p - meanA);
        varianceB += w / all * (q - meanB) * (q - meanB);
        covariance += w / all * (p - meanA) * (q - meanB);
    });
    return (2 * meanA * meanB + 1e-4) * (2 * covariance + 9e-4) /
           ((meanA * meanA + meanB * meanB + 1e-4) * (varianceA + varianceB + 9e-4));
}

TEST(Metrics, DissimilarityIsThatOfThePaper)
{
    const Image a = noiseBetween(1, 3), b = noiseBetween(1, 4, 0.2, 0.9);
    const Image map = dissimilarityMap(a, b);
    double sum = 0;
    int count = 0;
    for (int y = 5; y < a.height - 5; ++y)
        for (int x = 5; x < a.width - 5; ++x) {
            const double expected = (1 - similarityAt(a, b, x, y)) / 2;
            ASSERT_NEAR(map.at(x, y), expected, 1e-6) << x << ' ' << y;
            sum += expected;
            ++count;
        }
    EXPECT_NEAR(dissimilarity(a, b), sum / count, 1e-6);
    EXPECT_EQ(dissimilarity(a, a), 0);
    // Two even grays: the variances are 0.
    const Image dark(16, 16, 3, static_cast<float>(linearFromSrgb(0.2)));
    const Image light(16, 16, 3, static_cast<float>(linearFromSrgb(0.6)));
    EXPECT_NEAR(dissimilarity(dark, light), 0.5 - 0.5 * (2 * 0.12 + 1e-4) / (0.04 + 0.36 + 1e-4), 1e-6);
    EXPECT_GT(dissimilarity(Image(3, 2, 3, 0.1F), Image(3, 2, 3, 0.9F)), 0.05) << "smaller than the window";
    Image broken = a;
    broken.at(30, 20) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_GT(dissimilarityMap(a, broken).at(30, 20), 0);
    EXPECT_EQ(dissimilarity(broken, broken), 0);
}

TEST(Metrics, EveryNameNamesItsMetric)
{
    for (const MetricInfo& m : allMetrics()) {
        EXPECT_EQ(metricNamed(m.name), m.metric);
        EXPECT_EQ(&metricInfo(m.metric), &m);
        EXPECT_FALSE(m.title.empty());
    }
    EXPECT_FALSE(metricNamed("likeness"));
}

TEST(Metrics, AHeatMapGrowsLighterWithTheError)
{
    Image errors(5, 1, 1);
    for (int x = 0; x < 5; ++x) errors.at(x, 0) = 0.1F * static_cast<float>(x);
    const Image map = heatMap(errors, 0.4);
    const auto light = [&](int x) {
        return 0.2126 * map.at(x, 0, 0) + 0.7152 * map.at(x, 0, 1) + 0.0722 * map.at(x, 0, 2);
    };
    EXPECT_LT(light(0), 0.01);
    for (int x = 1; x < 5; ++x) EXPECT_GT(light(x), light(x - 1));
    EXPECT_GT(light(4), 0.9);
}

TEST(SignedDifference, IsGrayWhereEqualAndHalfTheDifferenceOfTheCodesTimesTheGain)
{
    Image a(4, 1, 3, static_cast<float>(linearFromSrgb(0.5)));
    Image b = a;
    b.at(1, 0, 0) = static_cast<float>(linearFromSrgb(0.6));
    b.at(2, 0, 1) = static_cast<float>(linearFromSrgb(0.45));
    b.at(3, 0, 2) = 1;
    const auto code = [](const Image& image, int x, int c) { return srgbFromLinear(image.at(x, 0, c)); };
    const Image once = signedDifference(a, b, 1), fourTimes = signedDifference(a, b, 4);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(code(once, 0, c), 0.5, 1e-6);
    EXPECT_NEAR(code(once, 1, 0), 0.55, 1e-6);
    EXPECT_NEAR(code(once, 1, 1), 0.5, 1e-6) << "the other components are equal";
    EXPECT_NEAR(code(once, 2, 1), 0.475, 1e-6);
    EXPECT_NEAR(code(fourTimes, 1, 0), 0.7, 1e-6);
    EXPECT_NEAR(code(fourTimes, 2, 1), 0.4, 1e-6);
    EXPECT_NEAR(code(fourTimes, 3, 2), 1, 1e-6) << "clamped";
    EXPECT_NEAR(code(signedDifference(b, a, 1), 1, 0), 0.45, 1e-6) << "the other way round";
}

TEST(Metrics, ErrorsOfViewsBecomeOneAsTheirMetricSays)
{
    const std::vector<double> errors{0.1, 0.2, 0.4};
    EXPECT_NEAR(pooledError(Metric::rmse, errors), std::sqrt((0.01 + 0.04 + 0.16) / 3), 1e-15);
    EXPECT_EQ(pooledError(Metric::max, errors), 0.4);
    for (const Metric mean :
         {Metric::beyond, Metric::mape, Metric::dssim, Metric::flip, Metric::hdrflip, Metric::normal, Metric::depth})
        EXPECT_NEAR(pooledError(mean, errors), 0.7 / 3, 1e-15);
    for (const MetricInfo& m : allMetrics()) EXPECT_EQ(pooledError(m.metric, {}), 0) << m.name;
}

TEST(Metrics, DistancesHaveEveryMetricWhoseChannelsThereAre)
{
    const Image a(8, 8, 3, 0.25F), b(8, 8, 3, 0.375F);
    const std::map<Metric, double> found = distances({a, b, flipPixelsPerDegree});
    EXPECT_EQ(found.size(), 8U);
    for (const MetricInfo& m : allMetrics()) {
        EXPECT_EQ(found.contains(m.metric), m.ofColor && !m.ofHighRange) << m.name;
        if (!found.contains(m.metric)) continue;
        EXPECT_EQ(found.at(m.metric), distance(m.metric, a, b)) << m.name;
    }
    EXPECT_NEAR(found.at(Metric::rmse), 0.125, 1e-7);
    const Image bright(8, 8, 3, 1.5F);
    EXPECT_EQ(distances({bright, b, flipPixelsPerDegree}).at(Metric::hdrflip), distance(Metric::hdrflip, bright, b));
    EXPECT_TRUE(distances({b, bright, flipPixelsPerDegree}).contains(Metric::hdrflip));
}

}  // namespace
}  // namespace vitrine
