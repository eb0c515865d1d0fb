#include "render/image/image_io.h"

#include "render/image/oiio_codec.h"
#include "render/image/srgb.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using test::TemporaryFolder;

Image gradient(int width, int height, int channels)
{
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(linearFromSrgb(static_cast<double>(i % 256) / 255));
    return image;
}

TEST(ReadImage, ReturnsLinearLightForEightAndSixteenBits)
{
    const TemporaryFolder folder;
    const Image image = gradient(33, 17, 3);
    for (const auto& [name, format] :
         {std::pair("a.png", PictureFormat::png8), std::pair("b.png", PictureFormat::png16),
          std::pair("a.tif", PictureFormat::tiff8), std::pair("b.tiff", PictureFormat::tiff16)}) {
        writePicture(folder / name, image, format);
        const Image back = readImage(folder / name);
        ASSERT_EQ(back.pixels.size(), image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            EXPECT_NEAR(back.pixels[i], image.pixels[i], 1e-6) << name;
    }
}

TEST(ReadImage, KeepsStoredValuesWhenAsked)
{
    const TemporaryFolder folder;
    Image image(2, 1, 1);
    image.pixels = {static_cast<float>(linearFromSrgb(128 / 255.0)), 1};
    writePicture(folder / "a.png", image, PictureFormat::png8);
    EXPECT_FLOAT_EQ(readImage(folder / "a.png", {.raw = true}).pixels[0], 128 / 255.0F);
}

TEST(ReadImage, KeepsTheTopRowFirst)
{
    const TemporaryFolder folder;
    Image image(1, 3, 1);
    image.pixels = {1, 0, 0};
    for (const auto& [name, format] :
         {std::pair("a.png", PictureFormat::png8), std::pair("a.tif", PictureFormat::tiff8),
          std::pair("a.exr", PictureFormat::exr)}) {
        writePicture(folder / name, image, format);
        EXPECT_EQ(readImage(folder / name).pixels, image.pixels) << name;
    }
}

TEST(ReadImage, ReadsJpegHdrAndTiledExr)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.jpg", test::jpegBytes());
    const Image jpeg = readImage(folder / "a.jpg", {.raw = true});
    EXPECT_EQ(jpeg.width, 16);
    EXPECT_NEAR(jpeg.at(3, 3, 0) * 255, 200, 2);
    EXPECT_NEAR(jpeg.at(3, 3, 2) * 255, 50, 2);

    // RGBE: 128 / 256 * 2^(129 - 128) = 1.
    test::writeBytes(folder / "a.hdr", test::hdrClaiming(2, 1, "\x80\x40\x20\x81\x80\x80\x80\x80"));
    const Image hdr = readImage(folder / "a.hdr");
    EXPECT_NEAR(hdr.at(0, 0, 0), 1, 0.01);
    EXPECT_NEAR(hdr.at(0, 0, 1), 0.5, 0.01);

    test::writeBytes(folder / "a.exr", test::tiledExr(32, 16, 16));
    const Image exr = readImage(folder / "a.exr");
    EXPECT_EQ(exr.channelNames, std::vector<std::string>{"Y"});
    EXPECT_EQ(exr.at(31, 15), 1531);
}

TEST(ReadImage, ReplacesWhatIsNotFiniteAndCountsIt)
{
    const TemporaryFolder folder;
    Image image(2, 1, 5);
    image.channelNames = {"R", "G", "B", "A", "depth.Z"};
    image.pixels = {NAN, 1, INFINITY, 1, INFINITY, 0.5F, 0.5F, 0.5F, 1, NAN};
    writePicture(folder / "a.exr", image, PictureFormat::exr);
    std::vector<std::string> warnings;
    const Image back = readImage(folder / "a.exr", {}, &warnings);
    EXPECT_EQ(back.at(0, 0, 0), 0);
    EXPECT_EQ(back.at(0, 0, 2), 65504);
    EXPECT_TRUE(std::isinf(back.at(0, 0, 4))) << "a depth of infinity is meant";
    EXPECT_EQ(back.at(1, 0, 4), 0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(warnings[0].starts_with("3 samples")) << warnings[0];
}

TEST(ReadImage, StopsWhenCanceled)
{
    const TemporaryFolder folder;
    int asked = 0;
    const ReadOptions options{.canceled = [&asked] { return ++asked > 1; }};
    for (const auto& [file, format] :
         {std::pair("a.png", PictureFormat::png8), std::pair("a.exr", PictureFormat::exr)}) {
        const std::string name = file;
        writePicture(folder / name, gradient(4, 300, 3), format);
        asked = 0;
        EXPECT_FAILURE(readImage(folder / name, options), "canceled");
        EXPECT_EQ(asked, 2);
    }
}

TEST(Texture, HasTheBytesOfAPngInTheOrderOfGltf)
{
    const TemporaryFolder folder;
    Image image(1, 2, 3);
    image.pixels = {1, 0, 0, 0, 0, 1};
    writePicture(folder / "a.png", image, PictureFormat::png8);
    const auto texture = loadTexture(folder / "a.png", true, false);
    EXPECT_TRUE(texture->sRgb);
    EXPECT_FALSE(texture->repeat);
    EXPECT_EQ(texture->channels, 3);
    EXPECT_EQ(texture->bytes, (std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255})) << "row 0, v = 0, is the top";
}

TEST(Texture, TakesGrayWithAlphaAndSixteenBitsAndExr)
{
    const TemporaryFolder folder;
    Image gray(1, 1, 2);
    gray.pixels = {1, 0.2F};
    writePicture(folder / "ga.png", gray, PictureFormat::png8);
    EXPECT_EQ(loadTexture(folder / "ga.png", true, true)->bytes, (std::vector<std::uint8_t>{255, 255, 255, 51}));

    writePicture(folder / "wide.png", gradient(5, 1, 3), PictureFormat::png16);
    const auto wide = loadTexture(folder / "wide.png", true, true);
    EXPECT_NEAR(wide->floats[4], linearFromSrgb(4 / 255.0), 1e-6);

    Image exr(1, 1, 5);
    exr.channelNames = {"R", "G", "B", "A", "depth.Z"};
    exr.pixels = {0.5F, 2, 8, 0.5F, 77};
    writePicture(folder / "a.exr", exr, PictureFormat::exr);
    EXPECT_EQ(loadTexture(folder / "a.exr", false, true)->floats, (std::vector<float>{0.5F, 2, 8, 0.5F}));

    test::writeBytes(folder / "a.jpg", test::jpegBytes());
    EXPECT_EQ(loadTexture(folder / "a.jpg", true, true)->bytes.size(), 16U * 8 * 3);
}

// In a separate process, because other tests of this program load OpenImageIO.
TEST(TextureDeathTest, OfAPngDoesNotLoadOpenImageIo)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    static const TemporaryFolder folder;  // The exit below removes it, too.
    writePicture(folder / "a.png", gradient(8, 8, 3), PictureFormat::png8, {.preset = "{}"});
    EXPECT_EXIT(
        {
            (void)loadTexture(folder / "a.png", true, true);
            (void)embeddedPreset(folder / "a.png");
            const bool mapped = test::bytesOf("/proc/self/maps").find("OpenImageIO") != std::string::npos;
            std::exit(oiioCodecIsOpen() || mapped ? 1 : 0);
        },
        ::testing::ExitedWithCode(0), "");
}

}  // namespace
