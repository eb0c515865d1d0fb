// Morphing from one setting to another: each kind of parameter has its own interpolation, and stays in its range.

#include "exhibits/framework/table/morph.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/random_values.h"
#include "render/image/oklab.h"
#include "render/image/srgb.h"
#include "tests/support/balls.h"
#include "tests/support/degree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

using test::degree;

struct MorphTable final : Parameters {
    Group group1 = group("All");
    Real width = real("width", 2, meter, {1, 9}, "Even.");
    Real radius = real("radius", 1, meter, {0.01, 100, logarithmic}, "By factors.");
    Real azimuth = real("azimuth", 0, degree, {degrees(-180), degrees(180)}, "A full turn.");
    Real tilt = real("tilt", 0, degree, {degrees(-90), degrees(90)}, "Half of one.");
    Count steps = count("steps", 4, {1, 64, logarithmic}, "By factors, whole.");
    Count sides = count("sides", 0, {0, 9}, "0 chooses.", reads(0, "auto"));
    Toggle lit = toggle("lit", false, "Switched.");
    Choice<int> method = choice("method", 0, {"rough", "fair", "exact"}, "Switched.");
    Color color = this->Parameters::color("color", {1, 0, 0}, "In Oklab.");
    Direction axis = direction("axis", {1, 0, 0}, "On a great circle.");
    File file = this->Parameters::file("file", "Switched.");
};

struct Ends {
    MorphTable table;
    ParameterValues a = table.initial(), b = table.initial();

    template <typename Handle> [[nodiscard]] double number(Handle row, double t) const
    {
        return std::get<double>(morphed(a, b, t).row(row.row));
    }
};

TEST(Morphing, NumbersGoEvenlyAndLogarithmicOnesByFactors)
{
    Ends ends;
    ends.b.set(ends.table.width, 6.0);
    ends.b.set(ends.table.radius, 100.0);
    ends.b.set(ends.table.steps, 64);
    EXPECT_DOUBLE_EQ(ends.number(ends.table.width, 0.25), 3);
    EXPECT_NEAR(ends.number(ends.table.radius, 0.5), 10, 1e-12) << "halfway between 1 and 100 by factors";
    EXPECT_EQ(ends.number(ends.table.steps, 0.5), 16);
    EXPECT_EQ(ends.number(ends.table.steps, 0.3), std::round(4 * std::pow(16, 0.3)));
}

TEST(Morphing, AnglesOfAFullTurnGoTheShorterWay)
{
    Ends ends;
    ends.a.set(ends.table.azimuth, 170 * degree);
    ends.b.set(ends.table.azimuth, -170 * degree);
    EXPECT_NEAR(ends.number(ends.table.azimuth, 0.25), 175 * degree, 1e-12);
    EXPECT_NEAR(ends.number(ends.table.azimuth, 0.75), -175 * degree, 1e-12);
    ends.a.set(ends.table.tilt, 80 * degree);
    ends.b.set(ends.table.tilt, -80 * degree);
    EXPECT_NEAR(ends.number(ends.table.tilt, 0.5), 0, 1e-12) << "what is no full turn has no other way";
}

TEST(Morphing, WhatHasNothingBetweenIsSwitchedInTheMiddle)
{
    Ends ends;
    ends.b.set(ends.table.lit, true);
    ends.b.set(ends.table.method, 2);
    ends.b.set(ends.table.sides, 8);
    ends.b.set(ends.table.file, std::string("b.glb"));
    for (const double t : {0.01, 0.49}) {
        EXPECT_EQ(ends.number(ends.table.lit, t), 0);
        EXPECT_EQ(ends.number(ends.table.method, t), 0);
        EXPECT_EQ(ends.number(ends.table.sides, t), 0) << "\"auto\" is no number";
        EXPECT_EQ(morphed(ends.a, ends.b, t)[ends.table.file], "");
    }
    for (const double t : {0.5, 0.99}) {
        EXPECT_EQ(ends.number(ends.table.lit, t), 1);
        EXPECT_EQ(ends.number(ends.table.method, t), 2) << "never a choice between";
        EXPECT_EQ(ends.number(ends.table.sides, t), 8);
        EXPECT_EQ(morphed(ends.a, ends.b, t)[ends.table.file], "b.glb");
    }
    ends.a.set(ends.table.sides, 2);
    EXPECT_EQ(ends.number(ends.table.sides, 0.5), 5) << "two numbers have others between them";
}

TEST(Morphing, ColorsGoStraightInOklab)
{
    Ends ends;
    ends.b.set(ends.table.color, ColorValue{{0, 0, 1}});
    const glm::dvec3 red = render::oklabFromLinear({1, 0, 0}), blue = render::oklabFromLinear({0, 0, 1});
    const glm::dvec3 middle = morphed(ends.a, ends.b, 0.5)[ends.table.color].value;
    EXPECT_LT(glm::distance(render::oklabFromLinear(middle), 0.5 * (red + blue)), 1e-9);
    EXPECT_GT(glm::distance(middle, glm::dvec3(0.5, 0, 0.5)), 0.1) << "which the mean of the light is not";
}

TEST(Morphing, OklabIsThePublishedOne)
{
    // Pairs of XYZ and Oklab published by Ottosson: white, and the red of sRGB by its primaries.
    const glm::dvec3 white = render::oklabFromLinear({1, 1, 1}), red = render::oklabFromLinear({1, 0, 0});
    EXPECT_LT(glm::distance(white, glm::dvec3(1, 0, 0)), 1e-6);
    EXPECT_LT(glm::distance(red, glm::dvec3(0.627955, 0.224863, 0.125846)), 1e-5);
    RandomNumbers random(1);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 linear = random.point(glm::dvec3(0), glm::dvec3(1));
        EXPECT_LT(glm::distance(render::linearFromOklab(render::oklabFromLinear(linear)), linear), 1e-12);
    }
}

TEST(Morphing, DirectionsKeepTheirLengthAndGoAtAnEvenPace)
{
    Ends ends;
    for (const glm::dvec3& to : {glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0.6, 0, -0.8)}) {
        ends.b.set(ends.table.axis, DirectionValue{to});
        const auto at = [&](double t) { return morphed(ends.a, ends.b, t)[ends.table.axis].value; };
        const double whole = std::acos(std::clamp(glm::dot(at(0), to), -1.0, 1.0));
        for (int i = 1; i <= 10; ++i) {
            EXPECT_NEAR(glm::length(at(0.1 * i)), 1, 1e-12);
            EXPECT_NEAR(std::acos(std::clamp(glm::dot(at(0.1 * i), at(0.1 * (i - 1))), -1.0, 1.0)), whole / 10, 1e-6);
        }
    }
}

TEST(Morphing, EndsAtExactlyTheTwo)
{
    RandomNumbers random(7);
    const MorphTable table;
    for (int i = 0; i < 20; ++i) {
        const ParameterValues a = randomValues(table, random), b = randomValues(table, random);
        EXPECT_TRUE(morphed(a, b, 0) == a);
        EXPECT_TRUE(morphed(a, b, 1) == b);
        EXPECT_TRUE(morphed(a, a, 0.3) == a);
        EXPECT_FALSE(morphed(a, b, 0.4) == b) << "a control: halfway is neither";
    }
}

TEST(Morphing, OfEveryExhibitNeverLeavesARange)
{
    RandomNumbers random(11);
    for (const auto& exhibit : allExhibits()) {
        const Parameters& table = exhibit->parameters();
        for (int i = 0; i < 10; ++i) {
            const ParameterValues a = randomValues(table, random), b = randomValues(table, random);
            for (const double t : {1e-9, 0.2, 0.5, 0.7, 1 - 1e-9})
                for (std::size_t row = 0; row < table.rows().size(); ++row) {
                    const ParameterInfo& info = table.rows()[row];
                    const Value value = morphed(info, a.row(row), b.row(row), t);
                    // Only the last bits of colors and unit vectors may be corrected.
                    const std::optional<Value> legal = nearestLegal(info, value);
                    ASSERT_TRUE(legal) << exhibit->name() << '.' << info.name;
                    if (info.kind == Kind::direction || info.kind == Kind::color)
                        EXPECT_LT(glm::distance(std::get<glm::dvec3>(*legal), std::get<glm::dvec3>(value)), 1e-9);
                    else
                        EXPECT_TRUE(*legal == value) << exhibit->name() << '.' << info.name << " at " << t;
                }
        }
    }
}

TEST(Morphing, AmongSeveralAWordIsNoNumber)
{
    const MorphTable table;
    const ParameterInfo& sides = table.rows()[table.sides.row];
    const std::vector<Value> values{0.0, 2.0, 6.0};
    EXPECT_EQ(morphed(sides, values, std::array{0.5, 0.25, 0.25}), Value(0.0)) << "\"auto\" weighs most";
    EXPECT_EQ(morphed(sides, values, std::array{0.2, 0.6, 0.2}), Value(3.0)) << "a quarter of the way from 2 to 6";
    EXPECT_EQ(morphed(sides, values, std::array{0.0, 0.5, 0.5}), Value(4.0));
}

TEST(Morphing, AmongFourDirectionsIsTheirMeanOnTheSphere)
{
    const MorphTable table;
    const ParameterInfo& axis = table.rows()[table.axis.row];
    const auto about = [](double degrees, double azimuth) {
        const double polar = degrees * degree;
        return Value(
            glm::dvec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)));
    };
    const double quarter = std::numbers::pi / 2;
    const std::vector<Value> four{about(80, 0), about(80, quarter), about(80, 2 * quarter), about(80, 3 * quarter)};
    const auto middle = std::get<glm::dvec3>(morphed(axis, four, std::array{0.25, 0.25, 0.25, 0.25}));
    EXPECT_LT(glm::distance(middle, glm::dvec3(0, 0, 1)), 1e-12) << "four about an axis have it as their mean";
    // The mean is the point from which the vectors to all of them cancel. Along a great circle it equals the mean of
    // numbers.
    const std::vector<Value> three{about(0, 0), about(30, 0), about(75, 0)};
    const auto along = std::get<glm::dvec3>(morphed(axis, three, std::array{0.2, 0.5, 0.3}));
    EXPECT_LT(glm::distance(along, std::get<glm::dvec3>(about(0.5 * 30 + 0.3 * 75, 0))), 1e-12);
}

TEST(Morphing, RowsThatMoveAlikeAreMorphedAtBothEndsAndOthersAsTheNearest)
{
    Ends ends;
    const std::size_t width = ends.table.width.row;
    Motion motion{MotionKind::sine, 2.0, 4.0};
    ends.a.setMotion(width, motion);
    motion.from = 4.0;
    motion.to = 8.0;
    ends.b.setMotion(width, motion);
    const ParameterValues between = morphed(ends.a, ends.b, 0.25);
    EXPECT_EQ(between.motion(width)->from, Value(2.5));
    EXPECT_EQ(between.motion(width)->to, Value(5.0));
    motion.period = 9;
    ends.b.setMotion(width, motion);
    EXPECT_EQ(morphed(ends.a, ends.b, 0.25).motion(width)->to, Value(4.0));
    EXPECT_EQ(morphed(ends.a, ends.b, 0.75).motion(width)->to, Value(8.0));
    ends.b.setMotion(width, std::nullopt);
    EXPECT_TRUE(morphed(ends.a, ends.b, 0.25).motion(width));
    EXPECT_FALSE(morphed(ends.a, ends.b, 0.75).motion(width));
}

TEST(Morphing, BetweenTablesOfTwoFilesTakesTheNearerOne)
{
    const test::BallTable two({{"red", 1}, {"blue", 2}}), other({{"blue", 4}, {"green", 3}});
    const ParameterValues a = two.initial(), b = other.initial();
    EXPECT_EQ(test::parameterOf(morphed(a, b, 0.25), "blueRadius"), Value(2.5));
    EXPECT_EQ(test::parameterOf(morphed(a, b, 0.25), "redRadius"), Value(1.0));
    EXPECT_FALSE(test::parameterOf(morphed(a, b, 0.25), "greenRadius"));
    EXPECT_EQ(test::parameterOf(morphed(a, b, 0.75), "greenRadius"), Value(3.0));
    EXPECT_EQ(test::parameterOf(morphed(a, b, 0.75), "blueRadius"), Value(3.5));
}

TEST(Variation, StaysWithinTheComfortableRangesOfEveryExhibit)
{
    for (const auto& exhibit : allExhibits()) {
        const ParameterValues from = exhibit->parameters().initial();
        std::size_t changed = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const ParameterValues varied = variation(from, seed, [](std::size_t) { return false; });
            for (std::size_t i = 0; i < from.rows().size(); ++i) {
                const ParameterInfo& row = from.rows()[i];
                if (row.isWritten() || row.qualityReference)
                    EXPECT_TRUE(varied.row(i) == from.row(i)) << exhibit->name() << '.' << row.name;
                else if (row.isNumeric()) {
                    EXPECT_GE(std::get<double>(varied.row(i)), row.range.softLow) << row.name;
                    EXPECT_LE(std::get<double>(varied.row(i)), row.range.softHigh) << row.name;
                }
                changed += varied.row(i) == from.row(i) ? 0 : 1;
            }
        }
        EXPECT_GT(changed, 20U) << exhibit->name();
    }
}

TEST(Variation, GoesSoFarAsItsStrengthSays)
{
    const MorphTable table;
    const ParameterValues from = table.initial();
    const auto none = [](std::size_t) { return false; };
    EXPECT_TRUE(variation(from, 3, none, 0) == from);
    int switched = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const ParameterValues whole = variation(from, seed, none), part = variation(from, seed, none, 0.25);
        const auto number = [](const ParameterValues& values, auto row) {
            return std::get<double>(values.row(row.row));
        };
        EXPECT_NEAR(number(part, table.width) - 2, 0.25 * (number(whole, table.width) - 2), 1e-12);
        EXPECT_NEAR(std::log(number(part, table.radius)), 0.25 * std::log(number(whole, table.radius)), 1e-12);
        const double method = number(part, table.method);
        EXPECT_TRUE(method == 0 || method == number(whole, table.method)) << "nothing lies between choices";
        switched += method != 0 ? 1 : 0;
    }
    EXPECT_NEAR(switched, 200 * 0.25 * 2 / 3, 15) << "a quarter of the time, and to another one in two of three";
}

TEST(Variation, IsTheSameForASeedAndALockMovesNoOtherParameter)
{
    const MorphTable table;
    const ParameterValues from = table.initial();
    const auto none = [](std::size_t) { return false; };
    const ParameterValues once = variation(from, 5, none);
    EXPECT_TRUE(once == variation(from, 5, none));
    EXPECT_FALSE(once == variation(from, 6, none));
    const ParameterValues locked = variation(from, 5, [&](std::size_t row) { return row == table.radius.row; });
    for (std::size_t i = 0; i < from.rows().size(); ++i)
        EXPECT_TRUE(locked.row(i) == (i == table.radius.row ? from : once).row(i)) << from.rows()[i].name;
    EXPECT_FALSE(once.row(table.radius.row) == from.row(table.radius.row)) << "a control: unlocked it moves";
}

}  // namespace
}  // namespace vitrine
