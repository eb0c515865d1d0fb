#include "render/image/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace vitrine::render;

TEST(Srgb, EveryCodeSurvivesARoundTrip)
{
    for (int i = 0; i < 256; ++i) EXPECT_EQ(srgb8FromLinear(static_cast<float>(linearFromSrgb(i / 255.0))), i);
    for (int i = 0; i < 65536; ++i) EXPECT_EQ(srgb16FromLinear(static_cast<float>(linearFromSrgb(i / 65535.0))), i);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(code8(static_cast<float>(i / 255.0)), i);
    for (int i = 0; i < 65536; ++i) EXPECT_EQ(code16(static_cast<float>(i / 65535.0)), i);
}

TEST(Srgb, RoundsToTheNearestCode)
{
    std::mt19937 random(3);
    for (int i = 0; i < 200'000; ++i) {
        const float x = std::uniform_real_distribution<float>(0, 1)(random);
        const double exact = 255 * srgbFromLinear(static_cast<double>(x));
        EXPECT_LE(std::abs(srgb8FromLinear(x) - exact), 0.5 + 1e-9);
    }
}

// IEC 61966-2-1: published pairs, to the digits given.
TEST(Srgb, AgreesWithTheStandard)
{
    EXPECT_NEAR(srgbFromLinear(0.18), 0.461356, 1e-6);
    EXPECT_NEAR(linearFromSrgb(0.5), 0.214041, 1e-6);
    EXPECT_DOUBLE_EQ(srgbFromLinear(1), 1);
    EXPECT_NEAR(linearFromSrgb(0.04045), 0.0031308, 1e-7);
}

TEST(Srgb, ClampsWhatCannotBeShown)
{
    EXPECT_EQ(srgb8FromLinear(-1), 0);
    EXPECT_EQ(srgb8FromLinear(7), 255);
    EXPECT_EQ(srgb8FromLinear(std::nanf("")), 0);
    EXPECT_EQ(srgb16FromLinear(INFINITY), 65535);
    EXPECT_EQ(code16(std::nanf("")), 0);
}

}  // namespace
