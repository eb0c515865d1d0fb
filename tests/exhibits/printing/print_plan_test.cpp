#include "exhibits/printing/print_json.h"
#include "exhibits/printing/print_plan.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"
#include "tests/exhibits/printing/set_up_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

using test::degree;

class PrintPlans : public test::SetUpPrint {};

using LongPrintPlans = PrintPlans;

TEST_F(LongPrintPlans, NumbersFollowTheClosedFormsWhenLpiDpiAndDistanceChange)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 40; ++i) {
        const double lpi = 20 + 80 * unit(random);
        const double dpi = 300 + 1200 * unit(random);
        const double distance = 0.2 + 3 * unit(random);
        values_.set(table_.lensesPerInch, lpi);
        values_.set(table_.dotsPerInch, dpi);
        values_.set(table_.distance, distance);
        const PrintPlan plan = printPlan(values_, nullptr, "print.tif");
        ASSERT_EQ(plan.refusal, "");
        // A sheet of 30 degrees, focused on its back: t - r = t/n, t = n p / (2 tan 15), print pitch p (D + t)/(D + r).
        const double pitch = 25.4 / lpi;
        const double thickness = 1.56 * pitch / (2 * std::tan(15 * degree));
        const double radius = thickness * 0.56 / 1.56;
        const double stretch = (distance * 1000 + thickness) / (distance * 1000 + radius);
        EXPECT_NEAR(plan.numbers.pixelsPerLens, dpi / lpi * stretch, 1e-6 * dpi / lpi);
        EXPECT_NEAR(plan.numbers.effectiveLpi, lpi / stretch, 1e-4);  // TIFF stores dpi with 24 bits.
        EXPECT_NEAR(plan.numbers.depthBudget, 2 * std::min(12.0, std::floor(dpi / lpi * stretch)) * thickness / 1.56,
                    1e-6);
        EXPECT_EQ(plan.layout->width(), std::llround(0.03 / 0.0254 * dpi));
    }
}

TEST_F(PrintPlans, RefusesSidesBeyondTheFormatUnlessTheyAreCut)
{
    values_.set(table_.width, 50.0);  // 1,417,323 pixels at 720 dpi; a TIFF ends at 1,048,576.
    EXPECT_NE(printPlan(values_, nullptr, "print.tif").refusal.find("1048576"), std::string::npos);
    EXPECT_EQ(printPlan(values_, nullptr, "print.png").refusal, "");
    values_.set(table_.tileWidth, 25.0);
    EXPECT_EQ(printPlan(values_, nullptr, "print.tif").refusal, "");
}

TEST_F(PrintPlans, RefusesWhatCannotBeWithTheLimitAndKeepsWhatIsTyped)
{
    values_.set(table_.lens, LensShape::given);
    values_.set(table_.lensesPerInch, 20.0);
    values_.set(table_.radius, 0.0005);  // A pitch of 1.27 mm needs 0.635.
    const PrintPlan plan = printPlan(values_, nullptr, "print.tif");
    EXPECT_NE(plan.refusal.find("0.635"), std::string::npos) << plan.refusal;
    EXPECT_TRUE(plan.numbers.ownShare.empty());
    EXPECT_THROW(static_cast<void>(printPreview(values_, solid(2))), Failure);
    const SavedSettings back = savedSettings(settingsText(values_), "kept.json");
    EXPECT_TRUE(back.values == values_);
    values_.set(table_.radius, 0.0007);
    values_.set(table_.thickness, 0.002);
    EXPECT_EQ(printPlan(values_, nullptr, "print.tif").refusal, "");
}

TEST_F(PrintPlans, WarnsOfMoreViewsThanDotsAndOfLpiNearDpiAndOnlyThen)
{
    const auto said = [&] {
        std::string all;
        for (const std::string& warning : printPlan(values_, nullptr, "print.tif").warnings) all += warning + '\n';
        return all;
    };
    EXPECT_EQ(said(), "");
    values_.set(table_.views, 40);
    EXPECT_NE(said().find("40 views share"), std::string::npos) << said();
    values_.set(table_.views, 12);
    values_.set(table_.dotsPerInch, 100.0);
    EXPECT_NE(said().find("cannot separate"), std::string::npos) << said();
    values_.set(table_.dotsPerInch, 59.0);
    EXPECT_NE(printPlan(values_, nullptr, "print.tif").refusal.find("no more than one pixel"), std::string::npos);
}

TEST_F(PrintPlans, AFlipUnderUprightLensesIsToldToShowEachEyeAnotherPicture)
{
    const auto warns = [&] {
        const PrintPlan plan = printPlan(values_, nullptr, "a.tif");
        EXPECT_EQ(plan.refusal, "");
        return std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& w) {
            return w.find("each eye sees another picture") != std::string::npos;
        });
    };
    values_ = withSheet(values_, knownSheet("60-3d"));
    EXPECT_FALSE(warns());
    values_ = withSheet(values_, knownSheet("60-flip"));
    EXPECT_TRUE(warns());
    values_.set(table_.direction, std::numbers::pi / 2);
    EXPECT_FALSE(warns());
}

TEST_F(PrintPlans, StoppingOrFailingLeavesTheOldFilesAsTheyWere)
{
    values_.set(table_.width, 0.2);
    values_.set(table_.height, 0.2);
    const fs::path file = folder_.path() / "print.tif";
    std::ofstream(file) << "old";
    double told = 0;
    const Progress stopHalfway = [&](double part) {
        told = part;
        return part < 0.3;
    };
    EXPECT_THROW(exportPrint(values_, solid(3).get(), file, stopHalfway), Failure);
    EXPECT_GT(told, 0);
    EXPECT_LT(told, 1);
    EXPECT_EQ(render::readFile(file, 100), "old");
    EXPECT_EQ(folder_.files(), std::vector<std::string>{"print.tif"});
    EXPECT_THROW(exportPrint(values_, solid(3).get(), folder_.path() / "nowhere" / "print.tif"), Failure);
    EXPECT_THROW(exportPrint(values_, solid(3).get(), folder_.path() / "print.bmp"), Failure);
    EXPECT_EQ(folder_.files(), std::vector<std::string>{"print.tif"});
}

TEST_F(LongPrintPlans, ChartsArePreviewedAndWrittenAsThePrintsAre)
{
    values_.set(table_.width, 0.1);
    values_.set(table_.height, 0.06);
    for (const ChartKind kind : {ChartKind::pitch, ChartKind::phase, ChartKind::views, ChartKind::rotation}) {
        values_.set(table_.chart, kind);
        EXPECT_EQ(printPlan(chartValues(values_), nullptr, "chart.png").refusal, "");
        const fs::path file = folder_.path() / "chart.png";
        exportPrint(chartValues(values_), nullptr, file);
        const render::Image written = render::readImage(file, {.raw = true});
        const CodedPicture part = printPreview(chartValues(values_), nullptr)->raster({400, 300, 460, 340});
        for (int x = 0; x < part.width; ++x)
            ASSERT_EQ(part.rgb[static_cast<std::size_t>(x) * 3], std::lround(written.at(x + 400, 300) * 255));
    }
    values_.set(table_.height, 0.03);
    EXPECT_NE(printPlan(chartValues(values_), nullptr, "chart.png").refusal.find("44 mm"), std::string::npos);
}

}  // namespace
}  // namespace vitrine::printing
