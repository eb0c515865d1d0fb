#include "exhibits/printing/view_files.h"
#include "exhibits/printing/view_set.h"

#include "render/files/assets.h"
#include "render/image/image_io.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine::printing {
namespace {

using vitrine::test::refusalOf;
using vitrine::test::TemporaryFolder;
using vitrine::test::writeBytes;
using Row = std::vector<std::size_t>;

TEST(ViewFiles, CountNumbersInNamesByTheirValue)
{
    const TemporaryFolder folder;
    for (const char* name :
         {"view_10.png", "view_2.JPG", "view_1.tif", "view_02b.png", ".view_0.png", "notes.txt", "sub/view_3.png"})
        writeBytes(folder / name, "x");
    std::vector<std::string> names;
    for (const std::filesystem::path& file : viewFiles({folder.path().string()}))
        names.push_back(file.filename().string());
    EXPECT_EQ(names, (std::vector<std::string>{"view_1.tif", "view_2.JPG", "view_02b.png", "view_10.png"}));
    // Files stand as they are given, folders among them in their place.
    const auto mixed = viewFiles({folder / "view_10.png", folder.path().string()});
    EXPECT_EQ(mixed.size(), 5U);
    EXPECT_EQ(mixed.front().filename(), "view_10.png");
}

TEST(ViewFiles, SayWhenThereAreNone)
{
    const TemporaryFolder folder;
    EXPECT_NE(vitrine::test::failureOf([&] {
                  (void)viewFiles({folder.path().string()});
              }).find("no pictures in " + folder.path().string()),
              std::string::npos);
    EXPECT_NE(refusalOf([&] { (void)viewFiles({}); }).find("no views"), std::string::npos);
}

TEST(Sequence, TakesEveryKthBackAndForthAndSpreadsEvenly)
{
    EXPECT_EQ(chosenViews(4, {}), (Row{0, 1, 2, 3}));
    EXPECT_EQ(chosenViews(8, {.every = 3}), (Row{0, 3, 6}));
    EXPECT_EQ(chosenViews(4, {.pingPong = true}), (Row{0, 1, 2, 3, 2, 1}));
    EXPECT_EQ(chosenViews(2, {.pingPong = true}), (Row{0, 1}));
    EXPECT_EQ(chosenViews(1, {.pingPong = true}), (Row{0}));
    EXPECT_EQ(chosenViews(7, {.every = 2, .pingPong = true}), (Row{0, 2, 4, 6, 4, 2}));
    EXPECT_EQ(chosenViews(5, {.count = 3}), (Row{0, 2, 4}));
    EXPECT_EQ(chosenViews(5, {.count = 1}), (Row{2}));
    for (std::size_t available = 1; available < 40; ++available) {
        for (int count = 1; static_cast<std::size_t>(count) <= available; ++count) {
            const Row row = chosenViews(available, {.count = count});
            ASSERT_EQ(row.size(), static_cast<std::size_t>(count));
            EXPECT_TRUE(std::is_sorted(row.begin(), row.end()) &&
                        std::adjacent_find(row.begin(), row.end()) == row.end());
            EXPECT_TRUE(count == 1 || (row.front() == 0 && row.back() == available - 1));
        }
    }
}

TEST(Sequence, TellsHowToTakeLessOfALongOne)
{
    EXPECT_EQ(chosenViews(256, {}).size(), 256U);
    EXPECT_NE(refusalOf([] {
                  (void)chosenViews(257, {});
              }).find("257 views, and 256 is the most; take fewer with --every 2 or"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { (void)chosenViews(3000, {.every = 2}); }).find("--every 12 or"), std::string::npos);
    EXPECT_EQ(chosenViews(3000, {.every = 12}).size(), 250U);
    EXPECT_EQ(chosenViews(3000, {.count = 16}).size(), 16U);
    EXPECT_NE(refusalOf([] { (void)chosenViews(200, {.pingPong = true}); }).find("398 views"), std::string::npos);
    EXPECT_NE(refusalOf([] { (void)chosenViews(3, {.count = 4}); }).find("there are 3 views"), std::string::npos);
    EXPECT_NE(refusalOf([] { (void)chosenViews(3, {.count = -1}); }), "");
    EXPECT_NE(refusalOf([] { (void)chosenViews(3, {.every = 0}); }), "");
    EXPECT_NE(refusalOf([] { (void)chosenViews(0, {}); }).find("no views"), std::string::npos);
}

TEST(Quilt, StartsAtTheBottomLeftAndGoesUpUnlessToldOtherwise)
{
    // Cells of 2 x 3 pixels; each pixel says its cell, counted from the top left, and its place within.
    render::Image quilt(8, 9, 3);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 8; ++x) {
            quilt.at(x, y, 0) = static_cast<float>(y / 3 * 4 + x / 2);
            quilt.at(x, y, 1) = static_cast<float>(x % 2);
            quilt.at(x, y, 2) = static_cast<float>(y % 3);
        }
    for (int k = 0; k < 12; ++k) {
        const render::Image up = viewOfQuilt(quilt, 4, 3, k);
        const render::Image down = viewOfQuilt(quilt, 4, 3, k, QuiltOrder::topLeft);
        ASSERT_EQ(up.width, 2);
        ASSERT_EQ(up.height, 3);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x) {
                EXPECT_EQ(up.at(x, y, 0), static_cast<float>((2 - k / 4) * 4 + k % 4));
                EXPECT_EQ(down.at(x, y, 0), static_cast<float>(k));
                EXPECT_EQ(up.at(x, y, 1), static_cast<float>(x));
                EXPECT_EQ(up.at(x, y, 2), static_cast<float>(y));  // No view is upside down.
            }
    }
    EXPECT_NE(refusalOf([&] { (void)viewOfQuilt(quilt, 3, 3, 0); }).find("8 x 9 pixels does not divide into 3 x 3"),
              std::string::npos);
    EXPECT_NE(refusalOf([&] { (void)viewOfQuilt(quilt, 0, 3, 0); }), "");
}

TEST(ShippedViews, AreTwoSetsOf16PicturesOfOneSizeThatDiffer)
{
    for (const char* set : {"frames/turning_mug", "frames/melting_torus"}) {
        const auto files = viewFiles({render::asset(set).string()});
        ASSERT_EQ(files.size(), 16U) << set;
        render::Image last;
        for (const std::filesystem::path& file : files) {
            const render::Image image = render::readImage(file);
            EXPECT_EQ(image.width, 480) << file;
            EXPECT_EQ(image.height, 320) << file;
            if (!last.pixels.empty()) {
                double difference = 0;
                for (std::size_t i = 0; i < image.pixels.size(); ++i)
                    difference += std::abs(static_cast<double>(image.pixels[i] - last.pixels[i]));
                EXPECT_GT(difference / static_cast<double>(image.pixels.size()), 0.002)
                    << file;  // It moves from view to view.
            }
            last = image;
        }
    }
}

}  // namespace
}  // namespace vitrine::printing
