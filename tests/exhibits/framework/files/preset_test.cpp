#include "exhibits/framework/files/preset.h"

#include "render/version.h"
#include "tests/exhibits/framework/table/every_kind.h"
#include "tests/support/failures.h"
#include "tests/support/german_locale.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace vitrine;
using render::Json;
using test::everyKind;

Preset read(const std::string& text)
{
    return parsePreset(text, "a.json", "everything", everyKind);
}

/// Returns a preset file with these values.
std::string fileWith(const std::string& values, const std::string& more = "")
{
    return "{\n\"format\": \"vitrine-preset\",\n\"version\": 1,\n\"exhibit\": \"everything\",\n\"name\": "
           "\"A\",\n\"values\": {\n" +
           values + "\n}" + more + "\n}";
}

Preset plain()
{
    return {"everything", "A", everyKind.initial(), std::nullopt, Json::object(), {}};
}

TEST(Preset, IsWrittenTheSameWayEveryTime)
{
    Preset preset = plain();
    preset.name = "Tasse 杯";
    preset.values.set(everyKind.morph, 0.1);
    preset.values.set(everyKind.stepLimit, 128);
    preset.values.set(everyKind.wind, true);
    preset.values.set(everyKind.way, test::Way::Fancy);
    preset.values.set(everyKind.tint, ColorValue{{0, 0.5, 1}});
    preset.camera = render::Camera{{1, 2, 3}, {0, 1, 0}, 0.5};
    EXPECT_EQ(presetText(preset), R"({
  "format": "vitrine-preset",
  "version": 1,
  "app": ")" + render::programVersion() +
                                      R"(",
  "exhibit": "everything",
  "name": "Tasse 杯",
  "values": {
    "morph": 0.1,
    "stepLimit": 128,
    "tint": [0.0, 0.5, 1.0],
    "way": "Fancy",
    "wind": true
  },
  "camera": {
    "eye": [1.0, 2.0, 3.0],
    "target": [0.0, 1.0, 0.0],
    "fov": 0.5
  }
}
)");
    const Preset back = read(presetText(preset));
    EXPECT_EQ(back.values, preset.values);
    EXPECT_EQ(back.camera, preset.camera);
    EXPECT_EQ(back.name, preset.name);
    EXPECT_TRUE(back.notes.empty());
    EXPECT_EQ(presetText(back), presetText(preset));
}

TEST(Preset, HoldsOnlyWhatDiffersFromTheInitialValues)
{
    EXPECT_NE(presetText(plain()).find("\"values\": {}"), std::string::npos);
    EXPECT_EQ(read(fileWith("")).values, everyKind.initial());
    Preset preset = read(fileWith("\"morph\": 0.75"));
    preset.values.set(everyKind.morph, 0.5);
    EXPECT_EQ(presetText(preset).find("morph"), std::string::npos) << "back at its initial value";
}

TEST(Preset, KeepsUnknownKeysOnSave)
{
    const Preset preset =
        read(fileWith(R"("aFuture": {"z": 1, "a": [true, null, 1.0, 2]}, "morph": 0.75, "zFuture": "x")",
                      ",\n\"seed\": 7, \"camera\": {\"lens\": 50, \"fov\": 0.5}, \"locked\": [\"morph\"]"));
    EXPECT_EQ(preset.notes.size(), 4U);
    const std::string text = presetText(preset);
    const Json root = Json::parse(text);
    EXPECT_EQ(root["values"].dump(), R"({"aFuture":{"z":1,"a":[true,null,1.0,2]},"morph":0.75,"zFuture":"x"})");
    EXPECT_EQ(root["seed"], 7);
    EXPECT_EQ(root["locked"].dump(), R"(["morph"])");
    EXPECT_EQ(root["camera"]["lens"], 50);
    EXPECT_EQ(presetText(read(text)), text);
}

TEST(Preset, ClampsARoundedLimitWithoutAWord)
{
    const Preset rounded = read(fileWith(R"("angle": 3.141593)"));
    EXPECT_TRUE(rounded.notes.empty());
    EXPECT_EQ(rounded.values[everyKind.angle], 3.141592653589793);
    EXPECT_EQ(read(fileWith(R"("angle": 3.1417)")).notes.size(), 1U);
}

TEST(Preset, ReportsEveryClamp)
{
    const Preset preset = read(fileWith(R"("exposure": 99, "stepLimit": 64.4, "tint": [2, 0, 0], "sun": [0, 3, 4])"));
    EXPECT_EQ(preset.notes, (std::vector<std::string>{"exposure 99 -> 16 (allowed -16 to 16)",
                                                      "stepLimit 64.4 -> 64 (whole numbers only)",
                                                      "tint (2, 0, 0) -> (1, 0, 0) (allowed 0 to 1)",
                                                      "sun (0, 3, 4) -> (0, 0.6, 0.8) (made unit length)"}));
    EXPECT_EQ(preset.values[everyKind.exposure], 16);
    EXPECT_EQ(read(fileWith("", ", \"camera\": {\"fov\": 9}")).notes.size(), 1U);
    const Preset far = read(fileWith("", ", \"camera\": {\"eye\": [1e300, 1, -1e17]}"));
    EXPECT_EQ(far.notes, std::vector<std::string>{
                             "camera.eye (1e+300, 1, -1e+17) -> (1e+06, 1, -1e+06) (allowed -1e+06 to 1e+06 m)"});
    EXPECT_EQ(far.camera->eye, glm::dvec3(1e6, 1, -1e6));
}

TEST(Preset, NamesFileLineAndKeyOfWhatIsWrong)
{
    EXPECT_FAILURE(read(fileWith("\"morph\": 0,\n\"exposure\": \"bright\"")),
                   "a.json, line 8, values.exposure: this must be a number, not text");
    EXPECT_FAILURE(read(fileWith("\"wind\": 1")), "values.wind: this must be true or false, not a number");
    EXPECT_FAILURE(read(fileWith("\"morph\": null")), "values.morph: this must be a number, not null");
    EXPECT_FAILURE(read(fileWith("\"morph\": true")), "values.morph: this must be a number");
    EXPECT_FAILURE(read(fileWith("\"way\": \"sideways\"")),
                   "unknown choice \"sideways\"; choose one of plain, Fancy, both");
    EXPECT_FAILURE(read(fileWith("\"way\": 1")), "values.way: this must be the name of a choice");
    EXPECT_FAILURE(read(fileWith("\"tint\": [1, 2]")), "values.tint: this must be an array of three numbers");
    EXPECT_FAILURE(read(fileWith("\"tint\": [1, 2, \"3\"]")), "values.tint");
    EXPECT_FAILURE(read(fileWith("\"sun\": [0, 0, 0]")), "values.sun: this direction has no length");
    EXPECT_FAILURE(read(fileWith("\"picture\": 3")), "values.picture: this must be a file name");
    EXPECT_FAILURE(read(fileWith("\"morph\": 1e999")),
                   "line 7, column 14, values.morph: the number 1e999 is too large");
    EXPECT_FAILURE(read(fileWith("\"morph\": NaN")), "line 7");
    EXPECT_FAILURE(read(fileWith("\"morph\": 0,\n\"morph\": 1")),
                   "line 8, column 7, values.morph: this key appears twice");
    EXPECT_FAILURE(read(fileWith("", ",\n\"camera\": {\"eye\": [1, 2]}")),
                   "line 9, camera.eye: this must be an array of three numbers");
    EXPECT_FAILURE(read(fileWith("", ",\n\"camera\": 3")), "line 9, camera: this must be an object");
}

TEST(Preset, RefusesOtherFormatsExhibitsAndVersions)
{
    EXPECT_FAILURE(read("[]"), "this is not a preset");
    EXPECT_FAILURE(read("{}"), "says neither format nor version");
    EXPECT_FAILURE(read(R"({"version": 1})"), "\"format\" is missing");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "other"})"), "not a format of Vitrine");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "vitrine-preset", "exhibit": "fur"})"),
                   "this preset is for fur, not for everything");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "vitrine-preset"})"), "\"exhibit\" is missing");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "vitrine-exhibition"})"), "whole exhibition");
    EXPECT_FAILURE(read(R"({"version": 2, "format": "vitrine-preset", "exhibit": "everything"})"),
                   "line 1, version: a newer Vitrine wrote this (version 2");
    EXPECT_FAILURE(read(R"({"version": 0, "format": "vitrine-preset"})"), "line 1, version: there is no version 0");
    EXPECT_FAILURE(read(R"({"version": 1.5, "format": "vitrine-preset"})"), "version: this must be a whole number");
    EXPECT_FAILURE(read(R"({"version": "1", "format": "vitrine-preset"})"), "version: this must be a whole number");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "vitrine-preset", "exhibit": "everything", "values": 3})"),
                   "values: this must be an object");
    EXPECT_FAILURE(read(R"({"version": 1, "format": "vitrine-preset", "exhibit": "everything", "name": 3})"),
                   "name: this must be text");
}

TEST(Preset, TagsStandBehindTheNameAndOnlyWhereThereAreSome)
{
    Preset preset = plain();
    const std::string without = presetText(preset);
    EXPECT_EQ(without.find("tags"), std::string::npos);
    preset.tags = {"night", "Wasser"};
    const std::string with = presetText(preset);
    EXPECT_NE(with.find("\"version\": 1"), std::string::npos);
    EXPECT_NE(with.find("\"name\": \"A\",\n  \"tags\": [\n    \"night\",\n    \"Wasser\"\n  ],\n"), std::string::npos)
        << with;
    const Preset back = read(with);
    EXPECT_EQ(back.tags, preset.tags);
    EXPECT_TRUE(back.notes.empty()) << "they are known";
    EXPECT_EQ(presetText(back), with);
    EXPECT_EQ(presetHeader(render::parseJson(with, "a.json", presetLimits)).tags, preset.tags);
    // Adding and removing tags leaves the rest of the file unchanged.
    EXPECT_EQ(taggedPreset(render::parseJson(without, "a.json", presetLimits), preset.tags), with);
    EXPECT_EQ(taggedPreset(render::parseJson(with, "a.json", presetLimits), {}), without);
    // Exhibitions have tags, too.
    Exhibition exhibition =
        parseExhibition(R"({"format": "vitrine-exhibition", "version": 1, "name": "E", "tags": ["x"], "values": {}})",
                        "e.json", {{"everything", everyKind.initial()}});
    EXPECT_EQ(exhibition.tags, PresetTags{"x"});
    EXPECT_NE(exhibitionText(exhibition).find("\"tags\""), std::string::npos);
}

TEST(Preset, StrangeTagsAreRefusedWithTheirPlace)
{
    const auto refused = [](const std::string& tags) {
        return test::failureOf([&] { (void)read(fileWith("", ",\n\"tags\": " + tags)); });
    };
    EXPECT_NE(refused("\"night\"").find("a.json, line 9, tags"), std::string::npos) << refused("\"night\"");
    EXPECT_NE(refused("[\"a\", 3]").find("tags[1]"), std::string::npos);
    for (const char* tag : {"\"\"", "\" a\"", "\"a \"", "\"a,b\"", "\"a\\nb\"", "\"\\u007f\"", "[]", "null"})
        EXPECT_NE(refused("[" + std::string(tag) + "]").find("tags[0]"), std::string::npos) << tag;
    EXPECT_NE(refused("[\"Night\", \"night\"]").find("twice"), std::string::npos);
    EXPECT_NE(refused("[\"" + std::string(41, 'x') + "\"]").find("40 bytes"), std::string::npos);
    std::string many = "[\"a0\"";
    for (int i = 1; i <= 16; ++i) many += ", \"a" + std::to_string(i) + '"';
    EXPECT_NE(refused(many + "]").find("more than 16"), std::string::npos);
}

TEST(Preset, TagsAreTypedWithCommas)
{
    EXPECT_EQ(tagsFromText(" night,, deep water ,Night"), (PresetTags{"night", "deep water"}));
    EXPECT_TRUE(tagsFromText("").empty());
    EXPECT_TRUE(tagsFromText(" , ").empty());
    EXPECT_THROW((void)tagsFromText(std::string(41, 'x')), Failure);
    EXPECT_THROW((void)tagsFromText("a\tb"), Failure);
    std::string many;
    for (int i = 0; i < 17; ++i) many += "a" + std::to_string(i) + ',';
    EXPECT_THROW((void)tagsFromText(many), Failure);
}

TEST(Preset, IsTheSameInAGermanLocale)
{
    const test::GermanLocale german;
    if (!german.active()) GTEST_SKIP() << "no German locale here";
    Preset preset = plain();
    preset.values.set(everyKind.exposure, 1.5);
    EXPECT_NE(presetText(preset).find("\"exposure\": 1.5\n"), std::string::npos);
    EXPECT_EQ(read(presetText(preset)).values, preset.values);
}

TEST(Preset, OfTheWholeExhibitionHasDottedKeys)
{
    const test::EveryKind hall;
    NamedValues initial = {{"hall", hall.initial()}, {"everything", everyKind.initial()}};
    Exhibition exhibition{"All", initial, {{9, 8, 7}, {0, 0, 0}, 1}, Json::object(), {}};
    exhibition.values[0].second.set(hall.exposure, 2.0);
    exhibition.values[1].second.set(everyKind.morph, 0.75);
    exhibition.chosen = "everything";
    const std::string text = exhibitionText(exhibition);
    EXPECT_EQ(Json::parse(text)["values"].dump(), R"({"everything.morph":0.75,"hall.exposure":2.0})");
    const Exhibition back = parseExhibition(text, "all.json", initial);
    EXPECT_EQ(back.values, exhibition.values);
    EXPECT_EQ(back.camera, exhibition.camera);
    EXPECT_EQ(back.chosen, "everything");

    const std::string more =
        R"({"format": "vitrine-exhibition", "version": 1, "values": {"gone.size": 3, "hall.exposure": 99}})";
    const Exhibition other = parseExhibition(more, "all.json", initial);
    EXPECT_EQ(other.notes, (std::vector<std::string>{"hall.exposure 99 -> 16 (allowed -16 to 16)",
                                                     "values.gone.size is not known here; it is kept"}));
    EXPECT_NE(exhibitionText(other).find("\"gone.size\": 3"), std::string::npos);
    EXPECT_FAILURE(parseExhibition(fileWith(""), "all.json", initial), "preset of one exhibit");
    EXPECT_FAILURE(
        parseExhibition("{\"format\": \"vitrine-exhibition\", \"version\": 1, \"values\":\n{\"hall.exposure\": true}}",
                        "all.json", initial),
        "all.json, line 2, values.hall.exposure");
}

// A damaged file gives legal values, or a Failure and no change.
TEST(Preset, NeverCrashesOnDamagedFiles)
{
    Preset rich = plain();
    rich.values.set(everyKind.morph, 0.123456789);
    rich.values.set(everyKind.stepLimit, 128);
    rich.values.set(everyKind.wind, true);
    rich.values.set(everyKind.way, test::Way::Fancy);
    rich.values.set(everyKind.tint, ColorValue{{0, 0.5, 1}});
    rich.values.set(everyKind.sun, DirectionValue{{1, 0, 0}});
    rich.values.set(everyKind.picture, std::string("a.png"));
    rich.camera = render::Camera{};
    const std::string good = presetText(rich);
    const std::vector<std::string> pieces = {"1e999", "NaN",     "-1e308", "null",          "{}",
                                             "[]",    "\"\"",    "true",   "\"morph\": 1,", "}",
                                             "{",     "\\u0000", ",",      "\xff",          "99999999999999999999",
                                             "-0.0"};
    std::mt19937 generator(8);
    const auto random = [&generator] { return static_cast<unsigned>(generator()); };
    ParameterValues current = everyKind.initial();
    current.set(everyKind.exposure, 3.0);
    const ParameterValues before = current;
    int accepted = 0;
    for (int i = 0; i < 10'000; ++i) {
        std::string text = good;
        for (unsigned n = random() % 3 + 1; n > 0; --n) {
            const std::size_t at = random() % text.size();
            if (random() % 2 == 0)
                text[at] = static_cast<char>(random() % 128);
            else
                text.replace(at, random() % 8, pieces[random() % pieces.size()]);
        }
        try {
            const Preset preset = read(text);
            for (std::size_t row = 0; row < preset.values.rows().size(); ++row) {
                ASSERT_EQ(nearestLegal(preset.values.rows()[row], preset.values.row(row)), preset.values.row(row));
            }
            ASSERT_EQ(presetText(read(presetText(preset))), presetText(preset));
            ++accepted;
        } catch (const Failure& failure) {
            ASSERT_TRUE(std::string(failure.what()).starts_with("a.json")) << failure.what();
            ASSERT_EQ(current, before);
        }
    }
    EXPECT_GT(accepted, 100);
}

}  // namespace
