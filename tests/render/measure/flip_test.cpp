// Statements of the FLIP paper, and their consequences.

#include "render/measure/flip.h"
#include "render/measure/hdr_flip.h"
#include "tests/support/made_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vitrine {
namespace {

using test::made;
using namespace render;

Image evenNoise(unsigned seed)
{
    std::mt19937 random(seed);
    return made(40, 30, [&](int, int, int) { return std::uniform_real_distribution<float>(0, 1)(random); });
}

Image flat(float r, float g, float b)
{
    return made(48, 48, [=](int, int, int c) { return c == 0 ? r : c == 1 ? g : b; });
}

/// Returns stripes of a period around middle gray.
Image stripes(double amplitude, int period)
{
    return made(64, 64, [=](int x, int, int) {
        return static_cast<float>(0.5 + (x % period < period / 2 ? amplitude : -amplitude));
    });
}

TEST(Flip, IsZeroForEqualPictures)
{
    const Image a = evenNoise(1);
    EXPECT_EQ(flip(a, a), 0);
}

TEST(Flip, IsSymmetric)
{
    const Image a = evenNoise(1);
    const Image b = evenNoise(2);
    const Image there = flipMap(a, b);
    const Image back = flipMap(b, a);
    EXPECT_GT(flip(a, b), 0.1);
    for (std::size_t i = 0; i < there.pixels.size(); ++i) EXPECT_FLOAT_EQ(there.pixels[i], back.pixels[i]);
}

TEST(Flip, StaysBetweenZeroAndOne)
{
    for (unsigned seed = 1; seed < 5; ++seed) {
        Image wild = evenNoise(seed);
        for (float& p : wild.pixels) p = 20 * p - 10;
        const Image map = flipMap(evenNoise(seed + 10), wild);
        EXPECT_GE(*std::min_element(map.pixels.begin(), map.pixels.end()), 0);
        EXPECT_LE(*std::max_element(map.pixels.begin(), map.pixels.end()), 1);
    }
}

TEST(Flip, TheLargestDifferenceOfColorsIsThatOfGreenAndBlue)
{
    // The paper defines this as the top of the scale. Without features, the map is the color error.
    EXPECT_NEAR(flip(flat(0, 1, 0), flat(0, 0, 1)), 1, 1e-6);
    EXPECT_LT(flip(flat(0, 0, 0), flat(1, 1, 1)), 1);
}

TEST(Flip, BlackAndWhiteAreAsFarAsLightnessSays)
{
    // HyAB of black and white is 100, CIELAB's range of lightness. That of green and blue after Hunt's adjustment
    // follows from the published matrices: L 87.735 and 32.297; a -86.183 and 79.188, b 83.179 and -107.860 before
    // scaling by L / 100: 55.438 + |(-75.613 - 25.575, 72.977 + 34.836)| = 55.438 + 147.86.
    const double cmax = std::pow(55.438 + std::hypot(75.613 + 25.575, 72.977 + 34.836), 0.7);
    const double d = std::pow(100.0, 0.7);
    const double expected = 0.95 + (d - 0.4 * cmax) / (0.6 * cmax) * 0.05;
    EXPECT_NEAR(flip(flat(0, 0, 0), flat(1, 1, 1)), expected, 1e-4);
}

TEST(Flip, GrowsWithContrast)
{
    const Image reference = made(64, 64, [](int, int, int) { return 0.5F; });
    double last = 0;
    for (const double amplitude : {0.01, 0.03, 0.1, 0.3, 0.5}) {
        const double error = flip(reference, stripes(amplitude, 16));
        EXPECT_GT(error, last) << amplitude;
        last = error;
    }
}

TEST(Flip, WhatIsTooFineForTheEyeCountsLessTheFurtherItIs)
{
    const Image reference = made(64, 64, [](int, int, int) { return 0.5F; });
    EXPECT_GT(flip(reference, stripes(0.2, 2), 10), 2 * flip(reference, stripes(0.2, 2), 67));
}

TEST(Flip, AnEdgeThatIsMissingCountsMoreThanTheColorItLeaves)
{
    // The paper's reason for features: edges attract the eye. Far to the right, the color differs as much.
    const Image reference = made(96, 48, [](int, int, int) { return 0.4F; });
    const Image edge = made(96, 48, [](int x, int, int) { return x < 32 ? 0.4F : 0.5F; });
    const Image map = flipMap(reference, edge);
    const float far = map.at(90, 24);
    EXPECT_GT(far, 0.05F);
    EXPECT_GT(*std::max_element(map.pixels.begin(), map.pixels.end()), 1.2F * far);
    EXPECT_LT(map.at(5, 24), 1e-3F);
}

TEST(Flip, MirroringBothPicturesMirrorsTheMap)
{
    const auto mirrored = [](const Image& a) {
        return made(a.width, a.height, [&](int x, int y, int c) { return a.at(a.width - 1 - x, y, c); });
    };
    const Image a = evenNoise(3);
    const Image b = evenNoise(4);
    const Image map = flipMap(a, b);
    const Image turned = flipMap(mirrored(a), mirrored(b));
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) EXPECT_NEAR(map.at(x, y), turned.at(map.width - 1 - x, y), 1e-6);
}

/// Returns a row of `n` gray pixels, each brighter than the one before by a number of stops.
Image stops(int n, double first, double step = 1)
{
    return made(n, 1, [=](int x, int, int) { return static_cast<float>(std::exp2(first + step * x)); });
}

TEST(HdrFlip, ShowsTheBrightestAndTheMedianAtTheSameValueOfTheCurve)
{
    const std::vector<double> exposures = hdrFlipExposures(stops(17, -3, 0.9));
    // From the brightest pixel to the median, the ninth, there are 7.2 stops.
    ASSERT_EQ(exposures.size(), 8U);
    EXPECT_NEAR(exposures.back() - exposures.front(), 7.2, 1e-6);
    EXPECT_NEAR(hdrFlipToneCurve(std::exp2(exposures.front() - 3 + 16 * 0.9)), 0.85, 1e-6);
    EXPECT_NEAR(hdrFlipToneCurve(std::exp2(exposures.back() - 3 + 8 * 0.9)), 0.85, 1e-6);
    for (std::size_t i = 1; i < exposures.size(); ++i)
        EXPECT_NEAR(exposures[i] - exposures[i - 1], 7.2 / 7, 1e-6) << "at equal steps";
    // An even number of pixels: the median is between two.
    EXPECT_NEAR(hdrFlipToneCurve(1.5 * std::exp2(hdrFlipExposures(stops(2, 0)).back())), 0.85, 1e-6);
    EXPECT_EQ(hdrFlipExposures(Image(4, 4, 3, 0.5F)).size(), 2U) << "at least two";
}

TEST(HdrFlip, TheCurveIsThePublishedOne)
{
    // Narkowicz 2016: (x (2.51 x + 0.03)) / (x (2.43 x + 0.59) + 0.14), of light times 0.6.
    for (const double light : {0.0, 0.01, 0.18, 1.0, 4.0}) {
        const double x = 0.6 * light;
        EXPECT_NEAR(hdrFlipToneCurve(light), std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0),
                    1e-12);
    }
    EXPECT_EQ(hdrFlipToneCurve(1e6), 1);
}

TEST(HdrFlip, IsTheLargestErrorOfAllExposures)
{
    const Image reference = stops(24, -12);
    Image test = reference;
    for (const int x : {1, 12, 22})
        for (int c = 0; c < 3; ++c) test.at(x, 0, c) *= 1.5F;
    const Image map = hdrFlipMap(reference, test);
    std::vector<float> largest(24, 0);
    for (const double exposure : hdrFlipExposures(reference)) {
        const auto shown = [&](const Image& image) {
            return made(24, 1, [&](int x, int, int) {
                const double light = std::exp2(exposure) * static_cast<double>(image.at(x, 0));
                return static_cast<float>(hdrFlipToneCurve(light));
            });
        };
        const Image one = flipMap(shown(reference), shown(test));
        for (std::size_t x = 0; x < 24; ++x) largest[x] = std::max(largest[x], one.pixels[x]);
    }
    for (std::size_t x = 0; x < 24; ++x) EXPECT_NEAR(map.pixels[x], largest[x], 1e-5) << x;
    // LDR-FLIP sees nothing beyond 1; this does.
    EXPECT_LT(flipMap(reference, test).at(22, 0), 1e-6);
    EXPECT_GT(map.at(22, 0), 0.05);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfLight)
{
    const Image reference = stops(24, -12);
    Image test = reference;
    for (int c = 0; c < 3; ++c) test.at(12, 0, c) *= 2;
    const auto scaled = [](Image image) {
        for (float& x : image.pixels) x *= 16;
        return image;
    };
    EXPECT_NEAR(hdrFlip(reference, test), hdrFlip(scaled(reference), scaled(test)), 1e-6);
    EXPECT_EQ(hdrFlip(reference, reference), 0);
    EXPECT_EQ(hdrFlip(Image(4, 4, 3), Image(4, 4, 3)), 0) << "black";
    Image broken(4, 4, 3, 0.5F);
    broken.at(0, 0, 0) = NAN;
    broken.at(1, 0, 1) = INFINITY;
    broken.at(2, 0, 2) = -1;
    const double error = hdrFlip(broken, Image(4, 4, 3, 0.5F));
    EXPECT_TRUE(error > 0 && error <= 1) << error;
}

}  // namespace
}  // namespace vitrine
