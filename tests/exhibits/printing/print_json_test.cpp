#include "exhibits/printing/print_json.h"
#include "exhibits/printing/print_plan.h"
#include "exhibits/printing/sheet_list.h"
#include "tests/exhibits/printing/set_up_print.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

class SettingsText : public test::SetUpPrint {
protected:
    SheetList sheets_{folder_.path() / "config" / "sheets.json"};
};

using LongSettingsText = SettingsText;

TEST_F(LongSettingsText, EverySettingSurvivesItsTextWhateverItIs)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    int possible = 0;
    for (int turn = 0; turn < 40; ++turn) {
        ParameterValues values = table_.initial();
        for (std::size_t i = 0; i < values.rows().size(); ++i) {
            const ParameterInfo& row = values.rows()[i];
            double x = row.range.softLow + unit(random) * (row.range.softHigh - row.range.softLow);
            if (row.kind != Kind::real)
                x = std::floor(row.range.low +
                               unit(random) * (std::min(row.range.high, row.range.softHigh) + 1 - row.range.low));
            if (row.isWritten())
                values.setParameter(i, std::string(row.several ? "/a/view 1.png\nü.png" : "ü.png"));
            else
                values.setParameter(i, x);
        }
        // A plan reads the profile, and files of these names do not exist.
        const std::string profile;
        if (printPlan(values, nullptr, "p.tif", &profile).refusal.empty()) ++possible;
        const SavedSettings back = savedSettings(settingsText(values), "kept.json");
        for (std::size_t i = 0; i < values.rows().size(); ++i)
            EXPECT_EQ(back.values.row(i), values.row(i)) << values.rows()[i].name;
    }
    EXPECT_GT(possible, 3);  // Control: not all settings were refused.
}

TEST_F(SettingsText, APrintIsLaidOutAgainFromItsDocument)
{
    for (const char* sheet : {"75-measured", "60-3d", "20-flip"}) {
        ParameterValues values = withSheet(table_.initial(), knownSheet(sheet));
        values.set(table_.dotsDown, 360.0);
        values.set(table_.width, 0.07);
        values.set(table_.height, 0.0415);
        values.set(table_.distance, 0.4);
        values.set(table_.direction, 90 * test::degree);
        values.set(table_.reverse, true);
        values.set(table_.method, Method::guard);
        const PrintLayout layout(printSettings(values, 7));
        const std::string text = render::writeJson(printJson(values, layout, 720, {{"one.png"}}));
        const SavedSettings back = savedSettings(text, "print.tif.json");
        EXPECT_TRUE(picturesOf(back.values).empty());
        EXPECT_EQ(back.values, values);
        EXPECT_EQ(sheets_.nameOf(sheetOf(back.values)), sheet);
        const PrintLayout again(settingsFromJson(render::parseJson(text, "print.tif.json")));
        EXPECT_EQ(again.settings().views, 7);
        EXPECT_EQ(again.width(), layout.width());
        EXPECT_EQ(again.height(), layout.height());
        EXPECT_EQ(again.printPitch(), layout.printPitch());
        for (const double x : {0.0, 17.5, 400.25}) EXPECT_EQ(again.lensAt(x, 3 * x), layout.lensAt(x, 3 * x));
    }
}

TEST_F(SettingsText, BrokenSettingsNameFileAndKey)
{
    for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
             {"{}", "lenticular print"},
             {R"({"format": "vitrine-job", "version": 1, "job": "sprite", "values": {}})", "lenticular print"},
             {R"({"format": "vitrine-job", "version": 2, "job": "print", "values": {}})", "version"},
             {R"({"format": "vitrine-job", "version": 1, "job": "print"})", "values"},
             {R"({"format": "vitrine-job", "version": 1, "job": "print", "values": {"width": "wide"}})", "width"},
             {R"({"format": "vitrine-job", "version": 1, "job": "print", "values": {"files": [3]}})", "files"}}) {
        try {
            static_cast<void>(savedSettings(text, "kept.json"));
            ADD_FAILURE() << text;
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find("kept.json"), std::string::npos) << failure.what();
            EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << failure.what();
        }
    }
    const SavedSettings odd = savedSettings(
        R"({"format": "vitrine-job", "version": 1, "job": "print", "values": {"velvet": 1, "views": 9999}})",
        "kept.json");
    EXPECT_EQ(odd.notes.size(), 2U);
    EXPECT_EQ(odd.values[table_.views], mostViews);
}

TEST_F(SettingsText, TheWrittenPrintCarriesItsSettingsAndComesBack)
{
    values_.set(table_.phase, 0.125);
    values_.set(table_.bits, PrintBits::sixteen);
    values_.set(table_.reverse, true);
    const fs::path file = folder_.path() / "print.tif";
    values_ = withPictures(values_, {"a.png", "b.png"});
    exportPrint(values_, solid(12).get(), file);
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"print.tif", "print.tif.json"}));
    const SavedSettings beside = savedSettings(settingsIn(file), file.string());
    EXPECT_TRUE(beside.values == values_);
    EXPECT_EQ(picturesOf(beside.values), (std::vector<std::string>{"a.png", "b.png"}));
    fs::remove(file.string() + ".json");
    EXPECT_TRUE(savedSettings(settingsIn(file), file.string()).values == values_);  // From inside the file.
}

}  // namespace
}  // namespace vitrine::printing
