// Prints that are larger than memory: views in a scratch file, rasters that are never stored, files read by rows.

#include "exhibits/printing/print_file.h"
#include "exhibits/printing/proof.h"
#include "exhibits/printing/read_print.h"
#include "render/files/scratch_file.h"
#include "render/image/image_io.h"
#include "tests/exhibits/printing/samples.h"
#include "tests/support/environment_variable.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_print.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <optional>

namespace vitrine::printing {
namespace {

using namespace vitrine::test;
using namespace test;

std::vector<render::Image> noisyImages(int count, int width, int height)
{
    std::mt19937 random(11);
    std::vector<render::Image> images;
    for (int k = 0; k < count; ++k) {
        images.emplace_back(width + k % 3, height, 3);
        for (float& x : images.back().pixels) x = static_cast<float>(random() % 65536) / 65535.0F;
    }
    return images;
}

/// Limits the size of files of this process while an object exists.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit old_{};
    sighandler_t handler_;
};

TEST(LargeViews, ViewsOnDiskGiveThePrintThatViewsInMemoryGive)
{
    const std::vector<render::Image> images = noisyImages(5, 301, 97);
    const std::size_t one = std::size_t{301} * 97 * 3 * sizeof(std::uint16_t);  // Red, green and blue.
    for (const std::size_t memory : {std::size_t{0}, 4 * one + one / 2}) {      // In memory: none of them, or four.
        ViewSet inMemory;
        ViewSet onDisk(memory);
        for (const render::Image& image : images) {
            inMemory.add(image);
            onDisk.add(image);
        }
        EXPECT_EQ(inMemory.scratchBytes(), 0U);
        EXPECT_GT(onDisk.scratchBytes(), (memory == 0 ? 5 : 1) * (one - one / 50));
        for (const double direction : {0.0, 90.0, -12.5}) {
            for (const double rows : {60.0, 240.0}) {
                PrintSettings s = settingsFor(40.15, 600, 5, 203, rows);
                s.direction = direction;
                EXPECT_EQ(printOf(PrintLayout(s), onDisk, 2), printOf(PrintLayout(s), inMemory));
            }
        }
    }
}

/// Returns the bytes of files in this process's memory, including file systems in memory (TMPDIR may name one).
std::size_t residentFileBytes()
{
    std::ifstream status("/proc/self/status");
    std::size_t kilobytes = 0;
    for (std::string word; status >> word;) {
        if (word != "RssFile:" && word != "RssShmem:") continue;
        std::size_t more = 0;
        status >> more;
        kilobytes += more;
    }
    return kilobytes * 1024;
}

TEST(LargeViews, LieOnDiskWhereTmpIsMemory)
{
    const EnvironmentVariable none("TMPDIR", std::nullopt);
    EXPECT_EQ(render::ScratchFile().folder(), "/var/tmp");
    const TemporaryFolder folder;
    const EnvironmentVariable here("TMPDIR", folder.path().string());
    EXPECT_EQ(render::ScratchFile().folder(), folder.path());
}

TEST(LargeViews, APrintOfThemTakesFewOfTheirRowsIntoMemory)
{
    ViewSet views(0);
    for (int k = 0; k < 8; ++k) views.add(render::Image(2000, 1000, 3, 0.1F * static_cast<float>(k)));
    ASSERT_GT(views.scratchBytes(), 90U << 20U);
    for (const double direction : {0.0, 10.0}) {
        const std::size_t before = residentFileBytes();
        PrintSettings s = settingsFor(40, 600, 8, 300, 400);
        s.direction = direction;
        (void)printOf(PrintLayout(s), views);
        EXPECT_LT(residentFileBytes(), before + (24U << 20U)) << direction;
    }
    // Memory for all rows.
    const std::size_t before = residentFileBytes();
    unsigned sum = 0;
    for (int k = 0; k < 8; ++k)
        for (int y = 0; y < 1000; ++y) sum += views.row(k, y)[4000] & 1U;
    EXPECT_GT(residentFileBytes(), before + (60U << 20U)) << sum;
    views.allIsRead();
    EXPECT_LT(residentFileBytes(), before + (24U << 20U));
}

TEST(LargeViews, AFullDiskOrAMissingFolderIsSaidAndLeavesNothing)
{
    const TemporaryFolder folder;
    const render::Image image(200, 100, 3, 0.5F);
    {
        const EnvironmentVariable here("TMPDIR", folder.path().string());
        const FileSizeLimit limit(10000);
        ViewSet views(0);
        EXPECT_FAILURE(views.add(image), folder.path().string());
        ViewSet again(0);
        EXPECT_FAILURE(again.add(image), "free some space");
    }
    EXPECT_EQ(folder.files(), std::vector<std::string>{});
    const EnvironmentVariable nowhere("TMPDIR", (folder / "none").string());
    ViewSet views(0);
    EXPECT_FAILURE(views.add(image), "TMPDIR");
}

TEST(LargePrints, EveryCornerOfTwoHundredThousandSquaredIsWhatTheClosedFormSays)
{
    const int n = 12;
    const ViewSet views = solidViews(n);
    for (const double direction : {0.0, 90.0, 33.0}) {
        PrintSettings s = settingsFor(60.12, 1440, n, 200000, 200000);
        s.method = Method::nearest;
        s.direction = direction;
        const PrintLayout layout(s);
        ASSERT_EQ(layout.width(), 200000);
        const Interlacer maker(layout, views);
        const long double perPixel = 60.12L / 1440.0L;
        const long double angle = static_cast<long double>(direction) * 3.14159265358979323846264338L / 180;
        const long double across = direction == 90.0 ? 0 : std::cos(angle);
        const long double along = direction == 90.0 ? 1 : std::sin(angle);
        for (const std::int64_t x0 : {0, 99990, 199960}) {
            for (const std::int64_t y0 : {0, 99990, 199960}) {
                const Region region{x0, y0, x0 + 40, y0 + 40};
                std::vector<std::uint16_t> out(40 * 40 * 3);
                maker.fill(region, out.data(), 2);
                for (int y = 0; y < 40; ++y) {
                    for (int x = 0; x < 40; ++x) {
                        const long double u = (static_cast<long double>(x0 + x) + 0.5L - 100000) * perPixel * across +
                                              (static_cast<long double>(y0 + y) + 0.5L - 100000) * perPixel * along +
                                              0.5L;
                        const long double within = (u - std::floor(u)) * n;
                        if (std::abs(within - std::round(within)) < 1e-6L) continue;  // On the edge of a strip.
                        const int k = n - 1 - static_cast<int>(within);
                        const double level = render::srgbFromLinear((k + 1.0) / (n + 1));
                        ASSERT_NEAR(out[static_cast<std::size_t>(y * 40 + x) * 3] / 65535.0, level, 1e-3)
                            << direction << ' ' << x0 + x << ' ' << y0 + y;
                    }
                }
            }
        }
    }
}

TEST(LargePrints, BeyondFourGigabytesATiffIsABigOneAndBelowItIsNot)
{
    const TemporaryFolder folder;
    if (std::filesystem::space(folder.path()).available < 6ULL << 30U)
        GTEST_SKIP() << "there is no room for the space that is asked for";
    for (const std::int64_t height : {36000, 30000}) {
        {
            render::PictureStream stream(folder / "p.tif",
                                         {.width = 40000, .height = height, .dpiX = 600, .dpiY = 600});
            const std::vector<std::uint8_t> rows(std::size_t{40000} * 3 * 4, 200);
            stream.write(rows.data(), 4);
            ASSERT_EQ(folder.files().size(), 1U);
            const std::string head = bytesOf(folder / folder.files()[0]).substr(0, 4);
            EXPECT_EQ(head, height == 36000 ? std::string("II+\0", 4) : std::string("II*\0", 4));
        }
        EXPECT_EQ(folder.files(), std::vector<std::string>{});  // The file was not finished.
    }
}

TEST(PrintRaster, GivesTheRowsOfEveryFormatAndOfTilesInAnyOrder)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    const PrintLayout layout(settingsFor(40.15, 600, 3, 700, 333));
    std::vector<std::uint8_t> whole = printOf(layout, views);
    const std::string json = test::descriptionOf(layout);
    (void)writePrint(layout, views,
                     {.path = folder / "a.tif", .compression = render::StreamCompression::deflate, .json = json});
    (void)writePrint(layout, views, {.path = folder / "b.png", .json = json});
    (void)writePrint(layout, views, {.path = folder / "c.pdf", .json = json});
    ASSERT_EQ(writePrint(layout, views, {.path = folder / "t.tif", .tileWidth = 10, .json = json}).size(), 3U);
    // Settings are then read from inside the file.
    for (const char* name : {"b.png.json", "c.pdf.json"}) std::filesystem::remove(folder / name);
    for (const char* name : {"a.tif", "b.png", "c.pdf", "t.tif", "t-1.tif", "t-2.tif"}) {
        PrintRaster print = readPrint(folder / name);
        EXPECT_EQ(print.layout().lensesPerPixelX(), layout.lensesPerPixelX()) << name;
        for (const std::int64_t y : {0, 5, 332, 100, 101, 3, 331}) {
            const std::uint16_t* row = print.row(y);
            for (std::size_t i = 0; i < 2100; ++i)
                ASSERT_EQ(row[i], whole[static_cast<std::size_t>(y) * 2100 + i] * 257) << name << ' ' << y;
        }
        const render::Image image = print.image();
        ASSERT_EQ(image.pixels.size(), whole.size());
        for (std::size_t i = 0; i < whole.size(); i += 7)
            ASSERT_NEAR(image.pixels[i], render::linearFromSrgb(whole[i] / 255.0), 1e-6);
    }
    std::filesystem::remove(folder / "t-2.tif");
    EXPECT_FAILURE(readPrint(folder / "t-1.tif"), "tiles");
    EXPECT_FAILURE(readPrint(folder / "none.tif"), "none.tif");
}

TEST(PrintRaster, ADescriptionBesideItOfAnotherPrintIsNoticedAndNotUsed)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    const PrintLayout layout(settingsFor(60, 600, 3, 300, 200));
    const PrintLayout older(settingsFor(40, 600, 3, 300, 200));
    for (const char* name : {"a.tif", "a.png", "a.pdf"}) {
        const std::string beside = (folder / name).string() + ".json";
        (void)writePrint(layout, views, {.path = folder / name, .json = test::descriptionOf(layout)});
        EXPECT_EQ(readPrint(folder / name).doubt(), "");
        // As after a kill between two renames: a new print with the old file beside it.
        vitrine::test::writeBytes(beside, test::descriptionOf(older));
        const PrintRaster print = readPrint(folder / name);
        EXPECT_EQ(print.layout().lensesPerPixelX(), layout.lensesPerPixelX()) << name;
        EXPECT_NE(print.doubt().find(beside), std::string::npos) << print.doubt();
        // A damaged description does not hide the one inside.
        vitrine::test::writeBytes(beside, "{ half a descrip");
        EXPECT_EQ(readPrint(folder / name).layout().lensesPerPixelX(), layout.lensesPerPixelX()) << name;
        EXPECT_NE(readPrint(folder / name).doubt(), "");
    }
}

TEST(PrintRaster, AProofOfTheFileIsTheProofOfTheRasterInMemory)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(4, 60, 50);
    for (const double direction : {0.0, 25.0, 90.0}) {
        PrintSettings s = settingsFor(30, 400, 4, 260, 700);
        s.direction = direction;
        s.mirror = direction == 25.0;
        const PrintLayout layout(s);
        (void)writePrint(layout, views, {.path = folder / "a.tif", .json = test::descriptionOf(layout)});
        PrintRaster print = readPrint(folder / "a.tif");
        for (const Eye& eye : {Eye{.angle = 0.2}, Eye{.angle = -0.1, .angleAlong = 0.6, .distance = 120}}) {
            const render::Image fromFile = lookThrough(print, eye, 32);
            EXPECT_EQ(fromFile.pixels, lookThrough(print.layout(), readPrint(folder / "a.tif").image(), eye, 32).pixels)
                << direction;
        }
    }
}

TEST(PrintRaster, WhatIsCutOffOrOfAnotherSizeIsRefusedByName)
{
    const TemporaryFolder folder;
    const ViewSet views = noisyViews(3, 40, 30);
    const PrintLayout layout(settingsFor(40.15, 600, 3, 300, 200));
    for (const char* name : {"a.tif", "a.png", "a.pdf"}) {
        (void)writePrint(layout, views, {.path = folder / name, .json = test::descriptionOf(layout)});
        const std::string whole = bytesOf(folder / name);
        for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{60}, whole.size() / 2}) {
            vitrine::test::writeBytes(folder / name, whole.substr(0, size));
            EXPECT_FAILURE(readPrint(folder / name).image(), name);
        }
    }
    // The picture of a PDF is found by its name and form.
    (void)writePrint(layout, views, {.path = folder / "a.pdf", .json = test::descriptionOf(layout)});
    const std::string pdf = bytesOf(folder / "a.pdf");
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string bytes = pdf;
        const std::size_t at = bytes.find(from);
        if (at == std::string::npos || from.size() != to.size()) return std::string("%PDF-1.6");
        vitrine::test::writeBytes(folder / "a.pdf", bytes.replace(at, from.size(), to));
        return vitrine::test::failureOf([&] { (void)readPrint(folder / "a.pdf").image(); });
    };
    for (const auto& [from, to] : {std::pair{"/Im0 ", "/Im9 "}, std::pair{"vitrine-print.json", "vitrine_print.json"},
                                   std::pair{"/ICCBased", "/ICCbased"}, std::pair{"/Width 300", "/Width -30"}})
        EXPECT_PRED_FORMAT2(testing::IsSubstring, "a.pdf: it is not a PDF that vitrine print wrote", changed(from, to));
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "30 x 200", changed("/Width 300", "/Width 30 "));
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "300 x 999", changed("/Height 200", "/Height 999"));
    // The first bytes of deflated data say how it is deflated.
    const std::size_t data = pdf.find("stream\n", pdf.find("/Width 300")) + 7;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "its picture is broken", changed(pdf.substr(data, 8), "notzlib!"));
    render::writePicture(folder / "a.png", render::Image(30, 20, 3, 0.5F), render::PictureFormat::png8);
    EXPECT_FAILURE(readPrint(folder / "a.png"), "30 x 20");
}

}  // namespace
}  // namespace vitrine::printing
