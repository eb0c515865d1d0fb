// The desk that the print dialog sits at, without a window.
#include "samples.h"

#include "exhibits/printing/desk_settings.h"
#include "exhibits/printing/eye_lines.h"
#include "exhibits/printing/lenticular_desk.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include <cmath>
#include <fstream>
#include <random>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

constexpr double degree = 3.14159265358979323846 / 180;

class Desk : public testing::Test {
protected:
    vitrine::test::TemporaryFolder folder_;
    LenticularDesk desk_{folder_.path() / "config" / "sheets.json"};
    const DeskTable& table_ = desk_.table();
    ParameterValues values_ = table_.initial();

    void SetUp() override
    {
        values_.set(table_.origin, ViewOrigin::files);
        values_.set(table_.width, 0.03);
        values_.set(table_.height, 0.02);
    }
    /// View k is one level of gray, (k + 1) / (count + 1) of linear light.
    std::shared_ptr<const PrintViews> solid(int count) const
    {
        const std::shared_ptr<PrintViews> views = desk_.newViews();
        for (int k = 0; k < count; ++k) views->add(render::Image(24, 16, 3, static_cast<float>(k + 1) / static_cast<float>(count + 1)));
        return views;
    }
};

TEST_F(Desk, NumbersFollowTheClosedFormsWhenLpiDpiAndDistanceChange)
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
        const PrintSummary summary = desk_.summary(values_, nullptr, false, "print.tif");
        ASSERT_EQ(summary.refusal, "");
        // A sheet of 30 degrees, focused on its back: t - r = t/n, t = n p / (2 tan 15), print pitch p (D + t)/(D + r).
        const double pitch = 25.4 / lpi;
        const double thickness = 1.56 * pitch / (2 * std::tan(15 * degree));
        const double radius = thickness * 0.56 / 1.56;
        const double stretch = (distance * 1000 + thickness) / (distance * 1000 + radius);
        EXPECT_NEAR(summary.pixelsPerLens, dpi / lpi * stretch, 1e-6 * dpi / lpi);
        EXPECT_NEAR(summary.storedLpi, lpi / stretch, 1e-4);  // TIFF stores dpi with 24 bits.
        EXPECT_NEAR(summary.depthBudget, 2 * std::min(12.0, std::floor(dpi / lpi * stretch)) * thickness / 1.56 / 1000, 1e-9);
        EXPECT_EQ(summary.width, std::llround(0.03 / 0.0254 * dpi));
    }
}

TEST_F(Desk, RefusesWhatCannotBeWithTheLimitAndKeepsWhatIsTyped)
{
    values_.set(table_.lens, LensShape::given);
    values_.set(table_.lensesPerInch, 20.0);
    values_.set(table_.radius, 0.0005);  // A pitch of 1.27 mm needs 0.635.
    const PrintSummary summary = desk_.summary(values_, nullptr, false, "print.tif");
    EXPECT_NE(summary.refusal.find("0.635"), std::string::npos) << summary.refusal;
    EXPECT_TRUE(summary.ownShare.empty());
    EXPECT_THROW(static_cast<void>(desk_.preview(values_, solid(2))), Failure);
    const PrintDesk::Settings back = desk_.settingsFrom(desk_.settingsText(values_, {}), "kept.json");
    EXPECT_TRUE(back.values == values_);
    values_.set(table_.radius, 0.0007);
    values_.set(table_.thickness, 0.002);
    EXPECT_EQ(desk_.summary(values_, nullptr, false, "print.tif").refusal, "");
}

TEST_F(Desk, WarnsOfMoreViewsThanDotsAndOfLpiNearDpiAndOnlyThen)
{
    const auto said = [&] {
        std::string all;
        for (const std::string& warning : desk_.summary(values_, nullptr, false, "print.tif").warnings) all += warning + '\n';
        return all;
    };
    EXPECT_EQ(said(), "");
    values_.set(table_.views, 40);
    EXPECT_NE(said().find("40 views share"), std::string::npos) << said();
    values_.set(table_.views, 12);
    values_.set(table_.dotsPerInch, 100.0);
    EXPECT_NE(said().find("cannot separate"), std::string::npos) << said();
    values_.set(table_.dotsPerInch, 59.0);
    EXPECT_NE(desk_.summary(values_, nullptr, false, "print.tif").refusal.find("no more than one pixel"), std::string::npos);
}

TEST_F(Desk, EverySettingSurvivesItsTextWhateverItIs)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    int possible = 0;
    for (int turn = 0; turn < 40; ++turn) {
        ParameterValues values = table_.initial();
        for (std::size_t i = 0; i < values.rows().size(); ++i) {
            const ParameterInfo& row = values.rows()[i];
            double x = row.range.softLow + unit(random) * (row.range.softHigh - row.range.softLow);
            if (row.kind != Kind::real) x = std::floor(row.range.low + unit(random) * (std::min(row.range.high, row.range.softHigh) + 1 - row.range.low));
            values.setRow(i, x);
        }
        if (desk_.summary(values, nullptr, false, "p.tif").refusal.empty()) ++possible;
        const std::vector<std::string> files{"/a/view 1.png", "ü.png"};
        const PrintDesk::Settings back = desk_.settingsFrom(desk_.settingsText(values, files), "kept.json");
        EXPECT_EQ(back.sources, files);
        for (std::size_t i = 0; i < values.rows().size(); ++i) EXPECT_EQ(back.values.row(i), values.row(i)) << values.rows()[i].name;
    }
    EXPECT_GT(possible, 3);  // Otherwise nothing but refused settings was tried.
}

TEST_F(Desk, APrintOfTheCommandLineBringsItsSettingsBack)
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
    const PrintDesk::Settings back = desk_.settingsFrom(text, "print.tif.json");
    EXPECT_TRUE(back.sources.empty());
    const PrintSettings read = printSettings(table_, back.values, 7);
    EXPECT_EQ(printJson(PrintLayout(read), 720, {})["print"], printJson(PrintLayout(s), 720, {})["print"]);
    EXPECT_NEAR(read.sheet.radius, s.sheet.radius, 1e-12);
    EXPECT_NEAR(read.sheet.thickness, s.sheet.thickness, 1e-12);
    EXPECT_EQ(desk_.sheetName(back.values), "75-measured");
    EXPECT_TRUE(back.values[table_.infiniteDistance]);
}

TEST_F(Desk, BrokenSettingsNameFileAndKey)
{
    for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
             {"{}", "vitrinePrint"},
             {R"({"vitrinePrint": 2})", "vitrinePrint"},
             {R"({"vitrinePrint": 1, "desk": {"values": {"width": "wide"}}})", "width"},
             {R"({"vitrinePrint": 1, "desk": {"values": {}, "files": [3]}})", "desk.files"},
             {R"({"vitrinePrint": 1, "print": {}})", "sheet"}}) {
        try {
            static_cast<void>(desk_.settingsFrom(text, "kept.json"));
            ADD_FAILURE() << text;
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find("kept.json"), std::string::npos) << failure.what();
            EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << failure.what();
        }
    }
    const PrintDesk::Settings odd = desk_.settingsFrom(R"({"vitrinePrint": 1, "desk": {"values": {"velvet": 1, "views": 9999}}})", "kept.json");
    EXPECT_EQ(odd.notes.size(), 2U);
    EXPECT_EQ(odd.values[table_.views], mostViews);
}

TEST_F(Desk, EverySheetOfTheListIsFoundByItsNumbers)
{
    std::string problem;
    for (const SheetEntry& sheet : desk_.sheets(problem)) EXPECT_EQ(desk_.sheetName(desk_.withSheet(values_, sheet.name)), sheet.name);
    values_.set(table_.refractiveIndex, 1.51);
    EXPECT_EQ(desk_.sheetName(values_), "");
    EXPECT_EQ(problem, "");
}

TEST_F(Desk, OfSheetsWithTheSameNumbersTheOneThatIsMeantIsFound)
{
    const std::string shipped = desk_.sheetName(values_);
    ASSERT_NE(shipped, "");
    desk_.saveSheet(values_, "Mine");
    EXPECT_EQ(desk_.sheetName(values_), shipped);
    EXPECT_EQ(desk_.sheetName(values_, "Mine"), "Mine");
    EXPECT_EQ(desk_.sheetName(values_, shipped), shipped);
    values_.set(table_.refractiveIndex, 1.51);
    EXPECT_EQ(desk_.sheetName(values_, "Mine"), "") << "it has other numbers";
}

TEST_F(Desk, AFlipUnderUprightLensesIsToldToShowEachEyeAnotherPicture)
{
    const auto warns = [&] {
        const PrintSummary summary = desk_.summary(values_, nullptr, false, "a.tif");
        EXPECT_EQ(summary.refusal, "");
        return std::any_of(summary.warnings.begin(), summary.warnings.end(), [](const std::string& w) { return w.find("each eye sees another picture") != std::string::npos; });
    };
    values_ = desk_.withSheet(values_, "60-3d");
    EXPECT_FALSE(warns());
    values_ = desk_.withSheet(values_, "60-flip");
    EXPECT_TRUE(warns());
    values_.set(table_.direction, std::numbers::pi / 2);
    EXPECT_FALSE(warns());
}

TEST_F(Desk, SheetsOfTheUsersOwnAreKeptAndABrokenListIsNeverWrittenOver)
{
    values_.set(table_.measuredPerInch, 60.12);
    desk_.saveSheet(values_, "Mine");
    values_.set(table_.measuredPerInch, 60.13);
    desk_.saveSheet(values_, "Mine");
    std::string problem;
    std::vector<SheetEntry> all = LenticularDesk(folder_.path() / "config" / "sheets.json").sheets(problem);
    ASSERT_EQ(all.size(), knownSheets().size() + 1);
    EXPECT_EQ(all.back().name, "Mine");
    EXPECT_TRUE(all.back().own);
    EXPECT_EQ(desk_.withSheet(table_.initial(), "Mine")[table_.measuredPerInch], 60.13);
    EXPECT_EQ(desk_.sheetName(values_), "Mine");
    EXPECT_THROW(desk_.saveSheet(values_, "60-3d"), Failure);
    desk_.removeSheet("Mine");
    EXPECT_EQ(desk_.sheets(problem).size(), knownSheets().size());
    EXPECT_EQ(problem, "");

    const std::string broken = "{\"format\": \"vitrine-sheets\", \"version\": 1, \"sheets\": [{\"name\": \"x\"}]}";
    std::ofstream(folder_.path() / "config" / "sheets.json") << broken;
    EXPECT_EQ(desk_.sheets(problem).size(), knownSheets().size());
    EXPECT_NE(problem.find("sheets.json"), std::string::npos) << problem;
    EXPECT_THROW(desk_.saveSheet(values_, "Mine"), Failure);
    EXPECT_EQ(render::readFile(folder_.path() / "config" / "sheets.json", 10000), broken);
}

TEST_F(Desk, ThePreviewIsTheFileDotForDot)
{
    values_.set(table_.dotsPerInch, 300.0);
    values_.set(table_.dotsDown, 150.0);
    for (const double direction : {0.0, 90.0, -20.0}) {
        for (const bool mirror : {false, true}) {
            values_.set(table_.direction, direction * degree);
            values_.set(table_.mirror, mirror);
            const auto views = solid(5);
            const fs::path file = folder_.path() / "print.png";
            ASSERT_EQ(desk_.write(values_, views, {}, file, {}), std::vector<fs::path>{file});
            const render::Image written = render::readImage(file, {.raw = true});
            const auto preview = desk_.preview(values_, views);
            ASSERT_EQ(preview->width(), written.width);
            const CodedPicture part = preview->raster(10, 5, 60, 40);
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x)
                    ASSERT_EQ(part.rgb[static_cast<std::size_t>(y * part.width + x) * 3], std::lround(written.at(x + 10, y + 5) * 255)) << x << ' ' << y;
        }
    }
}

TEST_F(Desk, LensesAreDrawnWhereTheRasterChangesLens)
{
    // Two views, black and white: under every lens the raster goes from one to the other at its axis and back at
    // its cusp, where the grid must be a whole number.
    const auto views = desk_.newViews();
    views->add(render::Image(8, 8, 3, 0.0F));
    views->add(render::Image(8, 8, 3, 1.0F));
    for (const bool mirror : {false, true}) {
        values_.set(table_.mirror, mirror);
        values_.set(table_.phase, 0.3);
        const auto preview = desk_.preview(values_, views);
        const LensGrid grid = preview->lenses();
        const CodedPicture row = preview->raster(0, 3, preview->width(), 4);
        int edges = 0;
        for (int x = 1; x < row.width; ++x) {
            const int before = row.rgb[static_cast<std::size_t>(x - 1) * 3];
            const int after = row.rgb[static_cast<std::size_t>(x) * 3];
            if (std::abs(before - after) < 200) continue;
            // Under a lens the last view, white, lies on the left, so a cusp is where black turns white.
            const double at = grid.at0 + grid.perX * x + grid.perY * 3.5;
            const bool cusp = (before < after) != mirror;
            EXPECT_LT(std::abs(at - std::round(at) - (cusp ? 0 : 0.5) * (at > std::round(at) ? 1 : -1)), 1.0 / 12) << x;
            ++edges;
        }
        EXPECT_GT(edges, 60);
    }
}

/// Mean of a picture's gray, in linear light, leaving out the outer eighth.
double middleLevel(const CodedPicture& picture)
{
    double sum = 0;
    int count = 0;
    for (int y = picture.height / 8; y < picture.height * 7 / 8; ++y)
        for (int x = picture.width / 8; x < picture.width * 7 / 8; ++x, ++count)
            sum += render::linearFromSrgb(picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3] / 255.0);
    return sum / count;
}

TEST_F(Desk, EveryViewIsSeenAtItsAngleInOrderAndTheZoneStartsAgain)
{
    values_.set(table_.infiniteDistance, true);
    values_.set(table_.dotsPerInch, 1440.0);
    const int count = 6;
    for (const double direction : {0.0, 90.0, 15.0}) {
        values_.set(table_.direction, direction * degree);
        const PrintLayout layout(printSettings(table_, values_, count));
        const auto preview = desk_.preview(values_, solid(count));
        for (int k = 0; k < count; ++k) {
            const double angle = angleOfView(layout, k);
            // Across the lenses: to the right for upright ones, below for horizontal ones.
            const double slant = direction * degree;
            const PrintEye eye = direction == 90 ? PrintEye{0, -angle} : PrintEye{std::atan(std::tan(angle) * std::cos(slant)), -std::atan(std::tan(angle) * std::sin(slant))};
            // One view's level from the next is 1/7; cross-talk comes from both neighbors and mostly cancels.
            EXPECT_NEAR(middleLevel(preview->seen(eye, 200)), (k + 1.0) / (count + 1), direction == 15 ? 0.06 : 0.04) << direction << " view " << k;
        }
    }
}

TEST_F(Desk, TheQuickLookAgreesWithTheProofOfTheFinishedFile)
{
    values_.set(table_.dotsPerInch, 600.0);
    values_.set(table_.width, 0.02);
    values_.set(table_.height, 0.015);
    const int count = 8;
    const auto views = desk_.newViews();
    // Each view a gradient of its own, so that place and view both count.
    for (int k = 0; k < count; ++k) {
        render::Image image(120, 90, 3);
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x)
                for (int c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>((0.2 + 0.5 * x / 120 + 0.2 * y / 90) * (c == k % 3 ? 1 : 0.5));
        views->add(image);
    }
    const PrintLayout layout(printSettings(table_, values_, count));
    const fs::path file = folder_.path() / "print.tif";
    desk_.write(values_, views, {}, file, {});
    const render::Image raster = render::readImage(file);
    const auto preview = desk_.preview(values_, views);
    for (const double angle : {-12.0, -5.0, 0.0, 3.0, 11.0, 22.0}) {
        const render::Image proof = lookThrough(layout, raster, {angle * degree, 4 * degree, 400});
        const CodedPicture quick = preview->seen({angle * degree, 4 * degree, 0.4}, 470);
        double difference = 0;
        for (int y = 2; y < proof.height - 2; ++y) {
            for (int x = 2; x < proof.width - 2; ++x) {
                const int u = (2 * x + 1) * quick.width / (2 * proof.width);
                const int v = (2 * y + 1) * quick.height / (2 * proof.height);
                for (int c = 0; c < 3; ++c)
                    difference += std::abs(static_cast<double>(proof.at(x, y, c)) - render::linearFromSrgb(quick.rgb[static_cast<std::size_t>(v * quick.width + u) * 3 + static_cast<std::size_t>(c)] / 255.0));
            }
        }
        // 8-bit codes, 32 parts of the aperture against 128, 512 directions: about one percent of the light.
        EXPECT_LT(difference / (3.0 * (proof.width - 4) * (proof.height - 4)), 0.012) << angle;
    }
}

TEST_F(Desk, TheWrittenPrintCarriesItsSettingsAndComesBack)
{
    values_.set(table_.phase, 0.125);
    values_.set(table_.bits, 1);
    values_.set(table_.reverse, true);
    const fs::path file = folder_.path() / "print.tif";
    desk_.write(values_, solid(12), {"a.png", "b.png"}, file, {});
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"print.tif", "print.tif.json"}));
    const PrintDesk::Settings beside = desk_.settingsFrom(desk_.settingsIn(file), file.string());
    EXPECT_TRUE(beside.values == values_);
    EXPECT_EQ(beside.sources, (std::vector<std::string>{"a.png", "b.png"}));
    fs::remove(file.string() + ".json");
    EXPECT_TRUE(desk_.settingsFrom(desk_.settingsIn(file), file.string()).values == values_);  // The one inside.
}

TEST_F(Desk, StoppingOrFailingLeavesTheOldFilesAsTheyWere)
{
    values_.set(table_.width, 0.2);
    values_.set(table_.height, 0.2);
    const fs::path file = folder_.path() / "print.tif";
    std::ofstream(file) << "old";
    double told = 0;
    const PrintProgress stopHalfway = [&](double part) {
        told = part;
        return part < 0.3;
    };
    EXPECT_THROW(desk_.write(values_, solid(3), {}, file, stopHalfway), PrintStopped);
    EXPECT_GT(told, 0);
    EXPECT_LT(told, 1);
    EXPECT_EQ(render::readFile(file, 100), "old");
    EXPECT_EQ(folder_.files(), std::vector<std::string>{"print.tif"});
    EXPECT_THROW(desk_.write(values_, solid(3), {}, folder_.path() / "nowhere" / "print.tif", {}), Failure);
    EXPECT_THROW(desk_.write(values_, solid(3), {}, folder_.path() / "print.bmp", {}), Failure);
    EXPECT_EQ(folder_.files(), std::vector<std::string>{"print.tif"});
}

TEST_F(Desk, ChartsArePreviewedAndWrittenAsThePrintsAre)
{
    values_.set(table_.width, 0.1);
    values_.set(table_.height, 0.06);
    for (const ChartKind kind : {ChartKind::pitch, ChartKind::phase, ChartKind::views, ChartKind::rotation}) {
        values_.set(table_.chart, kind);
        EXPECT_EQ(desk_.summary(values_, nullptr, true, "chart.png").refusal, "");
        const fs::path file = folder_.path() / "chart.png";
        desk_.write(values_, nullptr, {}, file, {});
        const render::Image written = render::readImage(file, {.raw = true});
        const CodedPicture part = desk_.preview(values_, nullptr)->raster(400, 300, 460, 340);
        for (int x = 0; x < part.width; ++x) ASSERT_EQ(part.rgb[static_cast<std::size_t>(x) * 3], std::lround(written.at(x + 400, 300) * 255));
    }
    values_.set(table_.height, 0.03);
    EXPECT_NE(desk_.summary(values_, nullptr, true, "chart.png").refusal.find("44 mm"), std::string::npos);
}

TEST_F(Desk, ReadsFilesSpreadEvenlyAndQuiltsFromTheBottomLeft)
{
    std::vector<std::string> files;
    for (int k = 0; k < 9; ++k) {
        files.push_back((folder_.path() / ("v" + std::to_string(k) + ".png")).string());
        render::writePicture(files.back(), render::Image(8, 8, 3, static_cast<float>(k) / 8), render::PictureFormat::png16);
    }
    values_.set(table_.views, 3);
    const auto three = std::static_pointer_cast<const DeskViews>(desk_.readViews(values_, files, {}));
    ASSERT_EQ(three->count(), 3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(three->full().row(k, 0)[0], 65535.0 * k / 2, 12);
    values_.set(table_.views, 40);
    EXPECT_EQ(desk_.readViews(values_, {folder_.path().string()}, {})->count(), 9);  // No more than there are.
    EXPECT_THROW(static_cast<void>(desk_.readViews(values_, {}, {})), Failure);
    EXPECT_THROW(static_cast<void>(desk_.readViews(values_, files, [](double part) { return part < 0.5; })), PrintStopped);

    render::Image quilt(8, 4, 3);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) quilt.at(x, y, c) = static_cast<float>((y < 2 ? 2 : 0) + (x < 4 ? 0 : 1)) / 3;
    render::writePicture(folder_.path() / "quilt.png", quilt, render::PictureFormat::png16);
    values_.set(table_.origin, ViewOrigin::quilt);
    values_.set(table_.quiltColumns, 2);
    values_.set(table_.quiltRows, 2);
    const auto four = std::static_pointer_cast<const DeskViews>(desk_.readViews(values_, {(folder_.path() / "quilt.png").string()}, {}));
    ASSERT_EQ(four->count(), 4);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(four->full().row(k, 0)[0], 65535.0 * k / 3, 12);
}

TEST_F(Desk, ShotsStandAsTheLensesShowAndDraftsAreTheSameButSmall)
{
    Look look{{}, {{0, 1.6, 4}, {0, 1.2, 0}, 0.9}};
    const auto fine = desk_.shots(values_, look, {}, false);
    const auto draft = desk_.shots(values_, look, {}, true);
    ASSERT_EQ(fine.size(), 12U);
    ASSERT_EQ(draft.size(), 12U);
    for (std::size_t k = 0; k + 1 < fine.size(); ++k) EXPECT_GT(fine[k + 1].look.camera.eye.x, fine[k].look.camera.eye.x);
    EXPECT_EQ(fine[3].look.camera, draft[3].look.camera);
    EXPECT_EQ(fine[0].request.frame.raster.size.x, 960);
    EXPECT_LE(draft[0].request.frame.raster.size.x, 240);
    EXPECT_NEAR(static_cast<double>(fine[0].request.frame.raster.size.y) / 960, 0.02 / 0.03, 1e-3);
    values_.set(table_.baselineScale, 0.0);
    const auto flat = desk_.shots(values_, look, {}, false);
    EXPECT_EQ(flat[0].look.camera.eye, flat[11].look.camera.eye);

    ParameterValues other = values_;
    other.set(table_.phase, 0.2);
    EXPECT_TRUE(desk_.sameViews(values_, other));
    other.set(table_.lensesPerInch, 40.0);
    EXPECT_TRUE(desk_.sameViews(values_, other));  // Files stay what they are,
    ParameterValues shown = desk_.withOrigin(values_, ViewOrigin::shown);
    ParameterValues shownCoarser = desk_.withOrigin(other, ViewOrigin::shown);
    EXPECT_FALSE(desk_.sameViews(shown, shownCoarser));  // and cameras stand where the lenses need them.
    EXPECT_FALSE(desk_.sameViews(values_, shown));
}

TEST_F(Desk, TheBaselineScaleThatFitsHoldsTheSceneAndALargerOneDoesNot)
{
    values_ = desk_.withOrigin(values_, ViewOrigin::shown);
    const Look look{{}, {{0, 1.6, 4}, {0, 1.2, 0}, 0.9}};
    render::Image picture(20, 10, 5, 1.0F);
    picture.channelNames = {"R", "G", "B", "A", "depth.Z"};
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 10; ++y) picture.at(x, y, 4) = 2.0F + static_cast<float>(x);
    const SceneDepth deep = desk_.sceneDepth(values_, look, picture);
    EXPECT_NEAR(deep.nearest, 2, 0.01);
    EXPECT_NEAR(deep.farthest, 21, 0.01);
    EXPECT_FALSE(deep.warnings.empty());
    ASSERT_LT(deep.scaleThatHolds, 1);
    const SceneDepth held = desk_.sceneDepth(desk_.withBaselineScale(values_, deep.scaleThatHolds), look, picture);
    EXPECT_LE(held.nearestHeld, held.nearest * (1 + 1e-9));
    EXPECT_GE(held.farthestHeld, held.farthest * (1 - 1e-9));
    EXPECT_TRUE(held.warnings.empty());
    const SceneDepth more = desk_.sceneDepth(desk_.withBaselineScale(values_, deep.scaleThatHolds * 1.05), look, picture);
    EXPECT_FALSE(more.warnings.empty());
}

}  // namespace
}  // namespace vitrine::printing
