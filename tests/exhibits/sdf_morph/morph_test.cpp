// Morphing between torus and mug over time, and the bounds in between.

#include "exhibits/sdf_morph/sdf_morph.h"
#include "tests/support/tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vitrine::sdf_morph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Morph, StartsWhereTheSliderStands)
{
    for (const double morph : {0.0, 0.1, 1.0 / 3, 0.62, 1.0}) EXPECT_EQ(morphAt(morph, 0.08, 0), morph);
}

TEST(Morph, IsTheSameAfterEveryPeriodEvenAfterThirtyYears)
{
    // With a frequency of 1/8 Hz the period is exactly 8 s; 1e9 s are 125 million periods.
    for (const double morph : {0.0, 0.25, 0.625, 1.0})
        for (const double time : {0.0, 0.5, 1.0, 3.25, 7.75})
            for (const double start : {1e6, 1e9, -1e6})
                EXPECT_EQ(morphAt(morph, 0.125, start + time), morphAt(morph, 0.125, time)) << morph << ' ' << time;
    EXPECT_NE(morphAt(0.25, 0.125, 1e6 + 1), morphAt(0.25, 0.125, 1e6 + 2));
}

TEST(Morph, MovesSteadilyAndStaysBetweenTheShapes)
{
    for (const double start : {0.0, 1e6, 1e9}) {
        double last = morphAt(0.62, 0.5, start);
        for (int i = 1; i <= 4000; ++i) {
            const double now = morphAt(0.62, 0.5, start + i * 1e-3);
            EXPECT_GE(now, 0);
            EXPECT_LE(now, 1);
            EXPECT_NEAR(std::abs(now - last), 1e-3,
                        1e-3 + 1e-6);  // Twice the speed times a millisecond, less at a turn.
            last = now;
        }
    }
}

TEST(Morph, HostileTimesAreTheSlider)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double time : {nan, infinity, -infinity}) EXPECT_EQ(morphAt(0.62, 0.08, time), 0.62);
    for (const double time : {1e300, -1e300, 1e-310}) {
        EXPECT_GE(morphAt(0.62, 10, time), 0);
        EXPECT_LE(morphAt(0.62, 10, time), 1);
    }
}

TEST(SdfMorphBounds, HoldTheShapeAtEveryTimeOfItsMelt)
{
    SdfMorph exhibit;
    ParameterValues values = exhibit.parameters().initial();
    values.set(test::sdfTable().animate, true);
    const render::Box all = exhibit.bounds(values);
    for (int i = 0; i <= 40; ++i) {
        ParameterValues still = exhibit.parameters().initial();
        still.set(test::sdfTable().morph, i / 40.0);
        const render::Box one = exhibit.bounds(still);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(all.low, one.low + 1e-12)) &&
                    glm::all(glm::greaterThanEqual(all.high, one.high - 1e-12)))
            << i;
    }
}

}  // namespace
}  // namespace vitrine::sdf_morph
