// Traits of jobs' parameters: words for values beyond the range, lists of texts, and ways to give them.

#include "exhibits/framework/table/morph.h"
#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/table/value_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vitrine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

enum class Origin : int { shown, files };

struct TraitTable final : Parameters {
    Choice<Origin> origin = choice("origin", Origin::shown, {"shown", "files"}, "Origin of the pictures.");
    Real distance = real("distance", infinity, centimeter, Range{0.0001, 1000, logarithmic}.soft(0.1, 10),
                         "Viewing distance.", reads(infinity, "inf"), option("distance-mm", millimeter));
    Real baseline = real("baseline", -1, none, {0, 4}, "Scale of the baseline.", reads(-1, "auto"), reads(1, "true"));
    Count views = count("views", 0, {0, 48}, "Number of views.", reads(0, "auto"));
    Count width = count("width", 64, {1, 100}, "Width.", tuple("size", 'x'));
    Count height = count("height", 48, {1, 100}, "Height.", tuple("size", 'x'));
    File files = file("files", "Pictures.", several(), positional(), mustBeGiven(), implies(origin, Origin::files));
    Text names = text("names", "Names.", several());
};

const ParameterInfo& info(std::uint16_t row)
{
    static const TraitTable table;
    return table.rows()[row];
}

const TraitTable table;

/// Returns the value after writing it to a preset or document and reading it back.
Value throughJson(const ParameterInfo& parameter, const Value& value)
{
    std::vector<std::string> notes;
    const auto read = valueFromText(parameter, render::writeJson(jsonFromValue(parameter, value)), notes);
    EXPECT_TRUE(notes.empty()) << parameter.name << ": " << (notes.empty() ? "" : notes.front());
    return read.value_or(Value("nothing was read"));
}

TEST(ParameterWords, StandForNumbersBeyondTheRange)
{
    ParameterValues values(table);
    EXPECT_EQ(values[table.distance], infinity);
    EXPECT_TRUE(values.setParameter(table.distance.row, 2.0));
    EXPECT_TRUE(values.setParameter(table.distance.row, infinity));
    EXPECT_FALSE(values.setParameter(table.distance.row, -infinity)) << "no word stands for that";
    EXPECT_EQ(values[table.distance], 0.0001);
    EXPECT_FALSE(values.setParameter(table.baseline.row, -2.0));
    EXPECT_EQ(values[table.baseline], 0);
    EXPECT_TRUE(values.setParameter(table.baseline.row, -1.0));
    EXPECT_FALSE(values.setParameter(table.distance.row, std::nan("")));
}

TEST(ParameterWords, AreTypedAndShownEachByItsName)
{
    EXPECT_EQ(parseValue(info(table.baseline.row), "auto"), Value(-1.0));
    EXPECT_EQ(parseValue(info(table.baseline.row), "True"), Value(1.0));
    EXPECT_EQ(parseValue(info(table.distance.row), "inf"), Value(infinity));
    EXPECT_EQ(parseValue(info(table.distance.row), "never"), std::nullopt);
    EXPECT_EQ(formatValue(info(table.distance.row), infinity), "inf");
    EXPECT_EQ(formatValue(info(table.baseline.row), -1.0), "auto");
    EXPECT_EQ(formatValue(info(table.baseline.row), 1.0), "1") << "a number of the range stays one";
    ASSERT_NE(info(table.baseline.row).wordFor(1), nullptr);
    EXPECT_EQ(info(table.baseline.row).wordFor(1)->text, "true");
    EXPECT_EQ(info(table.baseline.row).wordFor(0.5), nullptr);
}

TEST(ParameterWords, NeverReachJsonAsNumbersBeyondTheRange)
{
    EXPECT_EQ(jsonFromValue(info(table.distance.row), infinity), render::Json("inf"));
    EXPECT_EQ(jsonFromValue(info(table.baseline.row), -1.0), render::Json("auto"));
    EXPECT_EQ(jsonFromValue(info(table.views.row), 0.0), render::Json(0)) << "as presets have it";
    for (const double value : {infinity, 0.0001, 1.5}) {
        EXPECT_EQ(throughJson(info(table.distance.row), value), Value(value));
    }
    EXPECT_EQ(throughJson(info(table.baseline.row), -1.0), Value(-1.0));
    std::vector<std::string> notes;
    EXPECT_EQ(valueFromText(info(table.views.row), "\"auto\"", notes), Value(0.0)) << "words are read everywhere";
    EXPECT_EQ(valueFromText(info(table.views.row), "\"most\"", notes), std::nullopt);
    EXPECT_EQ(notes.size(), 1U);
}

TEST(ParameterWords, AreDrawnAtRandomBesideLegalNumbers)
{
    RandomNumbers random(7);
    int words = 0;
    for (int i = 0; i < 1000; ++i) {
        const Value value = randomValue(info(table.distance.row), random);
        EXPECT_EQ(throughJson(info(table.distance.row), value), value);
        words += std::isinf(std::get<double>(value));
    }
    EXPECT_GT(words, 100);
    EXPECT_LT(words, 350);
}

TEST(ParameterWords, HaveNothingBetween)
{
    const ParameterInfo& distance = info(table.distance.row);
    EXPECT_EQ(morphed(distance, infinity, 2.0, 0.2), Value(infinity));
    EXPECT_EQ(morphed(distance, infinity, 2.0, 0.8), Value(2.0));
    const ParameterInfo& baseline = info(table.baseline.row);
    EXPECT_EQ(morphed(baseline, -1.0, 1.0, 0.2), Value(-1.0));
    EXPECT_EQ(morphed(baseline, 1.0, -1.0, 0.2), Value(1.0));
}

TEST(ParameterLists, AreLinesAndArrays)
{
    const ParameterInfo& files = info(table.files.row);
    EXPECT_EQ(linesOf("a.png\nb c.png\n"), (std::vector<std::string>{"a.png", "b c.png"}));
    EXPECT_TRUE(linesOf("").empty());
    EXPECT_EQ(jsonFromValue(files, std::string("a.png\nb.png")), (render::Json{"a.png", "b.png"}));
    EXPECT_EQ(jsonFromValue(files, std::string()), render::Json::array());
    for (const char* value : {"", "a.png", "a.png\nb.png"}) {
        EXPECT_EQ(throughJson(files, std::string(value)), Value(std::string(value)));
        EXPECT_EQ(throughJson(info(table.names.row), std::string(value)), Value(std::string(value)));
    }
    std::vector<std::string> notes;
    EXPECT_EQ(valueFromText(files, "\"a.png\"", notes), std::nullopt);
    EXPECT_EQ(valueFromText(files, "[\"a\\nb\"]", notes), std::nullopt);
    EXPECT_EQ(valueFromText(files, "[\"\"]", notes), std::nullopt);
    EXPECT_EQ(valueFromText(files, "[1]", notes), std::nullopt);
    EXPECT_EQ(notes.size(), 4U);
}

TEST(ParameterTraits, StandInTheTable)
{
    EXPECT_EQ(info(table.distance.row).given.option, "distance-mm");
    EXPECT_EQ(info(table.distance.row).given.unit, Unit::millimeter);
    EXPECT_EQ(info(table.width.row).given.tuple, "size");
    EXPECT_EQ(info(table.height.row).given.separator, 'x');
    EXPECT_TRUE(info(table.files.row).given.positional);
    EXPECT_TRUE(info(table.files.row).given.mustBeGiven);
    ASSERT_EQ(info(table.files.row).given.implies.size(), 1U);
    EXPECT_EQ(info(table.files.row).given.implies[0], (Implication{"origin", 1}));
    EXPECT_EQ(info(table.views.row).given, GivenAs{});
}

}  // namespace
}  // namespace vitrine
