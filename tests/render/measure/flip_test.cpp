// Statements of the FLIP paper, and their consequences.

#include "render/measure/flip.h"
#include "tests/support/made_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

}  // namespace
}  // namespace vitrine
