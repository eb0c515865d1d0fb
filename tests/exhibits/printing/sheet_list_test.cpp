#include "exhibits/printing/sheet_list.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "tests/exhibits/printing/set_up_print.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vitrine::printing {
namespace {

class Sheets : public test::SetUpPrint {
protected:
    SheetList sheets_{folder_.path() / "config" / "sheets.json"};

    void save(const std::string& name) const
    {
        Sheet sheet = sheetOf(values_);
        sheet.name = name;
        sheets_.save(sheet);
    }
};

TEST_F(Sheets, EverySheetOfTheListIsFoundByItsNumbers)
{
    std::string problem;
    for (const Sheet& sheet : sheets_.all(problem))
        EXPECT_EQ(sheets_.nameOf(sheetOf(withSheet(values_, sheet))), sheet.name);
    values_.set(table_.refractiveIndex, 1.51);
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_)), "");
    EXPECT_EQ(problem, "");
}

TEST_F(Sheets, OfSheetsWithTheSameNumbersTheOneThatIsMeantIsFound)
{
    const std::string shipped = sheets_.nameOf(sheetOf(values_));
    ASSERT_NE(shipped, "");
    save("Mine");
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_)), shipped);
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_), "Mine"), "Mine");
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_), shipped), shipped);
    values_.set(table_.refractiveIndex, 1.51);
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_), "Mine"), "") << "it has other numbers";
}

TEST_F(Sheets, SheetsOfTheUsersOwnAreKeptAndABrokenListIsNeverWrittenOver)
{
    values_.set(table_.measuredPerInch, 60.12);
    save("Mine");
    values_.set(table_.measuredPerInch, 60.13);
    save("Mine");
    std::string problem;
    std::vector<Sheet> all = SheetList(folder_.path() / "config" / "sheets.json").all(problem);
    ASSERT_EQ(all.size(), knownSheets().size() + 1);
    EXPECT_EQ(all.back().name, "Mine");
    EXPECT_EQ(withSheet(table_.initial(), sheets_.named("Mine"))[table_.measuredPerInch], 60.13);
    EXPECT_EQ(sheets_.nameOf(sheetOf(values_)), "Mine");
    EXPECT_THROW(save("60-3d"), Failure);
    sheets_.remove("Mine");
    EXPECT_EQ(sheets_.all(problem).size(), knownSheets().size());
    EXPECT_EQ(problem, "");

    const std::string broken = "{\"format\": \"vitrine-sheets\", \"version\": 1, \"sheets\": [{\"name\": \"x\"}]}";
    std::ofstream(folder_.path() / "config" / "sheets.json") << broken;
    EXPECT_EQ(sheets_.all(problem).size(), knownSheets().size());
    EXPECT_NE(problem.find("sheets.json"), std::string::npos) << problem;
    EXPECT_THROW(save("Mine"), Failure);
    EXPECT_EQ(render::readFile(folder_.path() / "config" / "sheets.json", 10000), broken);
}

}  // namespace
}  // namespace vitrine::printing
