// Metadata of picture files about their display. The files are made by hand, or by other programs.

#include "render/image/color_channels.h"
#include "render/image/image_io.h"
#include "render/image/picture_rows.h"
#include "render/image/picture_stream.h"
#include "render/image/rec709.h"
#include "render/image/srgb.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using test::TemporaryFolder;

/// The picture "12 / 34 / 56" as each orientation stores it (CIPA DC-008, 4.6.5.1.6: the visible edges of row 0 and
/// column 0).
const std::array<std::vector<std::string>, 8> storedRows = {{{"12", "34", "56"},
                                                             {"21", "43", "65"},
                                                             {"65", "43", "21"},
                                                             {"56", "34", "12"},
                                                             {"135", "246"},
                                                             {"246", "135"},
                                                             {"642", "531"},
                                                             {"531", "642"}}};

int codeOf(char digit)
{
    return 40 * (digit - '0');
}

std::string joined(const std::vector<std::string>& rows)
{
    std::string all;
    for (const std::string& row : rows) all += row;
    return all;
}

/// Returns the digits of a picture, each with a code of 40 times the digit.
std::string digitsOf(const Image& image, double unit)
{
    std::string digits;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            digits += static_cast<char>('0' + std::lround(static_cast<double>(image.at(x, y)) / unit));
    return digits;
}

void expectUpright(const Image& image, double unit, const std::string& what)
{
    EXPECT_EQ(image.width, 2) << what;
    EXPECT_EQ(image.height, 3) << what;
    EXPECT_EQ(digitsOf(image, unit), "123456") << what;
}

TEST(Orientation, OfTiffIsObeyed)
{
    const TemporaryFolder folder;
    for (std::uint32_t n = 1; n <= 8; ++n) {
        const auto& rows = storedRows.at(n - 1);
        std::string pixels;
        for (const char digit : joined(rows)) pixels += static_cast<char>(codeOf(digit));
        test::writeBytes(folder / "a.tif", test::tiffClaiming(static_cast<std::uint32_t>(rows[0].size()),
                                                              static_cast<std::uint32_t>(rows.size()), 1, pixels, n));
        expectUpright(readImage(folder / "a.tif", {.raw = true}), 40 / 255.0, "orientation " + std::to_string(n));
        EXPECT_EQ(loadTexture(folder / "a.tif", false, true)->bytes,
                  (std::vector<std::uint8_t>{40, 80, 120, 160, 200, 240}))
            << n;
    }
}

TEST(Orientation, OfPngIsObeyedAheadOfThePixelsAndBehindThem)
{
    const TemporaryFolder folder;
    for (int n = 1; n <= 8; ++n) {
        const auto& rows = storedRows.at(static_cast<std::size_t>(n - 1));
        Image stored(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1);
        for (std::size_t i = 0; i < 6; ++i)
            stored.pixels[i] = static_cast<float>(linearFromSrgb(codeOf(joined(rows)[i]) / 255.0));
        writePicture(folder / "plain.png", stored, PictureFormat::png8);
        const std::string plain = test::bytesOf(folder / "plain.png");
        for (const char* next : {"IDAT", "IEND"}) {
            std::string bytes = plain;
            bytes.insert(plain.find(next) - 4, test::pngChunk("eXIf", test::exifBlock(n)));
            test::writeBytes(folder / "a.png", bytes);
            expectUpright(readImage(folder / "a.png", {.raw = true}), 40 / 255.0,
                          "orientation " + std::to_string(n) + " ahead of " + next);
        }
    }
}

TEST(Orientation, OfJpegAndWebpIsObeyed)
{
    const TemporaryFolder folder;
    const std::string jpeg = test::jpegBytes();
    const std::string exif = std::string("Exif\0\0", 6) + test::exifBlock(6);
    const std::string length = {'\0', static_cast<char>(exif.size() + 2)};
    test::writeBytes(folder / "a.jpg", jpeg.substr(0, 2) + "\xff\xe1" + length + exif + jpeg.substr(2));
    const Image turned = readImage(folder / "a.jpg");
    EXPECT_EQ(turned.width, 8);
    EXPECT_EQ(turned.height, 16);

    // Made with Pillow 9.4: 2 x 3 pixels, lossless, alpha 128 in the first pixel of the last row, orientation 6.
    test::writeBytes(
        folder / "a.webp",
        test::unbase64(
            "UklGRnAAAABXRUJQVlA4WAoAAAAYAAAAAQAAAgAAVlA4TDAAAAAvAYAAEC8gECCI9Z9gQyCQ5G821QIBgib/bQQERdctFwB+"
            "cmxVEAumoWskkRTR/2hFWElGGgAAAE1NACoAAAAIAAEBEgADAAAAAQAGAAAAAAAA"));
    const Image webp = readImage(folder / "a.webp", {.raw = true});
    ASSERT_EQ(webp.width, 3);
    ASSERT_EQ(webp.height, 2);
    const auto pixel = [&](int x, int y) {
        std::array<int, 4> codes{};
        for (int c = 0; c < 4; ++c)
            codes.at(static_cast<std::size_t>(c)) = static_cast<int>(std::lround(255 * webp.at(x, y, c)));
        return codes;
    };
    using Codes = std::array<int, 4>;
    EXPECT_EQ(pixel(2, 0), (Codes{255, 0, 0, 255})) << "the stored top left is the visible top right";
    EXPECT_EQ(pixel(2, 1), (Codes{0, 255, 0, 255}));
    EXPECT_EQ(pixel(1, 0), (Codes{0, 0, 255, 255}));
    EXPECT_NEAR(pixel(0, 0)[0], 200, 1) << "colors are not multiplied by alpha";
    EXPECT_EQ(pixel(0, 0)[3], 128);
}

TEST(Orientation, OfHdrFollowsItsResolutionLine)
{
    const TemporaryFolder folder;
    const std::array<const char*, 8> lines = {"-Y 3 +X 2", "-Y 3 -X 2", "+Y 3 -X 2", "+Y 3 +X 2",
                                              "+X 2 -Y 3", "-X 2 -Y 3", "-X 2 +Y 3", "+X 2 +Y 3"};
    for (std::size_t n = 0; n < lines.size(); ++n) {
        std::string bytes = std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + lines.at(n) + '\n';
        for (const char digit : joined(storedRows.at(n)))
            bytes += std::string(3, static_cast<char>(16 * (digit - '0'))) + '\x81';
        test::writeBytes(folder / "a.hdr", bytes);
        expectUpright(readImage(folder / "a.hdr"), 0.125, lines.at(n));
    }
}

TEST(Orientation, OfAPrintIsRefusedBecauseItsLensesWouldLieElsewhere)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.tif", test::tiffClaiming(2, 3, 1, "123456", 6));
    EXPECT_FAILURE(PictureRows(folder / "a.tif"), "it is to be shown turned or mirrored");
    test::writeBytes(folder / "a.tif", test::tiffClaiming(2, 3, 1, "123456"));
    EXPECT_NO_THROW(PictureRows(folder / "a.tif"));
}

TEST(GrayPicture, IsGrayAsAColorTexture)
{
    const TemporaryFolder folder;
    Image gray(2, 1, 1);
    gray.pixels = {static_cast<float>(linearFromSrgb(51 / 255.0)), 1};
    for (const auto& [name, format] :
         {std::pair("a.png", PictureFormat::png8), std::pair("a.tif", PictureFormat::tiff8),
          std::pair("a.jpg", PictureFormat::jpeg)}) {
        writePicture(folder / name, gray, format);
        const auto texture = loadTexture(folder / name, true, true);
        EXPECT_EQ(texture->channels, 3) << name;
        ASSERT_EQ(texture->bytes.size(), 6U) << name;
        EXPECT_NEAR(texture->bytes[0], 51, 3) << name;
        EXPECT_EQ(texture->bytes[0], texture->bytes[1]) << name;
        EXPECT_EQ(texture->bytes[0], texture->bytes[2]) << name;
    }
    for (const auto& [name, format] :
         {std::pair("b.png", PictureFormat::png16), std::pair("b.exr", PictureFormat::exr)}) {
        writePicture(folder / name, gray, format);
        const auto texture = loadTexture(folder / name, true, true);
        ASSERT_EQ(texture->floats.size(), 6U) << name;
        EXPECT_NEAR(texture->floats[0], gray.pixels[0], 1e-5) << name;
        EXPECT_EQ(texture->floats[2], texture->floats[0]) << name;
    }
}

TEST(ExrChannels, OfALayerOrViewAreItsColor)
{
    const TemporaryFolder folder;
    const test::ExrWindow all{0, 0, 3, 1};
    const auto read = [&](const std::vector<std::string>& names) {
        test::writeBytes(folder / "a.exr", test::exrBytes(names, all, all));
        return readColor(folder / "a.exr");
    };
    // Pixel (1, 0) of channel c is 1 + 100 c; channels are in alphabetical order.
    const auto first = [](const Image& image) {
        return std::vector<float>(image.pixels.begin() + image.channels, image.pixels.begin() + 2 * image.channels);
    };
    EXPECT_EQ(first(read({"ViewLayer.Combined.B", "ViewLayer.Combined.G", "ViewLayer.Combined.R"})),
              (std::vector<float>{201, 101, 1}));
    EXPECT_EQ(first(read({"left.B", "left.G", "left.R"})), (std::vector<float>{201, 101, 1}));
    EXPECT_EQ(first(read({"Y"})), (std::vector<float>{1}));
    EXPECT_EQ(first(read({"B", "G", "R", "Z", "left.B", "left.G", "left.R"})), (std::vector<float>{201, 101, 1}));
    EXPECT_EQ(first(read({"AO.B", "AO.G", "AO.R", "V.Combined.B", "V.Combined.G", "V.Combined.R"})),
              (std::vector<float>{501, 401, 301}))
        << "the finished picture, and not the first of the passes";
    EXPECT_EQ(first(read({"B", "G", "N.X", "N.Y", "N.Z", "R"})), (std::vector<float>{501, 101, 1}));
    std::vector<std::string> many{"B", "G", "R"};
    for (int i = 0; i < 30; ++i) many.push_back("pass" + std::to_string(10 + i) + ".Z");
    EXPECT_EQ(first(read(many)), (std::vector<float>{201, 101, 1})) << "a file may have more channels than are read";
}

TEST(ExrChannels, ThatAreNoColorAreRefusedByName)
{
    const TemporaryFolder folder;
    const test::ExrWindow all{0, 0, 3, 1};
    const auto write = [&](const std::vector<std::string>& names) {
        test::writeBytes(folder / "a.exr", test::exrBytes(names, all, all));
    };
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"Z"}, {"A"}, {"depth.Z"}, {"normal.X", "normal.Y", "normal.Z"}}) {
        write(names);
        EXPECT_FAILURE(readColor(folder / "a.exr"), "neither channels R, G and B nor Y, only " + names.front());
        EXPECT_FAILURE(loadTexture(folder / "a.exr", true, true), "it has no color");
        EXPECT_EQ(readImage(folder / "a.exr").channelNames, names) << "all channels are still to be had";
    }
    write({"BY", "RY", "Y"});
    EXPECT_FAILURE(readColor(folder / "a.exr"), "luminance and chroma (Y, RY, BY)");
    EXPECT_EQ(colorChannels({"R", "G", "B", "left.R", "left.G", "left.B"}).otherLayers,
              std::vector<std::string>{"left"});
}

TEST(ExrChannels, StoredAtALowerResolutionAreRefusedWithThatReason)
{
    const TemporaryFolder folder;
    const test::ExrWindow all{0, 0, 3, 1};
    std::string bytes = test::exrBytes({"BY", "RY", "Y"}, all, all);
    const std::size_t sampling = bytes.find(std::string("BY\0", 3)) + 3 + 8;
    bytes.replace(sampling, 8, test::littleEndian32(2) + test::littleEndian32(2));
    test::writeBytes(folder / "a.exr", bytes);
    EXPECT_FAILURE(readColor(folder / "a.exr"), "luminance and chroma (Y, RY, BY)");
    EXPECT_FAILURE(readImage(folder / "a.exr"), "luminance and chroma (Y, RY, BY)");
}

TEST(ExrWindow, IsWhatTheDisplayWindowShows)
{
    const TemporaryFolder folder;
    const auto read = [&](const test::ExrWindow& data, const test::ExrWindow& display) {
        test::writeBytes(folder / "a.exr", test::exrBytes({"B", "G", "R"}, data, display));
        return readColor(folder / "a.exr");
    };
    const Image region = read({2, 1, 3, 2}, {0, 0, 7, 3});
    EXPECT_EQ(region.width, 8);
    EXPECT_EQ(region.height, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x <= 3 && y >= 1 && y <= 2;
            EXPECT_EQ(region.at(x, y, 0), inside ? static_cast<float>(x + 10 * y + 200) : 0) << x << ' ' << y;
        }
    }
    const Image overscan = read({-2, -1, 9, 5}, {1, 1, 4, 2});
    EXPECT_EQ(overscan.width, 4);
    EXPECT_EQ(overscan.height, 2);
    EXPECT_EQ(overscan.at(0, 0, 2), 11);
    EXPECT_EQ(overscan.at(3, 1, 2), 24);
    const Image apart = read({0, 0, 1, 1}, {4, 4, 5, 5});
    EXPECT_EQ(apart.pixels, std::vector<float>(12, 0));
}

/// Converts Adobe RGB (1998) to linear sRGB with the matrices of both standards in XYZ of D50 (Lindbloom).
std::array<double, 3> fromAdobe(const std::array<double, 3>& code)
{
    constexpr std::array<std::array<double, 3>, 3> toXyz = {
        {{0.60974, 0.20528, 0.14919}, {0.31111, 0.62567, 0.06322}, {0.01947, 0.06087, 0.74457}}};
    constexpr std::array<std::array<double, 3>, 3> toSrgb = {
        {{3.1338561, -1.6168667, -0.4906146}, {-0.9787684, 1.9161415, 0.0334540}, {0.0719453, -0.2289914, 1.4052427}}};
    std::array<double, 3> xyz{};
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) xyz.at(i) += toXyz.at(i).at(j) * std::pow(code.at(j), 563.0 / 256);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out.at(i) += toSrgb.at(i).at(j) * xyz.at(j);
    return out;
}

TEST(ColorProfile, OfAPngIsConvertedToRec709)
{
    const TemporaryFolder folder;
    const std::array<double, 3> code = {122 / 255.0, 198 / 255.0, 74 / 255.0};
    Image image(1, 1, 3);
    for (int c = 0; c < 3; ++c)
        image.at(0, 0, c) = static_cast<float>(linearFromSrgb(code.at(static_cast<std::size_t>(c))));
    const std::array<double, 3> expected = fromAdobe(code);
    for (const int bits : {8, 16}) {
        PictureStream stream(folder / "a.png", {.width = 1, .height = 1, .bits = bits, .profile = test::adobeRgb()});
        const std::array<std::uint8_t, 3> codes8 = {122, 198, 74};
        const std::array<std::uint16_t, 3> codes16 = {122 * 257, 198 * 257, 74 * 257};
        stream.write(bits == 8 ? static_cast<const void*>(codes8.data()) : codes16.data(), 1);
        stream.finish();
        stream.publish();
        const Image read = readColor(folder / "a.png");
        const Image kept = readColor(folder / "a.png", {.keepColors = true});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(read.at(0, 0, c), expected.at(static_cast<std::size_t>(c)), 2e-3) << bits << ' ' << c;
            EXPECT_NEAR(kept.at(0, 0, c), image.at(0, 0, c), 1e-6) << "carried on by a print";
        }
        EXPECT_LT(read.at(0, 0, 0), image.at(0, 0, 0) - 0.05) << "the control: sRGB is another color";
        const auto texture = loadTexture(folder / "a.png", true, true);
        if (bits == 8)
            EXPECT_NEAR(texture->bytes[1], 255 * srgbFromLinear(expected[1]), 1);
        else
            EXPECT_NEAR(texture->floats[1], expected[1], 2e-3);
    }
}

TEST(ColorProfile, ThatIsSrgbChangesNoValue)
{
    // Colorants of sRGB in D50 (IEC 61966-2-1, adapted by Bradford), with its curve and with a gamma.
    const std::vector<std::vector<double>> srgb = {
        {0.43607, 0.22249, 0.01392}, {0.38515, 0.71687, 0.09708}, {0.14307, 0.06061, 0.71410}};
    std::vector<double> curve;
    for (int i = 0; i < 1024; ++i) curve.push_back(linearFromSrgb(i / 1023.0));
    EXPECT_TRUE(isSrgbProfile(""));
    EXPECT_TRUE(isSrgbProfile(test::iccProfile(srgb, 0, curve)));
    EXPECT_FALSE(isSrgbProfile(test::iccProfile(srgb, 1.8)));
    EXPECT_FALSE(isSrgbProfile(test::adobeRgb()));
    EXPECT_FALSE(isSrgbProfile("nonsense"));
    Image image(1, 1, 3, 0.25F);
    convertFromProfile(image, "nonsense");
    EXPECT_EQ(image.pixels, std::vector<float>(3, 0.25F)) << "what cannot be understood is left alone";
}

TEST(ColorProfile, PngGammaIsObeyedWhereItIsNotThatOfSrgb)
{
    const TemporaryFolder folder;
    Image image(1, 1, 3, static_cast<float>(linearFromSrgb(128 / 255.0)));
    writePicture(folder / "plain.png", image, PictureFormat::png8);
    std::string bytes = test::bytesOf(folder / "plain.png");
    const auto withoutChunk = [](std::string png, const char* type) {
        const std::size_t at = png.find(type) - 4;
        const auto size = static_cast<std::size_t>(static_cast<unsigned char>(png[at + 3]));
        return png.erase(at, size + 12);
    };
    for (const char* type : {"sRGB", "gAMA", "cHRM"}) bytes = withoutChunk(bytes, type);
    const auto with = [&](std::uint32_t gamma) {
        std::string png = bytes;
        png.insert(33, test::pngChunk("gAMA", test::bigEndian32(gamma)));
        test::writeBytes(folder / "a.png", png);
        return readColor(folder / "a.png").at(0, 0, 1);
    };
    EXPECT_NEAR(with(100000), 128 / 255.0, 1e-4) << "linear codes";
    EXPECT_NEAR(with(55556), std::pow(128 / 255.0, 1.8), 1e-3) << "as old Macs wrote";
    EXPECT_NEAR(with(45455), image.pixels[0], 1e-6) << "what programs write that mean sRGB";
}

TEST(ColorProfile, ExrChromaticitiesAreConverted)
{
    const TemporaryFolder folder;
    // Linear light with the primaries of BT.2020. The white point is D65 like that of Rec. 709, so white stays white
    // (BT.2087, table 3).
    std::string more;
    for (const float x : {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F})
        more += test::littleEndian32(std::bit_cast<std::uint32_t>(x));
    more = test::exrAttribute("chromaticities", "chromaticities", more);
    const test::ExrWindow one{1, 0, 1, 0};
    test::writeBytes(folder / "a.exr", test::exrBytes({"B", "G", "R"}, one, one, more));
    const Image read = readColor(folder / "a.exr");
    const std::array<double, 3> stored = {201, 101, 1};
    const std::array<std::array<double, 3>, 3> matrix = {
        {{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}};
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = matrix.at(i)[0] * stored[0] + matrix.at(i)[1] * stored[1] + matrix.at(i)[2] * stored[2];
        EXPECT_NEAR(read.pixels[i], expected, 0.2) << i;
    }
}

TEST(HdrColors, CodedAsXyzeAreRefusedWithThatReason)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\x80\x80\x80\x81");
    EXPECT_FAILURE(readImage(folder / "a.hdr"), "its colors are coded as XYZE, and only RGBE is read");
}

}  // namespace
