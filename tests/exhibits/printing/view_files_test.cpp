#include "exhibits/printing/fitting.h"
#include "exhibits/printing/view_colors.h"
#include "exhibits/printing/view_files.h"
#include "exhibits/printing/view_set.h"

#include "render/files/assets.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace vitrine::printing {
namespace {

using namespace vitrine::test;
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
    // Files keep their given order; folders are expanded in place.
    const auto mixed = viewFiles({folder / "view_10.png", folder.path().string()});
    EXPECT_EQ(mixed.size(), 5U);
    EXPECT_EQ(mixed.front().filename(), "view_10.png");
}

TEST(ViewFiles, SortCapitalsAmongSmallLetters)
{
    const TemporaryFolder folder;
    for (const char* name : {"View1.png", "view2.png", "VIEW10.PNG", "view3.webp"}) writeBytes(folder / name, "x");
    std::vector<std::string> names;
    for (const std::filesystem::path& file : viewFiles({folder.path().string()}))
        names.push_back(file.filename().string());
    EXPECT_EQ(names, (std::vector<std::string>{"View1.png", "view2.png", "view3.webp", "VIEW10.PNG"}));
}

TEST(ViewFiles, NameWhatIsLeftOutOfAFolder)
{
    const TemporaryFolder folder;
    for (const char* name : {"f1.png", "f2.psd", "f10.dpx", "f3.heic", "p.tif.json", ".hidden.psd", "f4.bmp", "f5.gif"})
        writeBytes(folder / name, "x");
    std::vector<std::string> notes;
    EXPECT_EQ(viewFiles({folder.path().string()}, &notes).size(), 3U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("no PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF pictures: f2.psd, f3.heic, f10.dpx."),
              std::string::npos)
        << notes[0];
    std::filesystem::remove(folder / "f2.psd");
    std::filesystem::remove(folder / "f3.heic");
    std::filesystem::remove(folder / "f10.dpx");
    notes.clear();
    (void)viewFiles({folder.path().string()}, &notes);
    EXPECT_TRUE(notes.empty());
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
              }).find("257 views, and at most 256 are possible; take fewer with --every 2 or"),
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
    // Cells of 2 x 3 pixels. Each pixel contains the index of its cell, counted from the top left, and its position in
    // it.
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
    EXPECT_EQ(quiltNote(quilt, 4, 3), "");
    EXPECT_NE(refusalOf([&] { (void)viewOfQuilt(quilt, 3, 10, 0); }).find("does not hold 3 x 10 views"),
              std::string::npos);
    EXPECT_NE(refusalOf([&] { (void)viewOfQuilt(quilt, 0, 3, 0); }), "");
}

// Like Looking Glass quilts of 5 x 9 views with 4096 x 4096 pixels, whose views have 819 x 455, counted from the bottom
// left. Here in small.
TEST(Quilt, ThatDoesNotDivideLeavesAMargin)
{
    render::Image quilt(17, 14, 1);  // 5 x 3 views of 3 x 4 pixels; 2 columns and 2 rows are left over.
    for (int y = 0; y < 14; ++y)
        for (int x = 0; x < 17; ++x) quilt.at(x, y) = static_cast<float>(100 * y + x);
    const render::Image first = viewOfQuilt(quilt, 5, 3, 0);
    ASSERT_EQ(first.width, 3);
    ASSERT_EQ(first.height, 4);
    EXPECT_EQ(first.at(0, 3), 1300) << "the bottom left pixel";
    EXPECT_EQ(first.at(2, 0), 1002);
    EXPECT_EQ(viewOfQuilt(quilt, 5, 3, 14).at(2, 0), 214) << "below the two rows and left of the two columns";
    const render::Image down = viewOfQuilt(quilt, 5, 3, 14, QuiltOrder::topLeft);
    EXPECT_EQ(down.at(0, 0), 812);
    EXPECT_NE(
        quiltNote(quilt, 5, 3).find("they have 3 x 4 pixels, and a margin of 2 x 2 pixels at the edges is left out"),
        std::string::npos);
    EXPECT_NE(quiltNote(render::Image(4096, 4096, 1), 5, 9).find("819 x 455"), std::string::npos);
}

TEST(Fitting, CropsFitsOrStretchesToTheShapeOfThePrint)
{
    render::Image wide(30, 10, 3);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 30; ++x) wide.at(x, y, 0) = static_cast<float>(100 * y + x);
    const render::Image cropped = fitted(wide, 1, Fitting::crop);
    EXPECT_EQ(cropped.width, 10);
    EXPECT_EQ(cropped.height, 10);
    EXPECT_EQ(cropped.at(0, 0, 0), 10) << "around the middle";
    EXPECT_EQ(cropped.at(9, 9, 0), 919);
    const render::Image whole = fitted(wide, 1, Fitting::fit);
    EXPECT_EQ(whole.width, 30);
    EXPECT_EQ(whole.height, 30);
    EXPECT_EQ(whole.at(5, 9, 0), 1) << "white";
    EXPECT_EQ(whole.at(5, 9, 2), 1);
    EXPECT_EQ(whole.at(5, 10, 0), 5);
    EXPECT_EQ(whole.at(29, 19, 0), 929);
    EXPECT_EQ(whole.at(29, 20, 0), 1);
    EXPECT_EQ(fitted(wide, 1, Fitting::stretch).pixels, wide.pixels);
    for (const Fitting fitting : {Fitting::crop, Fitting::fit})
        EXPECT_EQ(fitted(wide, 3, fitting).pixels, wide.pixels) << "what has the shape stays";
    const render::Image high = fitted(render::Image(10, 30, 1), 2, Fitting::crop);
    EXPECT_EQ(high.width, 10);
    EXPECT_EQ(high.height, 5);
    EXPECT_EQ(fittingNote(wide, 1, Fitting::crop),
              "The pictures are not shaped as the print is: 67 % of their width is cut off.");
    EXPECT_EQ(fittingNote(wide, 1, Fitting::fit),
              "The pictures are not shaped as the print is: 67 % of its height stays white.");
    EXPECT_EQ(fittingNote(wide, 3.01, Fitting::crop), "");
}

TEST(Fitting, TurnsAndShiftsPicturesByHand)
{
    render::Image wide(30, 10, 3);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 30; ++x) wide.at(x, y, 0) = static_cast<float>(100 * y + x);
    // Moved by two pixels to the right and one up, of 10 x 10: two columns cropped at the left become visible.
    const render::Image moved = fitted(wide, 1, Fitting::crop, {0, {20, -10}});
    ASSERT_EQ(moved.width, 10);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 10; ++x) ASSERT_EQ(moved.at(x, y, 0), 100 * (y + 1) + 10 + x - 2) << x << ' ' << y;
    EXPECT_EQ(moved.at(4, 9, 0), 1) << "white below the picture";
    // Half a pixel gives the mean of two.
    EXPECT_EQ(fitted(wide, 1, Fitting::crop, {0, {5, 0}}).at(4, 3, 0), 313.5F);
    // A clockwise quarter turn of a square maps (x, y) to (9 - y, x).
    render::Image square(10, 10, 1);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) square.at(x, y) = static_cast<float>(100 * y + x);
    for (const Fitting fitting : {Fitting::crop, Fitting::fit, Fitting::stretch}) {
        const render::Image turned = fitted(square, 1, fitting, {90, {0, 0}});
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 10; ++x) ASSERT_NEAR(turned.at(9 - y, x), 100 * y + x, 1e-2) << x << ' ' << y;
        const render::Image back = fitted(square, 1, fitting, {-90, {0, 0}});
        ASSERT_NEAR(back.at(3, 9 - 8), square.at(8, 3), 1e-2);
    }
    EXPECT_EQ(fitted(wide, 1, Fitting::crop, {}).pixels, fitted(wide, 1, Fitting::crop).pixels);
}

TEST(ViewPlaces, RoundTripToTheBitAndQuoteWhatTheyCannotRead)
{
    const ViewPlaces places{{3, {1.5, {2, -0.5}}}, {7, {0.1 + 0.2, {-1.0 / 3, 0}}}};
    EXPECT_EQ(viewPlaces(textOf(places)), places);
    EXPECT_EQ(textOf(viewPlaces(" 3 : 1.5, 2 ,-0.5 ;")), "3:1.5,2,-0.5");
    EXPECT_EQ(textOf({{4, {}}}), "") << "what changes nothing";
    EXPECT_TRUE(viewPlaces("").empty());
    for (const char* wrong : {"3", "3:1", "3:1,2", "3:1,2,3,4", "0:1,2,3", "1.5:1,2,3", "a:1,2,3", "3:1,2,x",
                              "3:361,0,0", "3:0,101,0", "3:0,0,-101", "3:nan,0,0"})
        EXPECT_PRED_FORMAT2(::testing::IsSubstring, std::string("\"") + wrong + "\": this is not PICTURE:",
                            vitrine::test::refusalOf([&] { return viewPlaces(wrong); }));
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "Cannot place picture 7: the last picture is number 6;",
                        vitrine::test::refusalOf([&] {
                            requirePictures(places, 6);
                            return 0;
                        }));
    EXPECT_NO_THROW(requirePictures(places, 7));
}

TEST(ViewColors, KeepOneProfileForAllAndConvertDifferentOnes)
{
    const TemporaryFolder folder;
    const auto write = [&](const char* name, const std::string& profile) {
        render::PictureStream stream(folder / name,
                                     {.width = 1, .height = 1, .dpiX = 300, .dpiY = 300, .profile = profile});
        const std::array<std::uint8_t, 3> codes = {122, 198, 74};
        stream.write(codes.data(), 1);
        stream.finish();
        stream.publish();
        return std::filesystem::path(folder / name);
    };
    const std::filesystem::path plain = write("a.png", "");
    const std::filesystem::path adobe = write("b.png", vitrine::test::adobeRgb());
    const std::filesystem::path tiff = write("c.tif", vitrine::test::adobeRgb());
    const ViewColors same = viewColors({adobe, tiff});
    EXPECT_TRUE(same.keep);
    EXPECT_EQ(same.profile, vitrine::test::adobeRgb());
    EXPECT_EQ(same.note, "");
    const ViewColors mixed = viewColors({plain, adobe});
    EXPECT_FALSE(mixed.keep);
    EXPECT_EQ(mixed.profile, "");
    EXPECT_NE(mixed.note.find("different color profiles"), std::string::npos);
    EXPECT_EQ(viewColors({plain}).note, "");
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
                    << file;  // The picture changes from view to view.
            }
            last = image;
        }
    }
}

}  // namespace
}  // namespace vitrine::printing
