// Tables made at run time, and arrays of groups in tables.

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/table_change.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/derive.h"

#include <gtest/gtest.h>

#include <array>

namespace vitrine {
namespace {

struct Ball {
    Real radius;
    Choice<int> finish;
    Color tint;
};

/// Makes a table like the reader of a scene: from texts that do not outlive the call.
std::shared_ptr<const MadeTable> madeTable(const std::vector<std::string>& balls, double largest,
                                           std::vector<Real>* radii = nullptr)
{
    auto table = std::make_shared<MadeTable>();
    {
        std::string heading = "The scene", name = "speed", help = "How fast it turns.";
        table->group(heading);
        table->real(name, 1, Unit::none, {0, 10}, help);
        table->file("panorama", std::string("Around it."));
        heading.assign(heading.size(), '?');
        name.assign(name.size(), '?');
        help.assign(help.size(), '?');
    }
    std::vector<std::string> headings;
    std::vector<MadeTable::Element> elements;
    for (const std::string& ball : balls) headings.push_back("Ball " + ball);
    for (std::size_t i = 0; i < balls.size(); ++i) elements.push_back({balls[i], headings[i]});
    const std::vector<std::string> finishes{"matte", "old gold", "glass"};
    const std::vector<Ball> rows = table->groups("balls", elements, [&](std::size_t i) {
        Ball ball{};
        ball.radius =
            table->real("radius", 0.5 * static_cast<double>(i + 1), Unit::meter, {0, largest}, "From its middle.");
        ball.finish = table->choice("finish", 0, finishes, "What it is made of.");
        ball.tint = table->color("tint", {1, 1, 1}, "Of what is matte.");
        return ball;
    });
    if (radii)
        for (const Ball& ball : rows) radii->push_back(ball.radius);
    return table;
}

TEST(MadeTable, KeepsItsOwnTexts)
{
    const auto table = madeTable({"red", "blue"}, 10);
    ASSERT_EQ(table->rows().size(), 8U);
    EXPECT_EQ(table->rows()[0].name, "speed");
    EXPECT_EQ(table->rows()[0].group, "The scene");
    EXPECT_EQ(table->rows()[0].help, "How fast it turns.");
    EXPECT_EQ(table->rows()[3].choices[1], "old gold");
}

TEST(MadeTable, GroupsOfAnArrayHaveTheSameParametersUnderNamesOfTheirOwn)
{
    std::vector<Real> radii;
    const auto table = madeTable({"red", "blue"}, 10, &radii);
    const std::size_t blue = table->find("blueRadius").value();
    const ParameterInfo& row = table->rows()[blue];
    EXPECT_EQ(row.array, "balls");
    EXPECT_EQ(row.element, 1U);
    EXPECT_EQ(row.elementParameter, "radius");
    EXPECT_EQ(row.group, "Ball blue");
    EXPECT_EQ(label(row), "Blue radius");
    EXPECT_EQ(labelInGroup(row), "Radius");
    EXPECT_EQ(radii[1].row, blue);
    EXPECT_EQ(std::get<double>(row.initial), 1.0);
    EXPECT_TRUE(table->rows()[0].array.empty());
}

TEST(MadeTable, ConditionsWithinAGroupMeanTheParametersOfThatGroup)
{
    struct Lamps final : Parameters {
        struct Lamp {
            Toggle on;
            Real power;
        };
        std::array<Element, 2> elements{{{"left", "Left lamp"}, {"right", "Right lamp"}}};
        std::vector<Lamp> lamps = groups("lamps", elements, [this](std::size_t) {
            Lamp lamp{};
            lamp.on = toggle("on", false, "Whether it shines.");
            lamp.power = real("power", 1, none, {0, 2}, "How brightly.", when(lamp.on));
            return lamp;
        });
        Real fog = real("fog", 0, none, {0, 1}, "After them.");
    } table;
    ParameterValues values = table.initial();
    values.set(table.lamps[1].on, true);
    EXPECT_FALSE(acts(values, table.lamps[0].power.row));
    EXPECT_TRUE(acts(values, table.lamps[1].power.row));
    EXPECT_TRUE(table.rows()[table.fog.row].array.empty());
    EXPECT_EQ(table.rows()[table.fog.row].name, "fog");
}

TEST(MadeTable, LivesAsLongAsItsValues)
{
    std::optional<ParameterValues> values;
    std::weak_ptr<const MadeTable> alive;
    {
        const auto table = madeTable({"red"}, 10);
        alive = table;
        values.emplace(table);
    }
    EXPECT_FALSE(alive.expired());
    EXPECT_EQ(values->rows()[2].name, "redRadius");
    const ParameterValues copy = *values;
    values.reset();
    EXPECT_FALSE(alive.expired());
    EXPECT_EQ(copy.rows().size(), 5U);
}

TEST(MadeTable, ValuesGoOverToAnotherTableByName)
{
    const auto before = madeTable({"red", "blue"}, 10), after = madeTable({"blue", "green"}, 2);
    ParameterValues values(before);
    values.setParameter(before->find("speed").value(), 7.0);
    values.setParameter(before->find("blueRadius").value(), 9.0);
    values.setParameter(before->find("blueFinish").value(), 2.0);
    std::vector<std::string> notes;
    const ParameterValues moved = underTable(values, after, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(&moved.table(), after.get());
    EXPECT_EQ(moved.row(after->find("speed").value()), Value(7.0));
    EXPECT_EQ(moved.row(after->find("blueRadius").value()), Value(2.0));  // The nearest legal value.
    EXPECT_EQ(moved.row(after->find("blueFinish").value()), Value(2.0));
    EXPECT_TRUE(moved.isInitial(after->find("greenRadius").value()));
}

TEST(MadeTable, ValuesOfOtherParametersDifferWhateverTheirNumbers)
{
    const ParameterValues red(madeTable({"red"}, 10)), blue(madeTable({"blue"}, 10)), redAgain(madeTable({"red"}, 10));
    EXPECT_FALSE(red == blue);
    EXPECT_TRUE(red == redAgain);
}

TEST(MadeTable, HasPresetsLikeAnyOther)
{
    const auto table = madeTable({"red", "blue"}, 10);
    Preset preset{"scene", "Large", ParameterValues(table), std::nullopt, render::Json::object(), {}};
    preset.values.setParameter(table->find("blueRadius").value(), 3.25);
    preset.values.setParameter(table->find("redFinish").value(), 1.0);
    const std::string text = presetText(preset);
    EXPECT_NE(text.find("\"blueRadius\": 3.25"), std::string::npos) << text;
    EXPECT_NE(text.find("\"redFinish\": \"old gold\""), std::string::npos) << text;
    EXPECT_EQ(parsePreset(text, "large.json", "scene", *table).values, preset.values);
    // A table without the blue ball keeps the other values, and reports the unknown ones.
    const auto other = madeTable({"red"}, 10);
    const Preset read = parsePreset(text, "large.json", "scene", *other);
    EXPECT_EQ(read.values.row(other->find("redFinish").value()), Value(1.0));
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_NE(read.notes[0].find("blueRadius"), std::string::npos);
}

TEST(MadeTable, GivesShadersItsBlockAndItsChoicesByName)
{
    const auto table = madeTable({"red"}, 10);
    const std::string text = derive::uniformBlock(*table);
    for (const char* line : {"const int redFinish_matte = 0;\n", "const int redFinish_oldGold = 1;\n",
                             "const int redFinish_glass = 2;\n", "    float redRadius;\n", "    vec3 redTint;\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
    EXPECT_EQ(text.find("panorama"), std::string::npos);
}

}  // namespace
}  // namespace vitrine
