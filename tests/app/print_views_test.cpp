// Prints of exhibits, quilts and sequences, as users make them.
#include "exhibits/jobs/kit/job_options.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/proof.h"
#include "exhibits/printing/sheet.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <random>
#include <thread>

namespace vitrine {
namespace {

using test::Ended;
using test::TemporaryFolder;
using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Returns the command for a print of 61 x 41 lenses, each of which shows exactly one pixel of a view of 61 x 41.
Words printing(const std::string& out, const Words& more = {})
{
    return Words{"print",  "--lpi",       "40",     "--dpi", "600", "--width-mm",
                 "38.735", "--height-mm", "26.035", "--out", out} +
           more;
}

const Words theMug{
    "--exhibit", "sdf_morph",   "--set", "hall.probeSize=32", "--set", "hall.shadowMapSize=512", "--samples",
    "1",         "--view-size", "61x41"};

/// Returns the mean difference over pixels and colors, in linear light.
double difference(const render::Image& a, const render::Image& b)
{
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::abs(static_cast<double>(a.at(x, y, c)) - static_cast<double>(b.at(x, y, c)));
    return sum / (3.0 * a.width * a.height);
}

std::string viewName(int k)
{
    return "views/view_0" + std::to_string(k) + ".png";
}

TEST(LongPrintExhibit, LooksThroughItsSheetLikeTheViewThatWasRenderedForThatAngle)
{
    const TemporaryFolder folder;
    const Ended ended = test::vitrine(
        printing(folder / "p.tif", theMug + Words{"--count", "4", "--turn", "160", "--save-views", folder / "views"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    const printing::PrintLayout layout(printing::settingsFromJson(render::readJson(folder / "p.tif.json")));
    ASSERT_EQ(layout.settings().views, 4);
    for (const int k : {0, 2}) {
        const double degrees = printing::angleOfView(layout, k) / printing::radiansPerDegree;
        ASSERT_EQ(test::vitrine(
                      {"proof", folder / "p.tif", "--angle=" + std::to_string(degrees), "--out", folder / "seen.png"})
                      .code,
                  0);
        const render::Image seen = render::readImage(folder / "seen.png");
        // Rows of the print are interpolated between rows of the view, which blurs it along the lens. Crosstalk of the
        // views and two roundings to 8 bits have less effect.
        const double own = difference(seen, render::readImage(folder / viewName(k)));
        EXPECT_LT(own, 0.02) << k;
        for (int other = 0; other < 4; ++other) {
            if (other == k) continue;
            EXPECT_GT(difference(seen, render::readImage(folder / viewName(other))), 2 * own)
                << k << " against " << other;
        }
    }
}

TEST(PrintExhibit, CarriesWhatBringsItsViewsBack)
{
    const TemporaryFolder folder;
    const Ended ended = test::vitrine(
        printing(folder / "p.png", theMug + Words{"--count", "3", "--baseline-scale", "fit", "--save-views",
                                                  folder / "views", "--sweep", "morph=0..1", "--seed", "5"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(test::withoutProgress(ended.err), "");  // A valid print prints no warning.
    const render::JsonDocument description = render::readJson(folder / "p.png.json");
    const render::Json &scene = description.root().at("scene"), &report = description.root().at("report");
    EXPECT_EQ(scene.at("exhibit"), "sdf_morph");
    EXPECT_EQ(scene.at("picture").at("seed"), 5);
    EXPECT_GT(report.at("rig").at("baseline").get<double>(), 0.001);
    EXPECT_EQ(report.at("rig").at("sweeps").at(0), "morph=0..1");
    EXPECT_EQ(report.at("sources").size(), 3U);
    for (int k = 0; k < 3; ++k) {
        const auto preset = render::embeddedPreset(folder / viewName(k));
        ASSERT_TRUE(preset);
        EXPECT_NEAR(render::Json::parse(*preset).at("values").value("sdf_morph.morph", 0.62), k / 2.0, 1e-12);
    }
    EXPECT_GT(difference(render::readImage(folder / viewName(0)), render::readImage(folder / viewName(2))), 0.01);
}

TEST(LongPrintExhibit, WarnsOfDepthThatThePrintCannotHold)
{
    const TemporaryFolder folder;
    const Ended ended = test::vitrine(printing(folder / "p.tif", theMug + Words{"--count", "2"}));
    ASSERT_EQ(ended.code, 0);
    EXPECT_NE(ended.err.find("without doubled contours"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("A baseline scale of"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("2 cameras over"), std::string::npos) << ended.out;
    const Ended reversed = test::vitrine(printing(folder / "p.tif", theMug + Words{"--count", "2", "--reverse"}));
    EXPECT_NE(reversed.err.find("inside out"), std::string::npos) << reversed.err;
}

TEST(PrintExhibit, RefusesInOneSentenceAndLeavesNothing)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "full/other.png", "x");
    const std::size_t before = folder.files().size();
    struct Bad {
        Words more;
        int code;
        std::vector<std::string> parts;
    };
    const std::string views = folder / "views";
    const Words mug = theMug + Words{"--count", "2", "--save-views", views};
    const Bad bad[] = {
        {{}, 2, {"no views", "--exhibit"}},
        {{"--exhibit", "sphinx"}, 2, {"sphinx", "vitrine list"}},
        {mug + Words{"--views", folder / "full"}, 2, {"only one of"}},
        {{"--views", folder / "full", "--save-views", views}, 2, {"--save-views", "--exhibit"}},
        {{"--views", folder / "full", "--set", "morph=1"}, 2, {"--set", "--exhibit"}},
        {{"--exhibit", "sdf_morph", "--count", "2", "--view-size", "9000x10"}, 2, {"8192"}},
        {mug + Words{"--baseline-scale", "wide"}, 2, {"--baseline-scale \"wide\""}},
        {mug + Words{"--baseline-scale=-1"}, 2, {"--baseline-scale \"-1\""}},
        {mug + Words{"--convergence=-1"}, 2, {"--convergence"}},
        {mug + Words{"--convergence", "0.001"}, 2, {"convergence plane", "0.001"}},
        {mug + Words{"--every", "2"}, 2, {"--every"}},
        {mug + Words{"--sweep", "morph"}, 2, {"--sweep", "morph=0..1"}},
        {mug + Words{"--sweep", "morph=0.."}, 2, {"--sweep"}},
        {mug + Words{"--sweep", "morph=0..lots"}, 2, {"lots"}},
        {mug + Words{"--sweep", "morph=0.3..0.3"}, 2, {"the same"}},
        {mug + Words{"--sweep", "material=opaque..glass"}, 2, {"material", "between"}},
        {mug + Words{"--sweep", "time=now..later"}, 2, {"--sweep time \"now\"", "number"}},
        {{"--exhibit", "sdf_morph", "--count", "2", "--view-size", "0x5"}, 2, {"--view-size"}},
        {{"--exhibit", "hall", "--turn", "90", "--count", "2", "--view-size", "60x40"}, 2, {"hall", "turned"}},
        {theMug + Words{"--count", "2", "--save-views", folder / "full"}, 5, {"other.png", "empty folder"}},
        {theMug + Words{"--count", "2", "--save-views", "/proc/nowhere"}, 5, {"/proc/nowhere"}},
        {mug + Words{"--preset", folder / "none.json"}, 5, {"none.json"}},
        {mug + Words{"--lpi", "0"}, 2, {}},
    };
    for (const Bad& b : bad) {
        const Ended ended = test::vitrine(printing(folder / "p.tif", b.more));
        EXPECT_EQ(ended.code, b.code) << ended.err << ::testing::PrintToString(b.more);
        for (const std::string& part : b.parts)
            EXPECT_NE(ended.err.find(part), std::string::npos) << part << " is missing in: " << ended.err;
        EXPECT_EQ(folder.files().size(), before) << ended.err;
        EXPECT_FALSE(std::filesystem::exists(views)) << ended.err;
    }
    for (const char* out : {"p.jpg", "p"})
        test::expectOneSentence(test::vitrine(printing(folder / out, mug)), {".png, .tif or .pdf"});
    test::expectOneSentence(test::vitrine(printing(folder / "missing/p.tif", mug)), {"missing"});
    EXPECT_FALSE(std::filesystem::exists(views));
}

TEST(LongPrintExhibit, StoppedByCtrlCLeavesNothing)
{
    const TemporaryFolder folder;
    const std::string views = folder / "views";
    const Words words = printing(folder / "p.tif", {"--exhibit", "sdf_morph", "--count", "4", "--samples", "4096",
                                                    "--view-size", "900x600", "--save-views", views});
    const pid_t child = test::startProgram(words);
    // The command has begun once the folder exists; 16000 samples are left then.
    for (int i = 0; i < 6000 && !std::filesystem::exists(views); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(std::filesystem::exists(views));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_TRUE(folder.files().empty());
    EXPECT_FALSE(std::filesystem::exists(views));
}

/// Returns view `k` of `count`, with a uniform level of light.
render::Image level(int k, int count, int width = 30, int height = 20)
{
    return render::Image(width, height, 3, static_cast<float>(k + 1) / static_cast<float>(count + 1));
}

/// Returns the number of the view that the center of a print shows from the angle of view `k`.
double viewShown(const TemporaryFolder& folder, int k, int count)
{
    const printing::PrintLayout layout(printing::settingsFromJson(render::readJson(folder / "p.tif.json")));
    const double degrees = printing::angleOfView(layout, k) / printing::radiansPerDegree;
    EXPECT_EQ(
        test::vitrine({"proof", folder / "p.tif", "--angle=" + std::to_string(degrees), "--out", folder / "seen.png"})
            .code,
        0);
    const render::Image seen = render::readImage(folder / "seen.png");
    return static_cast<double>(seen.at(seen.width / 2, seen.height / 2, 0)) * (count + 1) - 1;
}

TEST(LongPrintQuilt, ShowsItsCellsInTheOrderOfQuilts)
{
    const TemporaryFolder folder;
    render::Image quilt(90, 40, 3);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 90; ++x)
            for (int c = 0; c < 3; ++c) quilt.at(x, y, c) = level((1 - y / 20) * 3 + x / 30, 6).at(0, 0, 0);
    render::writePicture(folder / "quilt.png", quilt, render::PictureFormat::png16);
    const Words of{"--quilt", "3x2", folder / "quilt.png"};
    ASSERT_EQ(test::vitrine(printing(folder / "p.tif", of)).code, 0);
    for (const int k : {0, 2, 3, 5}) EXPECT_NEAR(viewShown(folder, k, 6), k, 0.3) << k;
    ASSERT_EQ(test::vitrine(printing(folder / "p.tif", of + Words{"--quilt-order", "top-left"})).code, 0);
    EXPECT_NEAR(viewShown(folder, 0, 6), 3, 0.3);
    EXPECT_NEAR(viewShown(folder, 5, 6), 2, 0.3);
    ASSERT_EQ(test::vitrine(printing(folder / "p.tif", of + Words{"--every", "2"})).code, 0);
    EXPECT_NEAR(viewShown(folder, 1, 6), 2, 0.3);

    std::filesystem::remove(folder / "p.tif");
    const auto refused = [&](const Words& more, int code, const std::vector<std::string>& parts) {
        const Ended ended = test::vitrine(printing(folder / "p.tif", more));
        EXPECT_EQ(ended.code, code) << ended.err;
        test::expectOneSentence(ended, parts);
        EXPECT_FALSE(std::filesystem::exists(folder / "p.tif"));
    };
    refused({"--quilt", "91x2", folder / "quilt.png"}, 2, {"90 x 40", "91 x 2"});
    refused({"--quilt", "many", folder / "quilt.png"}, 2, {"--quilt", "many", "such as --quilt 8x6"});
    refused({"--views", folder / "quilt.png", "--quilt-order", "top-left"}, 2, {"--quilt-order", "--quilt"});
    refused({"--quilt", "30x20", folder / "quilt.png"}, 2, {"600 views", "256"});
    refused({"--quilt", "3x2", folder / "none.png"}, 5, {"none.png"});
}

TEST(PrintQuilt, ThatDoesNotDivideIsCutFromTheBottomLeftAndSaysSo)
{
    const TemporaryFolder folder;
    render::Image quilt(92, 41, 3, 0.0F);  // Views of 30 x 20; 2 columns at the right and a row on top are black.
    for (int y = 1; y < 41; ++y)
        for (int x = 0; x < 90; ++x)
            for (int c = 0; c < 3; ++c) quilt.at(x, y, c) = level((1 - (y - 1) / 20) * 3 + x / 30, 6).at(0, 0, 0);
    render::writePicture(folder / "quilt.png", quilt, render::PictureFormat::png16);
    const Ended ended = test::vitrine(printing(folder / "p.tif", {"--quilt", "3X2", folder / "quilt.png"}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("they have 30 x 20 pixels, and a margin of 2 x 1 pixels"), std::string::npos) << ended.err;
    for (const int k : {0, 2, 3, 5}) EXPECT_NEAR(viewShown(folder, k, 6), k, 0.3) << k;
}

TEST(LongPrintPictures, OfAnotherShapeAreCroppedFittedOrStretchedAndThatIsSaid)
{
    const TemporaryFolder folder;
    // White with a black half in the middle, so that the edge of the print shows how the view was fitted. Aspect ratio
    // 2.98:1 for 1.49:1.
    render::Image wide(119, 40, 3, 1.0F);
    for (int y = 0; y < 40; ++y)
        for (int x = 30; x < 90; ++x)
            for (int c = 0; c < 3; ++c) wide.at(x, y, c) = 0;
    render::writePicture(folder / "a.png", wide, render::PictureFormat::png8);
    const auto seenWith = [&](const Words& more, const std::string& said) {
        const Ended ended =
            test::vitrine(printing(folder / "p.tif", Words{"--views", folder / "a.png", folder / "a.png"} + more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
        EXPECT_EQ(test::vitrine({"proof", folder / "p.tif", "--angle=5", "--out", folder / "seen.png"}).code, 0);
        return render::readImage(folder / "seen.png");
    };
    const render::Image cropped = seenWith({}, "50 % of their width is cut off");
    EXPECT_LT(cropped.at(3, cropped.height / 2), 0.05) << "black to the edge";
    const render::Image whole = seenWith({"--fit", "fit"}, "50 % of its height stays white");
    EXPECT_GT(whole.at(whole.width / 2, 3), 0.9) << "a white margin above the black";
    EXPECT_LT(whole.at(whole.width / 2, whole.height / 2), 0.05);
    const render::Image stretched = seenWith({"--fit", "stretch"}, "are stretched to it");
    EXPECT_GT(stretched.at(3, stretched.height / 2), 0.9) << "white at the left, and no margin";
    EXPECT_LT(stretched.at(stretched.width / 2, 3), 0.05);
}

TEST(LongPrintPictures, AreTurnedAndMovedByHand)
{
    const TemporaryFolder folder;
    render::writePicture(folder / "a.png", render::Image(60, 40, 3, 0.0F), render::PictureFormat::png8);
    const Words twice{"--views", folder / "a.png", folder / "a.png"};
    const auto printed = [&](const Words& more) {
        const Ended ended = test::vitrine(printing(folder / "p.tif", twice + more));
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(test::vitrine({"proof", folder / "p.tif", "--angle=5", "--out", folder / "seen.png"}).code, 0);
        return render::readImage(folder / "seen.png");
    };
    const render::Image plain = printed({});
    EXPECT_LT(plain.at(3, plain.height / 2), 0.05);
    // Both move to the right by a quarter of their width, so that white is at the left.
    const render::Image moved = printed({"--place", "1:0,25,0", "2:0,25,0"});
    EXPECT_GT(moved.at(moved.width / 8, moved.height / 2), 0.9);
    EXPECT_LT(moved.at(moved.width * 3 / 8, moved.height / 2), 0.05);
    EXPECT_NE(test::bytesOf(folder / "p.tif.json").find("a.png, placed by 1:0,25,0"), std::string::npos);
    const auto refused = [&](const Words& more, const std::string& part) {
        const Ended bad = test::vitrine(printing(folder / "q.tif", more));
        EXPECT_EQ(bad.code, 2) << bad.err;
        EXPECT_NE(bad.err.find(part), std::string::npos) << bad.err;
    };
    refused(twice + Words{"--place", "3:0,25,0"}, "Cannot place picture 3: the last picture is number 2;");
    refused(twice + Words{"--place", "1:0,25"},
            "Cannot place a picture by \"1:0,25\": this is not PICTURE:TURN,RIGHT,DOWN;");
    refused(theMug + Words{"--count", "2", "--place", "1:0,1,0"}, "--place");
}

TEST(PrintPictures, NamesWhatIsLeftOutAndRefusesWhatHasNoEffect)
{
    const TemporaryFolder folder;
    for (int k = 0; k < 2; ++k)
        render::writePicture(folder / ("v" + std::to_string(k) + ".png"), level(k, 2), render::PictureFormat::png8);
    test::writeBytes(folder / "v2.psd", "8BPS");
    const TemporaryFolder other;
    const Words views{"--views", folder.path().string()};
    const Ended ended = test::vitrine(printing(other / "p.tif", views));
    EXPECT_NE(
        ended.err.find("because these files are no PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF pictures: v2.psd"),
        std::string::npos)
        << ended.err;
    const auto refused = [&](const char* out, const Words& more, const std::vector<std::string>& parts) {
        const Ended bad = test::vitrine(printing(folder / out, more));
        EXPECT_EQ(bad.code, 2) << bad.err;
        for (const std::string& part : parts) EXPECT_NE(bad.err.find(part), std::string::npos) << bad.err;
        EXPECT_FALSE(std::filesystem::exists(folder / out));
    };
    refused("p.tif", views + Words{"--compression", "zstd"}, {"--compression", "zstd"});
    refused("p.png", views + Words{"--compression", "deflate"}, {"--compression", "which is always compressed"});
    refused("p.tif", views + Words{"--guard", "0.3"}, {"--guard has no effect without --method guard"});
    refused("p.tif", views + Words{"--chart-span", "1"}, {"--chart-span has no effect without --chart pitch"});
    refused("p.tif", views + Words{"--convergence", "2"}, {"--convergence has no effect without --exhibit"});
    refused("p.tif", views + Words{"--chart", "pitch"}, {"--views and --chart exclude each other; give one of them."});
    refused("p.tif", theMug + Words{"--count", "2", "--fit", "crop"}, {"--fit", "--exhibit"});
}

TEST(PrintCommand, HasAnOptionForEachParameter)
{
    const std::string help = test::vitrine({"print", "--help"}).out;
    const printing::PrintTable& table = printing::printTable();
    int options = 0;
    for (const jobs::JobOption& option : jobs::optionsOf(table)) {
        ++options;
        // A toggle that is on by default has an option that switches it off.
        const std::string off = "--no-" + option.name.substr(2) + ' ';
        EXPECT_NE(std::min(help.find(option.name + ' '), help.find(off)), std::string::npos) << option.name;
        EXPECT_NE(help.find(jobs::typeText(table, option)), std::string::npos) << option.name;
    }
    EXPECT_EQ(options, 56);
}

TEST(LongPrintCommand, TheLpiGivenBesideASheetIsTheMeasuredOne)
{
    const TemporaryFolder folder;
    const auto sheetOf = [&](const Words& more) {
        const Ended ended = test::vitrine(Words{"print", "--sheet", "60-3d", "--width-mm", "50", "--height-mm", "50",
                                                "--chart", "pitch", "--out", folder / "p.tif"} +
                                          more);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return printing::settingsFromJson(render::readJson(folder / "p.tif.json")).sheet;
    };
    EXPECT_EQ(sheetOf({}).effectiveLpi, printing::knownSheet("60-3d").effectiveLpi);
    EXPECT_EQ(sheetOf({"--lpi", "60"}).effectiveLpi, 60);
    EXPECT_EQ(sheetOf({"--lpi", "60.2"}).effectiveLpi, 60.2);
    EXPECT_EQ(sheetOf({"--lpi", "60.2", "--effective-lpi", "60.1"}).effectiveLpi, 60.1);
    EXPECT_EQ(sheetOf({"--lpi", "60.2"}).nominalLpi, 60);
}

TEST(LongPrintPictures, TakesASequenceBackAndForthInTheOrderOfItsNumbers)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "clip");
    for (int k = 0; k < 12; ++k)
        render::writePicture(folder / ("clip/frame_" + std::to_string(k) + ".png"), level(k, 12),
                             render::PictureFormat::png16);
    const Words clip{"--views", folder / "clip"};
    ASSERT_EQ(test::vitrine(printing(folder / "p.tif", clip + Words{"--every", "4", "--ping-pong"})).code,
              0);  // Pictures 0 4 8 4.
    EXPECT_NEAR(viewShown(folder, 0, 12), 0, 0.5);
    EXPECT_NEAR(viewShown(folder, 1, 12), 4, 0.5);
    EXPECT_NEAR(viewShown(folder, 2, 12), 8, 0.5);
    EXPECT_NEAR(viewShown(folder, 3, 12), 4, 0.5);
}

TEST(LongPrintPictures, FlipsPicturesOfAnySizeAndSaysSo)
{
    const TemporaryFolder folder;
    render::writePicture(folder / "a.png", level(0, 2, 300, 100), render::PictureFormat::png16);
    render::writePicture(folder / "b.jpg", level(1, 2, 40, 77), render::PictureFormat::jpeg);
    const Ended two = test::vitrine(printing(folder / "p.tif", {"--views", folder / "a.png", folder / "b.jpg"}));
    ASSERT_EQ(two.code, 0) << two.err;
    EXPECT_NE(two.err.find("differ in size"), std::string::npos) << two.err;
    EXPECT_NEAR(viewShown(folder, 0, 2), 0, 0.05);
    EXPECT_NEAR(viewShown(folder, 1, 2), 1, 0.05);
    const Ended one = test::vitrine(printing(folder / "p.tif", {"--views", folder / "b.jpg"}));
    EXPECT_EQ(one.code, 0);
    EXPECT_NE(one.err.find("With one view"), std::string::npos) << one.err;
}

TEST(PrintPictures, RefusesACutFileAndTooLongASequence)
{
    const TemporaryFolder folder;
    std::mt19937 random(3);
    render::Image noise(64, 64, 3);
    for (float& level : noise.pixels) level = static_cast<float>(random() % 1000) / 1000.0F;
    for (const std::string extension : {"png", "jpg", "tif"}) {
        const auto format = extension == "png"   ? render::PictureFormat::png8
                            : extension == "jpg" ? render::PictureFormat::jpeg
                                                 : render::PictureFormat::tiff8;
        render::writePicture(folder / ("whole." + extension), noise, format);
        const std::string file = folder / ("cut." + extension);
        const std::string whole = test::bytesOf(folder / ("whole." + extension));
        test::writeBytes(file, whole.substr(0, whole.size() / 2));
        const Ended ended = test::vitrine(printing(folder / "p.tif", {"--views", folder / "whole.png", file}));
        EXPECT_EQ(ended.code, 5) << extension;
        test::expectOneSentence(ended, {"cut." + extension});
        EXPECT_FALSE(std::filesystem::exists(folder / "p.tif")) << extension;
        std::filesystem::remove(folder / "p.tif");
    }
    for (int k = 0; k < 300; ++k) test::writeBytes(folder / ("long/" + std::to_string(k) + ".png"), "x");
    const Ended ended = test::vitrine(printing(folder / "p.tif", {"--views", folder / "long"}));
    EXPECT_EQ(ended.code, 2);
    test::expectOneSentence(ended, {"300 views", "256", "--every 2"});
}

}  // namespace
}  // namespace vitrine
