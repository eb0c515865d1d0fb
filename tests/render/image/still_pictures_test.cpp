// BMP and GIF files made byte by byte from their specifications (Microsoft's BITMAPINFOHEADER; CompuServe's GIF89a).

#include "render/image/image_io.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <climits>
#include <cmath>

namespace vitrine::render {
namespace {

using namespace test;

std::string little16(unsigned x)
{
    return {static_cast<char>(x & 0xFFU), static_cast<char>(x >> 8U)};
}

std::string bytesOf(std::initializer_list<unsigned> values)
{
    std::string bytes;
    for (const unsigned value : values) bytes += static_cast<char>(value);
    return bytes;
}

/// Returns a BMP file: file header, information header, colors and rows.
std::string bmp(int width, int height, unsigned bits, const std::string& colors, const std::string& rows)
{
    const auto at = static_cast<unsigned>(14 + 40 + colors.size());
    return "BM" + littleEndian32(at + static_cast<unsigned>(rows.size())) + std::string(4, '\0') + littleEndian32(at) +
           littleEndian32(40) + littleEndian32(static_cast<unsigned>(width)) +
           littleEndian32(static_cast<unsigned>(height)) + little16(1) + little16(bits) + std::string(8, '\0') +
           std::string(8, '\0') + littleEndian32(static_cast<unsigned>(colors.size() / 4)) + std::string(4, '\0') +
           colors + rows;
}

/// Returns one picture of a GIF: 2 x 2 pixels of the colors 0, 1, 2, 3. Codes have 3 bits and are cleared before they
/// grow to 4: clear, 0, 1, clear, 2, 3, end.
std::string gifPicture()
{
    std::string bytes = "\x2C" + std::string(4, '\0') + little16(2) + little16(2) + '\0' + '\2';
    unsigned packed = 0;
    unsigned bits = 0;
    for (const unsigned code : {4U, 0U, 1U, 4U, 2U, 3U, 5U}) {
        packed |= code << bits;
        bits += 3;
    }
    return bytes + '\3' + bytesOf({packed & 255U, packed >> 8U & 255U, packed >> 16U & 255U}) + '\0';
}

/// Returns a GIF with four colors: black, red, green, white. The last is transparent if `transparent`.
std::string gif(const std::string& pictures, bool transparent = false)
{
    const std::string colors = bytesOf({0, 0, 0, 255, 0, 0, 0, 255, 0, 255, 255, 255});
    const std::string control = transparent ? bytesOf({0x21, 0xF9, 4, 1, 0, 0, 3, 0}) : std::string();
    return "GIF89a" + little16(2) + little16(2) + bytesOf({0x81, 0, 0}) + colors + control + pictures + ';';
}

/// Returns the codes of a picture file, 0 to 255, row 0 at the top.
std::vector<int> codesIn(const std::string& name, const std::string& bytes, int width, int height, int channels)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / name, bytes);
    const Image image = readImage(folder / name, {.raw = true});
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.channels, channels);
    std::vector<int> codes;
    for (const float x : image.pixels) codes.push_back(static_cast<int>(std::lround(255 * x)));
    return codes;
}

const std::vector<int> fourColors{0, 0, 0, 255, 0, 0, 0, 255, 0, 255, 255, 255};

TEST(StillPictures, OfBmpAreReadInAllUsualKinds)
{
    // Rows begin at the bottom, blue first, padded to a multiple of four bytes.
    const std::string bottom = bytesOf({0, 255, 0, 255, 255, 255, 0, 0}), top = bytesOf({0, 0, 0, 0, 0, 255, 0, 0});
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 2, 24, "", bottom + top), 2, 2, 3), fourColors);
    EXPECT_EQ(codesIn("a.BMP", bmp(2, -2, 24, "", top + bottom), 2, 2, 3), fourColors) << "from the top";
    const std::string colors = bytesOf({0, 0, 0, 0, 0, 0, 255, 0, 0, 255, 0, 0, 255, 255, 255, 0});
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 2, 8, colors, bytesOf({2, 3, 0, 0, 0, 1, 0, 0})), 2, 2, 3), fourColors);
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 2, 4, colors, bytesOf({0x23, 0, 0, 0, 0x01, 0, 0, 0})), 2, 2, 3), fourColors);
    const std::string two = bytesOf({0, 0, 255, 0, 255, 255, 255, 0});
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 1, 1, two, bytesOf({0x40, 0, 0, 0})), 2, 1, 3),
              (std::vector<int>{255, 0, 0, 255, 255, 255}));
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 1, 32, "", bytesOf({3, 2, 1, 0, 6, 5, 4, 0})), 2, 1, 3),
              (std::vector<int>{1, 2, 3, 4, 5, 6}))
        << "without alpha";
    // Five bits per color: 31 is converted to 255.
    EXPECT_EQ(codesIn("a.bmp", bmp(2, 1, 16, "", bytesOf({0xE0, 0x03, 0x00, 0x7C})), 2, 1, 3),
              (std::vector<int>{0, 255, 0, 255, 0, 0}));
}

TEST(StillPictures, OfGifAreReadWithTheirTransparency)
{
    EXPECT_EQ(codesIn("a.gif", gif(gifPicture()), 2, 2, 3), fourColors);
    const std::vector<int> codes = codesIn("a.gif", gif(gifPicture(), true), 2, 2, 4);
    EXPECT_EQ(std::vector<int>(codes.begin(), codes.begin() + 8), (std::vector<int>{0, 0, 0, 255, 255, 0, 0, 255}));
    EXPECT_EQ(codes[15], 0) << "the transparent color";
}

TEST(StillPictures, ThatAreBrokenMovingOrTooLargeAreRefused)
{
    const TemporaryFolder folder;
    const auto expectRefused = [&](const char* name, const std::string& bytes, const char* why) {
        test::writeBytes(folder / name, bytes);
        EXPECT_FAILURE((void)readImage(folder / name), why);
    };
    expectRefused("a.gif", gif(gifPicture() + gifPicture()), "it is an animation; save its pictures one by one");
    expectRefused("a.gif", gif(gifPicture()).substr(0, 38), "it is cut short");
    expectRefused("a.bmp", bmp(2, 2, 24, "", std::string(4, '\0')), "it is broken");
    expectRefused("a.bmp", bmp(1 << 20, 2, 24, "", std::string(4, '\0')), "pixels in a row");
    expectRefused("a.bmp", bmp(-2, 2, 24, "", std::string(16, '\0')), "it has no pixels");
    expectRefused("a.bmp", bmp(2, INT_MIN, 24, "", std::string(16, '\0')), "rows");
    expectRefused("a.bmp", bmp(2, 2, 7, "", std::string(16, '\0')), "it is broken");
}

TEST(StillPictures, AreTexturesToo)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.gif", gif(gifPicture()));
    const std::shared_ptr<const Texture> texture = loadTexture(folder / "a.gif", true, false);
    EXPECT_EQ(texture->bytes, (std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 255, 0, 255, 255, 255}));
    EXPECT_FALSE(embeddedPreset(folder / "a.gif").has_value());
}

}  // namespace
}  // namespace vitrine::render
