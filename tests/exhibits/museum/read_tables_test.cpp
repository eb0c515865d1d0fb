// Exhibits whose parameters come from a file: tables follow the file, and values follow the tables.

#include "exhibits/museum/read_tables.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/table_change.h"
#include "tests/support/balls.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

class ReadTables : public testing::Test {
protected:
    [[nodiscard]] const Exhibit& balls() const { return balls_; }
    [[nodiscard]] std::string path(const char* name) const { return (folder_.path() / name).string(); }
    /// Returns initial values with this file, under the table that it gives.
    [[nodiscard]] ParameterValues valuesOf(const std::string& file)
    {
        ParameterValues values = balls().parameters().initial();
        setParameter(values, "scene", file);
        return read(values).sceneState.values[0];
    }
    [[nodiscard]] TabledSceneState read(const ParameterValues& values)
    {
        return readTables(subjects_, assets_, {{values}, {}});
    }
    [[nodiscard]] std::string presetOf(const ParameterValues& values) const
    {
        return presetText({"balls", "Mine", values, std::nullopt, render::Json::object(), {}});
    }
    [[nodiscard]] Preset parsed(const std::string& text) const
    {
        return parsePreset(text, "mine.json", "balls", balls().parameters());
    }

    test::TemporaryFolder folder_;
    test::BallsExhibit balls_;
    std::vector<const SceneObject*> subjects_{&balls_};
    render::AssetStore assets_;
};

TEST_F(ReadTables, GiveTheParametersThatTheFileDescribes)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    const ParameterValues values = valuesOf(path("two.json"));
    EXPECT_EQ(parameterOf(values, "redRadius"), Value(0.5));
    EXPECT_EQ(parameterOf(values, "blueRadius"), Value(2.0));
    EXPECT_EQ(parameterOf(values, "scene"), Value(path("two.json")));
    EXPECT_FALSE(parameterOf(values, "greenRadius"));
}

TEST_F(ReadTables, AreReadOnceAndAreTheSameForTheSameFile)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    const ParameterValues first = valuesOf(path("two.json")), second = valuesOf(path("two.json"));
    EXPECT_EQ(&first.table(), &second.table());
    EXPECT_EQ(assets_.builds("balls.scene"), 1);
}

TEST_F(ReadTables, KeepValuesOfTheSameNameWhenTheFileIsAnother)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    writeBalls(path("other.json"), {{"blue", 1}, {"green", 3}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "spin", 7.0);
    setParameter(values, "blueRadius", 4.5);
    setParameter(values, "scene", path("other.json"));
    const ParameterValues other = read(values).sceneState.values[0];
    EXPECT_EQ(parameterOf(other, "spin"), Value(7.0));
    EXPECT_EQ(parameterOf(other, "blueRadius"), Value(4.5));
    EXPECT_EQ(parameterOf(other, "greenRadius"), Value(3.0));
    EXPECT_FALSE(parameterOf(other, "redRadius"));
    setParameter(values, "scene", std::string());
    EXPECT_EQ(&read(values).sceneState.values[0].table(), &balls().parameters());
}

TEST_F(ReadTables, AFileThatCannotBeReadKeepsTheTableAndSaysSoOnce)
{
    writeBalls(path("two.json"), {{"red", 0.5}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "redRadius", 4.5);
    setParameter(values, "scene", path("gone.json"));
    const TabledSceneState tabled = read(values);
    EXPECT_EQ(&tabled.sceneState.values[0].table(), &values.table());
    EXPECT_EQ(parameterOf(tabled.sceneState.values[0], "redRadius"), Value(4.5));
    ASSERT_EQ(tabled.unreadable.size(), 1U);
    EXPECT_NE(tabled.unreadable[0].english().find("gone.json"), std::string::npos);
    EXPECT_EQ(tabled.unreadable[0].english().rfind("Scene of Balls: ", 0), 0U) << tabled.unreadable[0];
}

TEST_F(ReadTables, PresetsBringBackWhatWasSetInTheParametersOfAFile)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "blueRadius", 3.25);
    const std::string text = presetOf(values);
    EXPECT_NE(text.find("\"blueRadius\": 3.25"), std::string::npos) << text;

    const Preset preset = parsed(text);
    EXPECT_TRUE(preset.notes.empty()) << preset.notes.front();
    const TabledSceneState tabled = read(preset.values);
    EXPECT_TRUE(tabled.notes.empty()) << tabled.notes.front();
    EXPECT_EQ(tabled.sceneState.values[0], values);
    EXPECT_EQ(withTableOf(values, preset.values), values);
    EXPECT_EQ(presetOf(tabled.sceneState.values[0]), text);
}

TEST_F(ReadTables, PresetsSurviveAFileThatChangedSince)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "blueRadius", 3.25);
    setParameter(values, "redRadius", 1.25);
    const std::string text = presetOf(values);
    writeBalls(path("two.json"), {{"green", 1}, {"blue", 2}, {"white", 1}});
    const TabledSceneState tabled = read(parsed(text).values);
    EXPECT_EQ(parameterOf(tabled.sceneState.values[0], "blueRadius"), Value(3.25));
    EXPECT_EQ(parameterOf(tabled.sceneState.values[0], "greenRadius"), Value(1.0));
    // The red ball is unknown now: a note says so, and the value is kept.
    ASSERT_EQ(tabled.notes.size(), 1U);
    EXPECT_NE(tabled.notes[0].find("redRadius"), std::string::npos) << tabled.notes[0];
    EXPECT_NE(presetOf(tabled.sceneState.values[0]).find("\"redRadius\": 1.25"), std::string::npos);
}

TEST_F(ReadTables, ValuesAreNotLostWhileTheFileIsAway)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "blueRadius", 3.25);
    const std::string text = presetOf(values);

    std::filesystem::remove(path("two.json"));
    const TabledSceneState away = read(parsed(text).values);
    EXPECT_EQ(away.unreadable.size(), 1U);
    EXPECT_EQ(presetOf(away.sceneState.values[0]), text);

    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    EXPECT_EQ(read(away.sceneState.values[0]).sceneState.values[0], values);
}

TEST_F(ReadTables, APendingValueThatFitsNoParameterIsSaidAndLeftInitial)
{
    writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
    const std::string text = R"({"format": "vitrine-preset", "version": 1, "exhibit": "balls", "name": "x", "values": {
        "scene": ")" + path("two.json") +
                             R"(", "redRadius": "wide", "blueRadius": 99}})";
    const TabledSceneState tabled = read(parsed(text).values);
    EXPECT_EQ(parameterOf(tabled.sceneState.values[0], "redRadius"), Value(0.5));
    EXPECT_EQ(parameterOf(tabled.sceneState.values[0], "blueRadius"), Value(10.0));
    EXPECT_EQ(tabled.notes.size(), 2U);
}

TEST_F(ReadTables, KeysThatNoFileCouldGiveAreNotedAsEver)
{
    const Preset preset = parsed(
        R"({"format": "vitrine-preset", "version": 1, "exhibit": "balls", "name": "x", "values": {"redRadius": 1}})");
    EXPECT_TRUE(preset.values.pending().empty());
    ASSERT_EQ(preset.notes.size(), 1U);
    EXPECT_NE(preset.notes[0].find("redRadius"), std::string::npos);
    EXPECT_NE(presetText(preset).find("\"redRadius\": 1"), std::string::npos);
}

TEST_F(ReadTables, SettingsOfTheWholeExhibitionKeepThemToo)
{
    writeBalls(path("two.json"), {{"red", 0.5}});
    ParameterValues values = valuesOf(path("two.json"));
    setParameter(values, "redRadius", 3.25);
    const std::string text = exhibitionText({"All", {{"balls", values}}, {}});
    EXPECT_NE(text.find("\"balls.redRadius\": 3.25"), std::string::npos) << text;
    const Exhibition all = parseExhibition(text, "all.json", {{"balls", balls().parameters().initial()}});
    EXPECT_TRUE(all.notes.empty()) << all.notes.front();
    EXPECT_EQ(read(all.values[0].second).sceneState.values[0], values);
}

TEST_F(ReadTables, ValuesOutliveEverybodyElseWhoHoldsTheirTable)
{
    writeBalls(path("two.json"), {{"red", 0.5}});
    std::weak_ptr<const Parameters> table;
    std::optional<ParameterValues> initial;
    {
        render::AssetStore own;
        ParameterValues values = balls().parameters().initial();
        setParameter(values, "scene", path("two.json"));
        const SceneState sceneState = readTables(subjects_, own, {{values}, {}}).sceneState;
        table = sceneState.values[0].sharedTable();
        initial = sceneState.values[0].table().initial();
    }
    EXPECT_FALSE(table.expired());
    EXPECT_EQ(parameterOf(*initial, "redRadius"), Value(0.5));
    initial.reset();
    EXPECT_TRUE(table.expired());
}

}  // namespace
}  // namespace vitrine
