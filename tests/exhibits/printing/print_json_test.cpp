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

TEST_F(SettingsText, EverySettingSurvivesItsTextWhateverItIs)
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
            values.setRow(i, x);
        }
        if (printPlan(values, nullptr, false, "p.tif").refusal.empty()) ++possible;
        const std::vector<std::string> files{"/a/view 1.png", "ü.png"};
        const SavedSettings back = savedSettings(settingsText(values, files), "kept.json");
        EXPECT_EQ(back.sources, files);
        for (std::size_t i = 0; i < values.rows().size(); ++i)
            EXPECT_EQ(back.values.row(i), values.row(i)) << values.rows()[i].name;
    }
    EXPECT_GT(possible, 3);  // Control: not all settings were refused.
}

TEST_F(SettingsText, APrintOfTheCommandLineBringsItsSettingsBack)
{
    PrintSettings s;
    s.sheet = knownSheet("75-measured");
    s.dpiX = 720;
    s.dpiY = 360;
    s.width = 70;
    s.height = 41.5;
    s.direction = 90;
    s.reverse = true;
    s.views = 7;
    s.method = Method::guard;
    const std::string text = render::writeJson(printJson(PrintLayout(s), 720, {"one.png"}));
    const SavedSettings back = savedSettings(text, "print.tif.json");
    EXPECT_TRUE(back.sources.empty());
    const PrintSettings read = printSettings(back.values, 7);
    EXPECT_EQ(printJson(PrintLayout(read), 720, {})["print"], printJson(PrintLayout(s), 720, {})["print"]);
    EXPECT_NEAR(read.sheet.radius, s.sheet.radius, 1e-12);
    EXPECT_NEAR(read.sheet.thickness, s.sheet.thickness, 1e-12);
    EXPECT_EQ(sheets_.nameOf(sheetOf(back.values)), "75-measured");
    EXPECT_TRUE(std::isinf(back.values[table_.distance]));
}

TEST_F(SettingsText, BrokenSettingsNameFileAndKey)
{
    for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
             {"{}", "vitrinePrint"},
             {R"({"vitrinePrint": 2})", "vitrinePrint"},
             {R"({"vitrinePrint": 1, "desk": {"values": {"width": "wide"}}})", "width"},
             {R"({"vitrinePrint": 1, "desk": {"values": {}, "files": [3]}})", "desk.files"},
             {R"({"vitrinePrint": 1, "print": {}})", "sheet"}}) {
        try {
            static_cast<void>(savedSettings(text, "kept.json"));
            ADD_FAILURE() << text;
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find("kept.json"), std::string::npos) << failure.what();
            EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << failure.what();
        }
    }
    const SavedSettings odd =
        savedSettings(R"({"vitrinePrint": 1, "desk": {"values": {"velvet": 1, "views": 9999}}})", "kept.json");
    EXPECT_EQ(odd.notes.size(), 2U);
    EXPECT_EQ(odd.values[table_.views], mostViews);
}

TEST_F(SettingsText, TheWrittenPrintCarriesItsSettingsAndComesBack)
{
    values_.set(table_.phase, 0.125);
    values_.set(table_.bits, PrintBits::sixteen);
    values_.set(table_.reverse, true);
    const fs::path file = folder_.path() / "print.tif";
    exportPrint(values_, solid(12).get(), {"a.png", "b.png"}, file, {});
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"print.tif", "print.tif.json"}));
    const SavedSettings beside = savedSettings(settingsIn(file), file.string());
    EXPECT_TRUE(beside.values == values_);
    EXPECT_EQ(beside.sources, (std::vector<std::string>{"a.png", "b.png"}));
    fs::remove(file.string() + ".json");
    EXPECT_TRUE(savedSettings(settingsIn(file), file.string()).values == values_);  // From inside the file.
}

}  // namespace
}  // namespace vitrine::printing
