#include "exhibits/printing/print_file.h"

#include "exhibits/printing/print_marks.h"
#include "render/image/image_io.h"
#include "tests/exhibits/printing/samples.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_print.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace vitrine::printing {
namespace {

using namespace vitrine::test;
using namespace test;

std::vector<std::uint8_t> codesOf(const std::filesystem::path& path)
{
    const render::Image image = render::readImage(path, {.raw = true});
    std::vector<std::uint8_t> codes;
    for (const float x : image.pixels) codes.push_back(static_cast<std::uint8_t>(x * 255 + 0.5F));
    return codes;
}

/// Returns a number of the TIFF's first directory; rationals as quotients.
double tiffNumber(const std::string& bytes, unsigned wanted)
{
    const auto read = [&](std::size_t at, std::size_t size) {
        std::uint64_t value = 0;
        std::memcpy(&value, bytes.data() + at, size);
        return value;
    };
    const std::size_t directory = read(4, 4);
    for (std::size_t i = 0; i < read(directory, 2); ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (read(entry, 2) != wanted) continue;
        const std::size_t type = read(entry + 2, 2);
        if (type == 5)
            return static_cast<double>(read(read(entry + 8, 4), 4)) /
                   static_cast<double>(read(read(entry + 8, 4) + 4, 4));
        return static_cast<double>(read(entry + 8, type == 3 ? 2 : 4));
    }
    return -1;
}

TEST(PrintFile, ATiffHasThePixelsTheExactResolutionAndTheDescription)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    for (const double dpi : {600.0, 720.0, 361.35}) {
        PrintSettings s = settingsFor(40.15, dpi, 3, 301, 733);
        s.dpiY = 1440;
        const PrintLayout layout(s);
        std::vector<std::uint8_t> whole(static_cast<std::size_t>(layout.width() * layout.height()) * 3);
        Interlacer(layout, views).fill({0, 0, layout.width(), layout.height()}, whole.data());
        for (const auto compression : {render::StreamCompression::none, render::StreamCompression::deflate}) {
            PrintFile file{.path = folder / "a.tif",
                           .compression = compression,
                           .json = test::descriptionOf(layout),
                           .threads = 2};
            (void)writePrint(layout, views, file);
            EXPECT_EQ(codesOf(file.path), whole);
            const std::string bytes = bytesOf(file.path);
            EXPECT_NEAR(tiffNumber(bytes, 282) / dpi, 1, 1e-7);  // XResolution
            EXPECT_EQ(tiffNumber(bytes, 283), 1440);
            EXPECT_EQ(tiffNumber(bytes, 296), 2);                     // Inches.
            EXPECT_EQ(tiffNumber(bytes, 282) == dpi, dpi != 361.35);  // Whole numbers are stored exactly.
            const auto text = render::embeddedPrint(file.path);
            ASSERT_TRUE(text);
            const PrintLayout again(settingsFromJson(render::parseJson(*text, "a.tif")));
            EXPECT_EQ(again.width(), layout.width());
            EXPECT_EQ(again.lensesPerPixelX(), layout.lensesPerPixelX());
            EXPECT_EQ(folder.files(), (std::vector<std::string>{"a.tif", "a.tif.json"}));
        }
    }
}

TEST(PrintFile, APngAndSixteenBitsHaveThePixels)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    const PrintLayout layout(settingsFor(40.15, 600, 3, 301, 733));
    std::vector<std::uint8_t> whole(static_cast<std::size_t>(layout.width() * layout.height()) * 3);
    Interlacer(layout, views).fill({0, 0, layout.width(), layout.height()}, whole.data());
    const std::string json = test::descriptionOf(layout);
    (void)writePrint(layout, views, {.path = folder / "a.png", .json = json});
    EXPECT_EQ(codesOf(folder / "a.png"), whole);
    EXPECT_EQ(render::embeddedPrint(folder / "a.png"), json);
    EXPECT_NE(bytesOf(folder / "a.png").find("pHYs"), std::string::npos);
    std::vector<std::uint16_t> fine(whole.size());
    Interlacer(layout, views).fill({0, 0, layout.width(), layout.height()}, fine.data());
    for (const char* name : {"b.png", "b.tif"}) {
        (void)writePrint(layout, views, {.path = folder / name, .bits = 16, .json = json});
        const render::Image image = render::readImage(folder / name, {.raw = true});
        for (std::size_t i = 0; i < fine.size(); ++i)
            ASSERT_EQ(static_cast<std::uint16_t>(image.pixels[i] * 65535 + 0.5F), fine[i]) << name;
    }
}

TEST(PrintFile, CarriesAColorProfileOver)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(2, 20, 20);
    const PrintLayout layout(settingsFor(40, 600, 2, 60, 60));
    // Minimal valid profile: a header of RGB to XYZ with an empty tag table.
    std::string profile(132, '\0');
    profile[3] = static_cast<char>(132);
    profile[8] = 2;
    profile.replace(12, 12, "mntrRGB XYZ ");
    profile.replace(36, 4, "acsp");
    for (const std::size_t at : {70U, 71U, 74U, 75U, 78U, 79U}) profile[at] = 0;
    profile.replace(68, 12, std::string("\0\0\xf6\xd6\0\1\0\0\0\0\xd3\x2d", 12));
    (void)writePrint(layout, views, {.path = folder / "a.tif", .profile = profile});
    EXPECT_EQ(render::embeddedProfile(folder / "a.tif"), profile);
}

TEST(PrintFile, TilesRepeatWholeLensesOfTheirNeighbors)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    for (const bool mirror : {false, true}) {
        PrintSettings settings = settingsFor(40.15, 600, 3, 1000, 20);
        settings.mirror = mirror;
        const PrintLayout layout(settings);
        const std::vector<std::int64_t> cuts = tileCuts(layout, 10);
        const std::vector<PrintTile> tiles = printTiles(layout, 10, 2);
        ASSERT_EQ(tiles.size() + 1, cuts.size());
        EXPECT_EQ(tiles[0].x0, 0);
        EXPECT_EQ(tiles[0].repeated, 0);
        const double least = 2 / 25.4 * 600;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            EXPECT_EQ(tiles[i].x1, cuts[i + 1]);
            EXPECT_EQ(tiles[i].x0 + tiles[i].repeated, cuts[i]);
            if (i == 0) continue;
            EXPECT_GE(static_cast<double>(tiles[i].repeated), least - 1);
            EXPECT_LE(static_cast<double>(tiles[i].repeated), least + layout.pixelsPerLens() + 1);
            const double u = layout.lensAt(static_cast<double>(tiles[i].x0), 0);
            EXPECT_NEAR(u, std::round(u), 0.5 / layout.pixelsPerLens() + 1e-9);
        }
        std::vector<std::uint8_t> whole(1000 * 20 * 3);
        Interlacer(layout, views).fill({0, 0, 1000, 20}, whole.data());
        const auto files = writePrint(layout, views, {.path = folder / "t.tif", .tileWidth = 10, .tileOverlap = 2});
        ASSERT_EQ(files.size(), tiles.size());
        for (std::size_t i = 0; i < files.size(); ++i) {
            const std::vector<std::uint8_t> part = codesOf(files[i]);
            const auto width = static_cast<std::ptrdiff_t>(tiles[i].x1 - tiles[i].x0) * 3;
            ASSERT_EQ(static_cast<std::ptrdiff_t>(part.size()), 20 * width);
            for (std::ptrdiff_t y = 0; y < 20; ++y)
                ASSERT_TRUE(std::equal(part.begin() + y * width, part.begin() + (y + 1) * width,
                                       whole.begin() + y * 3000 + tiles[i].x0 * 3));
        }
        EXPECT_NE(
            vitrine::test::refusalOf([&] { (void)printTiles(layout, 10, 10); }).find("not smaller than the tiles"),
            std::string::npos);
    }
}

TEST(PrintFile, CutsHaveCropMarksInTheBorder)
{
    PrintSettings settings = settingsFor(40.15, 600, 3, 1000, 400);
    settings.border = 6;
    settings.marks.crop = true;
    const PrintLayout layout(settings);
    const std::vector<std::int64_t> cuts = tileCuts(layout, 15);
    ASSERT_GT(cuts.size(), 2U);
    const Region all{0, 0, layout.width(), layout.height()};
    std::vector<std::uint8_t> without(static_cast<std::size_t>(layout.width() * layout.height()) * 3, 255);
    std::vector<std::uint8_t> with = without;
    PrintMarks(layout).draw(all, without.data());
    PrintMarks(layout, cuts).draw(all, with.data());
    const auto codeAt = [&](const std::vector<std::uint8_t>& codes, std::int64_t x, std::int64_t y) {
        return codes[static_cast<std::size_t>(y * layout.width() + x) * 3];
    };
    // 3 mm from the edge is in the border, between the gap at the bleed and the end of the marks.
    const std::int64_t deep = std::llround(3 / 25.4 * 600);
    for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
        for (const std::int64_t y : {deep, layout.height() - 1 - deep}) {
            EXPECT_EQ(codeAt(without, cuts[i], y), 255);
            EXPECT_EQ(codeAt(with, cuts[i], y), 0);
        }
    EXPECT_EQ(codeAt(with, cuts[1], layout.height() / 2), 255) << "nothing lies on the print";
}

TEST(PrintFile, TilesAreCutBetweenLensesAndMakeUpTheWhole)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    const PrintLayout layout(settingsFor(40.15, 600, 3, 1000, 20));
    const std::vector<std::int64_t> cuts = tileCuts(layout, 10);
    ASSERT_GT(cuts.size(), 3U);
    for (std::size_t i = 1; i + 1 < cuts.size(); ++i) {
        const double u = layout.lensAt(static_cast<double>(cuts[i]), 0);
        EXPECT_NEAR(u, std::round(u), 0.5 / layout.pixelsPerLens() + 1e-9);
    }
    std::vector<std::uint8_t> whole(1000 * 20 * 3);
    Interlacer(layout, views).fill({0, 0, 1000, 20}, whole.data());
    const auto files = writePrint(layout, views, {.path = folder / "t.tif", .tileWidth = 10});
    ASSERT_EQ(files.size() + 1, cuts.size());
    for (std::size_t tile = 0; tile < files.size(); ++tile) {
        const std::vector<std::uint8_t> part = codesOf(files[tile]);
        const auto width = static_cast<std::size_t>(cuts[tile + 1] - cuts[tile]) * 3;
        for (std::size_t y = 0; y < 20; ++y)
            ASSERT_TRUE(std::equal(
                part.begin() + static_cast<std::ptrdiff_t>(y * width),
                part.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                whole.begin() + static_cast<std::ptrdiff_t>(y * 3000 + static_cast<std::size_t>(cuts[tile]) * 3)));
    }
}

TEST(PrintFile, LeavesNothingBehindWhenStoppedOrRefused)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(2, 20, 20);
    const PrintLayout layout(settingsFor(40, 600, 2, 300, 2000));
    for (const char* name : {"a.tif", "a.png"}) {
        int calls = 0;
        EXPECT_THROW(
            (void)writePrint(layout, views, {.path = folder / name, .progress = [&](double) { return ++calls < 2; }}),
            Failure);
        EXPECT_EQ(calls, 2);
        EXPECT_FAILURE(writePrint(layout, views, {.path = folder / "no" / name}), "Cannot write");
    }
    EXPECT_THROW((void)writePrint(layout, views, {.path = folder / "a.jpg"}), Failure);
    const PrintLayout wide(settingsFor(40, 600, 2, 1100000, 1));
    EXPECT_THROW((void)writePrint(wide, views, {.path = folder / "wide.tif"}), Failure);
    EXPECT_EQ(folder.files(), std::vector<std::string>{});
}

TEST(PrintFile, ADescriptionThatIsNoneIsRefusedWithItsKey)
{
    const auto expectRefused = [](const std::string& text, const char* part) {
        EXPECT_FAILURE(settingsFromJson(render::parseJson(text, "x.json")), part);
    };
    expectRefused("[]", "does not describe a lenticular print");
    const PrintLayout layout(settingsFor(40, 600, 2, 100, 20));
    const render::Json good = render::Json::parse(test::descriptionOf(layout));
    const auto expectBroken = [&](const char* pointer, const render::Json& value, const char* part) {
        render::Json broken = good;
        broken[render::Json::json_pointer(pointer)] = value;
        expectRefused(render::writeJson(broken), part);
    };
    expectBroken("/job", "sprite", "does not describe a lenticular print");
    expectBroken("/version", 2, "version: this must be 1");
    expectBroken("/values/lensesPerInch", "a", "values.lensesPerInch");
    expectBroken("/values/lensesPerInch", 1e6, "lensesPerInch");
    expectBroken("/values/velvet", 1, "velvet");
    expectBroken("/views", 257, "views: this must be 1 to 256");
    for (const std::string key : {"width", "tileOverlap"}) {
        render::Json without = good;
        without["values"].erase(key);
        expectRefused(render::writeJson(without), ("\"" + key + "\" is missing").c_str());
    }
}

/// Runs the program. Returns its exit code.
int run(const std::string& arguments)
{
    const int status = std::system((std::string(VITRINE_PROGRAM) + " " + arguments + " >/dev/null 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(PrintCommand, PrintsAndProvesAndRefusesWithoutLeavingFiles)
{
    const TemporaryFolder folder;
    const int count = 4;
    std::filesystem::create_directory(folder / "views");
    for (int k = 0; k < count; ++k) {
        const std::string name = "views/v" + std::to_string(9 + k) + ".png";  // v9 is sorted before v10.
        render::writePicture(folder / name, render::Image(20 + k, 30, 3, static_cast<float>(k + 1) / (count + 1)),
                             render::PictureFormat::png8);
    }
    const std::string views = (folder / "views").string();
    const std::string out = (folder / "p.tif").string();
    const std::string good = "print --views " + views + " --lpi 40 --dpi 600 --width-mm 20 --height-mm 15 --out " + out;
    const std::size_t before = folder.files().size();
    for (const char* bad : {" --lpi 0", " --lpi 600", " --lpi nan", " --width-mm -1", " --width-mm nan", " --index 1",
                            " --radius-um 100 --thickness-um 900", " --distance-mm 0", " --distance-mm near",
                            " --direction up", " --width-mm 1e9", " --method best", " --count 9", " --sheet none"})
        EXPECT_EQ(run(good + bad), 2) << bad;
    EXPECT_EQ(run("print --lpi 40 --width-mm 20 --height-mm 15 --out " + out), 2);
    EXPECT_EQ(
        run("print --views " + (folder / "none.png").string() + " --lpi 40 --width-mm 20 --height-mm 15 --out " + out),
        5);
    vitrine::test::writeBytes(folder / "cut.png", bytesOf(folder / "views/v9.png").substr(0, 60));
    EXPECT_EQ(
        run("print --views " + (folder / "cut.png").string() + " --lpi 40 --width-mm 20 --height-mm 15 --out " + out),
        5);
    EXPECT_EQ(run(good + " --out /proc/nowhere/p.tif"), 2);  // --out is given twice.
    std::filesystem::remove(folder / "cut.png");
    EXPECT_EQ(folder.files().size(), before);

    ASSERT_EQ(run(good + " --report " + (folder / "r.json").string()), 0);
    const PrintLayout layout(settingsFromJson(render::readJson(folder / "p.tif.json")));
    std::filesystem::remove(folder / "p.tif.json");  // Settings are then read from inside the file.
    for (int k = 0; k < count; ++k) {
        const std::string seen = (folder / "seen.png").string();
        const double degrees = 7.5 * (k - 1.5);  // Four views share 30 degrees.
        ASSERT_EQ(run("proof " + out + " --angle " + std::to_string(degrees) + " --out " + seen), 0);
        const render::Image image = render::readImage(seen);
        EXPECT_NEAR(image.at(image.width / 2, image.height / 2) * (count + 1) - 1, k, 0.35) << k;
    }
    EXPECT_EQ(run("proof " + (folder / "views/v9.png").string() + " --angle 0 --out " + (folder / "no.png").string()),
              5);
    EXPECT_FALSE(std::filesystem::exists(folder / "no.png"));
}

}  // namespace
}  // namespace vitrine::printing
