// Conditions under which parameters have an effect: their meaning, their texts, and rules for all tables.

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/table/parameters.h"
#include "exhibits/hall/hall_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine {
namespace {

enum class Light : int { sun, lamp, none };

struct Table final : Parameters {
    Group group_ = group("Light of the room");
    Choice<Light> light = choice("light", Light::sun, {"sun", "lamp", "none"}, "Where the light comes from.");
    Toggle shadows = toggle("shadows", true, "Whether it is kept off.", whenNot(light, Light::none));
    Real softness = real("softness", 0.5, none, {0, 1}, "Of the shadows.", when(shadows));
    Count looks = count("looks", 8, {1, 64}, "Into the map.", when(shadows) && whenAbove(softness, 0));
    File picture = file("picture", "On the wall.");
    Real turn = real("turn", 0, degree, {-3, 3}, "Of the picture.", whenGiven(picture), reads(0, "straight"));
    Color glow = color("glow", {1, 1, 1}, "Of sun or lamp.",
                       when(light, {Light::sun, Light::lamp}) || whenLater("always", 1), labeled("Glow of all"));
    Toggle always = toggle("always", false, "Glow in the dark.");
    Real lightFall = real("lightFall", 1, none, {0, 2}, "How fast it fades.");
};

class Conditions : public testing::Test {
protected:
    Table table;
    ParameterValues values = table.initial();

    [[nodiscard]] bool acting(std::string_view row) const { return acts(values, table.find(row).value()); }
};

TEST_F(Conditions, AParameterWithoutOneAlwaysActs)
{
    EXPECT_TRUE(acting("light"));
    EXPECT_TRUE(acting("picture"));
}

TEST_F(Conditions, AFileActsOnceItIsGiven)
{
    EXPECT_FALSE(acting("turn"));
    values.set(table.picture, std::string("a.png"));
    EXPECT_TRUE(acting("turn"));
}

TEST_F(Conditions, AllAndAnyAreWhatTheySay)
{
    EXPECT_TRUE(acting("looks"));
    values.set(table.softness, 0.0);
    EXPECT_FALSE(acting("looks"));
    values.set(table.light, Light::none);
    EXPECT_FALSE(acting("glow"));
    values.set(table.always, true);
    EXPECT_TRUE(acting("glow"));
}

TEST_F(Conditions, WhatHangsOnAParameterThatDoesNotActDoesNotActEither)
{
    values.set(table.light, Light::none);
    EXPECT_FALSE(acting("shadows"));
    EXPECT_FALSE(acting("softness")) << "shadows are on, but act on nothing";
    EXPECT_FALSE(acting("looks"));
}

TEST_F(Conditions, SnapshotsThatDifferInIdleParametersAloneAreAlike)
{
    values.set(table.light, Light::none);
    ParameterValues other = values;
    other.set(table.softness, 0.9);
    other.set(table.turn, 1.0);
    EXPECT_FALSE(values == other);
    EXPECT_EQ(actingValues(values), actingValues(other));
    other.set(table.always, true);
    EXPECT_FALSE(actingValues(values) == actingValues(other));
}

TEST_F(Conditions, SayWhenInTheLabelsOfTheOtherRows)
{
    const auto text = [&](std::string_view row) { return actsWhen(table, table.find(row).value()); };
    EXPECT_EQ(text("light"), "");
    EXPECT_EQ(text("shadows"), "“Light” is not none");
    EXPECT_EQ(text("looks"), "“Shadows” is on and “Softness” is above 0");
    EXPECT_EQ(text("turn"), "“Picture” names a file");
    EXPECT_EQ(text("glow"), "“Light” is sun or lamp or “Always” is on");
    values.set(table.light, Light::none);
    EXPECT_EQ(actsWhen(values, table.find("softness").value()),
              "“Shadows” is on (which acts when “Light” is not none)");
}

TEST_F(Conditions, StandInTheManual)
{
    EXPECT_NE(derive::manualTable(table).find("Of the shadows. *Acts when “Shadows” is on.* |"), std::string::npos)
        << derive::manualTable(table);
}

TEST_F(Conditions, AParameterIsCalledWhatItsTableSaysAndDoesNotRepeatItsHeading)
{
    const auto row = [&](std::string_view name) -> const ParameterInfo& {
        return table.rows()[table.find(name).value()];
    };
    EXPECT_EQ(label(row("glow")), "Glow of all");
    EXPECT_EQ(labelInGroup(row("lightFall")), "Fall");
    EXPECT_EQ(labelInGroup(row("light")), "Light") << "nothing would be left";
    EXPECT_EQ(labelInGroup(row("softness")), "Softness");
}

TEST(ConditionsOfTheTables, LookAtRowsThatAreThereWithValuesThatTheyCanHave)
{
    static const hall::HallTable hall;
    std::vector<const Parameters*> tables{&hall};
    const auto exhibits = allExhibits();
    for (const auto& exhibit : exhibits) tables.push_back(&exhibit->parameters());
    const auto check = [](const auto& self, const Parameters& table, const Condition& condition,
                          std::string_view of) -> void {
        for (const Condition& part : condition.parts) self(self, table, part, of);
        if (condition.row.empty()) {
            EXPECT_FALSE(condition.parts.empty()) << of;
            return;
        }
        ASSERT_TRUE(table.find(condition.row)) << of << " looks at " << condition.row;
        EXPECT_NE(condition.row, of);
        const ParameterInfo& row = table.rows()[*table.find(condition.row)];
        EXPECT_EQ(row.kind == Kind::file, condition.test == Condition::Test::given) << of;
        for (const double value : condition.values) EXPECT_EQ(nearestLegal(row, value), Value(value)) << of;
        if (condition.test == Condition::Test::above) {
            EXPECT_TRUE(row.isNumeric()) << of;
            EXPECT_EQ(condition.values.size(), 1U) << of;
        }
    };
    int conditions = 0;
    for (const Parameters* table : tables) {
        for (std::size_t i = 0; i < table->rows().size(); ++i) {
            const ParameterInfo& row = table->rows()[i];
            if (!row.actsWhen) continue;
            ++conditions;
            check(check, *table, *row.actsWhen, row.name);
            EXPECT_FALSE(actsWhen(*table, i).empty()) << row.name;
            (void)acts(table->initial(), i);  // Terminates: no parameter depends on itself.
        }
    }
    EXPECT_GT(conditions, 50);
}

}  // namespace
}  // namespace vitrine
