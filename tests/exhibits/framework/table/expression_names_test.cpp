// Expressions with names and functions.

#include "exhibits/framework/table/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

std::optional<double> with(std::string_view text, Unit unit)
{
    return evaluate(text, unit, [](std::string_view name) -> std::optional<NamedValue> {
        if (name == "t") return NamedValue{2, Unit::none};
        if (name == "gap") return NamedValue{0.25, Unit::meter};
        if (name == "lean_2") return NamedValue{std::numbers::pi / 6, Unit::degree};
        return std::nullopt;
    });
}

TEST(ExpressionNames, StandForValuesWithTheirUnits)
{
    EXPECT_DOUBLE_EQ(with("gap", Unit::meter).value(), 0.25);
    EXPECT_DOUBLE_EQ(with("gap + 5cm", Unit::meter).value(), 0.3);
    EXPECT_DOUBLE_EQ(with("gap + 1", Unit::meter).value(), 1.25);
    EXPECT_DOUBLE_EQ(with("gap / 1cm", Unit::none).value(), 25);
    EXPECT_DOUBLE_EQ(with("90 * t", Unit::degree).value(), std::numbers::pi);
    EXPECT_DOUBLE_EQ(with("2 * lean_2", Unit::degree).value(), std::numbers::pi / 3);
    EXPECT_FALSE(with("gap", Unit::degree));
    EXPECT_FALSE(with("other", Unit::none));
    EXPECT_FALSE(evaluate("gap", Unit::meter));
}

TEST(ExpressionNames, FunctionsTakeWhatTheyMean)
{
    EXPECT_DOUBLE_EQ(with("sin(30 deg)", Unit::none).value(), 0.5);
    EXPECT_DOUBLE_EQ(with("sin(lean_2)", Unit::none).value(), 0.5);
    EXPECT_DOUBLE_EQ(with("cos(pi)", Unit::none).value(), -1);
    EXPECT_DOUBLE_EQ(with("sqrt(16) + abs(-2)", Unit::none).value(), 6);
    EXPECT_DOUBLE_EQ(with("max(gap, 30 cm)", Unit::meter).value(), 0.3);
    EXPECT_DOUBLE_EQ(with("min(gap, 1)", Unit::meter).value(), 0.25);
    EXPECT_DOUBLE_EQ(with("mod(-1, 3)", Unit::none).value(), 2);
    EXPECT_DOUBLE_EQ(with("clamp(5, 0, 1)", Unit::none).value(), 1);
    EXPECT_DOUBLE_EQ(with("mix(gap, 75 cm, 0.5)", Unit::meter).value(), 0.5);
    EXPECT_DOUBLE_EQ(with("smoothstep(0, 4, t)", Unit::none).value(), 0.5);
    EXPECT_DOUBLE_EQ(with("floor(2.7 * t)", Unit::none).value(), 5);
    for (const char* bad :
         {"sin()", "sin(1, 2)", "max(1)", "sin(gap)", "max(gap, 3 deg)", "sin 3", "mix(1, 2)", "min(1,"})
        EXPECT_FALSE(with(bad, Unit::none)) << bad;
    EXPECT_DOUBLE_EQ(with("2 min", Unit::second).value(), 120);  // "min" is the unit here, and not the function.
}

TEST(ExpressionNames, AreListed)
{
    EXPECT_EQ(namesIn("2 * gap + sin(t) * gap - 3cm + 30deg + pi"), (std::vector<std::string>{"gap", "t"}));
    EXPECT_TRUE(namesIn("1e3 + 2.5e-2 m").empty());
    EXPECT_TRUE(isExpressionWord("sin"));
    EXPECT_TRUE(isExpressionWord("mm"));
    EXPECT_FALSE(isExpressionWord("gap"));
}

TEST(ExpressionNames, NoNestingEndsTheProgram)
{
    for (const char* piece : {"(", "sin(", "-", "max(1,", "1^"}) {
        std::string deep;
        while (deep.size() < 4000) deep += piece;
        EXPECT_FALSE(with(deep, Unit::none)) << piece;
    }
}

}  // namespace
}  // namespace vitrine
