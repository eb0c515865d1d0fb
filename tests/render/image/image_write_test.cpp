#include "render/image/image_io.h"
#include "render/image/srgb.h"

#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/mount.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <random>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using test::TemporaryFolder;

constexpr std::array<std::pair<const char*, PictureFormat>, 6> formats = {{{"a.png", PictureFormat::png8},
                                                                           {"b.png", PictureFormat::png16},
                                                                           {"a.exr", PictureFormat::exr},
                                                                           {"b.exr", PictureFormat::exrHalf},
                                                                           {"a.tif", PictureFormat::tiff8},
                                                                           {"b.tif", PictureFormat::tiff16}}};

Image noise(int width, int height, int channels)
{
    std::mt19937 random(4);
    Image image(width, height, channels);
    for (float& x : image.pixels) x = std::uniform_real_distribution<float>(0, 1)(random);
    return image;
}

TEST(WritePicture, KeepsEveryBitOfAllChannelsOfAFloatExr)
{
    const TemporaryFolder folder;
    Image image = noise(37, 300, 9);
    image.channelNames = {"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z", "evaluations"};
    for (std::size_t i = 3; i < image.pixels.size(); i += 9) image.pixels[i] = 1;
    writePicture(folder / "a.exr", image, PictureFormat::exr);
    const Image back = readImage(folder / "a.exr");
    ASSERT_EQ(back.channels, 9);
    for (int c = 0; c < 9; ++c) {
        const auto at = std::find(back.channelNames.begin(), back.channelNames.end(),
                                  image.channelNames[static_cast<std::size_t>(c)]);
        ASSERT_NE(at, back.channelNames.end());
        const int from = static_cast<int>(at - back.channelNames.begin());
        for (int y = 0; y < 300; ++y) {
            for (int x = 0; x < 37; ++x)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(back.at(x, y, from)),
                          std::bit_cast<std::uint32_t>(image.at(x, y, c)));
        }
    }
}

TEST(WritePicture, RoundsColorToHalfAndKeepsDepthWhole)
{
    const TemporaryFolder folder;
    Image image(1, 1, 4);
    image.channelNames = {"R", "G", "B", "depth.Z"};
    image.pixels = {1.0F / 3, 70000, -1, 1.0F / 3};
    writePicture(folder / "a.exr", image, PictureFormat::exrHalf);
    const Image back = readImage(folder / "a.exr");
    EXPECT_EQ(back.pixels, (std::vector<float>{0.333251953125F, 65504, -1, 1.0F / 3}));
}

TEST(WritePicture, KeepsAlphaApartFromColor)
{
    const TemporaryFolder folder;
    Image image(1, 1, 4);
    image.pixels = {0.5F, 0.25F, 1, 0.2F};
    for (const auto& [name, format] : formats) {
        writePicture(folder / name, image, format);
        const Image back = readImage(folder / name);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(back.pixels[i], image.pixels[i], 0.004) << name << " channel " << i;
    }
}

TEST(WritePicture, CarriesThePreset)
{
    const TemporaryFolder folder;
    const std::string preset = "{\n  \"name\": \"Tasse für 杯 😀\"\n}\n";
    for (const char* name : {"a.png", "a.exr"}) {
        writePicture(folder / name, noise(4, 4, 3),
                     std::string(name) == "a.png" ? PictureFormat::png8 : PictureFormat::exr, {.preset = preset});
        EXPECT_EQ(embeddedPreset(folder / name), preset) << name;
        writePicture(folder / name, noise(4, 4, 3),
                     std::string(name) == "a.png" ? PictureFormat::png16 : PictureFormat::exrHalf);
        EXPECT_EQ(embeddedPreset(folder / name), std::nullopt) << name;
    }
    writePicture(folder / "a.tif", noise(4, 4, 3), PictureFormat::tiff8, {.preset = preset, .pixelsPerInch = 300});
    EXPECT_NE(test::bytesOf(folder / "a.tif").find("Tasse f\\u00fcr \\u676f \\ud83d\\ude00"), std::string::npos);
    EXPECT_EQ(embeddedPreset(folder / "a.tif"), std::nullopt);
}

TEST(WritePicture, WritesJpegNearlyAndOverWhite)
{
    const TemporaryFolder folder;
    Image smooth(64, 48, 4, 1);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            smooth.at(x, y, 0) = static_cast<float>(linearFromSrgb(x / 64.0));
            smooth.at(x, y, 1) = static_cast<float>(linearFromSrgb(y / 48.0));
            smooth.at(x, y, 3) = x < 32 ? 1.0F : 0.0F;
        }
    writePicture(folder / "a.jpg", smooth, PictureFormat::jpeg, {.preset = "{}", .pixelsPerInch = 300});
    const Image back = readImage(folder / "a.jpg", {.raw = true});
    ASSERT_EQ(back.channels, 3);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            if (x >= 24 && x < 40) continue;  // Blocks beside the sharp edge have ringing.
            for (int c = 0; c < 3; ++c) {
                const double expected = x < 32 ? srgbFromLinear(static_cast<double>(smooth.at(x, y, c))) : 1;
                // At quality 92, smooth slopes are exact to a few codes.
                EXPECT_NEAR(static_cast<double>(back.at(x, y, c)), expected, 6 / 255.0) << x << ',' << y << ',' << c;
            }
        }
    // White noise, the worst case, also passes the check after writing.
    EXPECT_NO_THROW(writePicture(folder / "noise.jpg", noise(256, 256, 3), PictureFormat::jpeg));
    EXPECT_NO_THROW(writePicture(folder / "gray.jpg", noise(9, 7, 2), PictureFormat::jpeg));
    EXPECT_EQ(readImage(folder / "gray.jpg").channels, 1);
    EXPECT_FAILURE(writePicture(folder / "a.png", smooth, PictureFormat::jpeg), "does not fit the format JPEG");
}

TEST(WritePicture, SaysTheResolutionOfAPrint)
{
    const TemporaryFolder folder;
    writePicture(folder / "a.png", noise(4, 4, 3), PictureFormat::png8, {.pixelsPerInch = 600});
    // 600 / 0.0254 = 23622.05 pixels per meter; unit 1 is the meter.
    const std::string chunk = "pHYs" + test::bigEndian32(23622) + test::bigEndian32(23622) + '\1';
    EXPECT_NE(test::bytesOf(folder / "a.png").find(chunk), std::string::npos);
}

TEST(WritePicture, RefusesWhatDoesNotFit)
{
    const TemporaryFolder folder;
    EXPECT_FAILURE(writePicture(folder / "a.png", Image(), PictureFormat::png8), "empty");
    EXPECT_FAILURE(writePicture(folder / "a.png", noise(2, 2, 5), PictureFormat::png8), "choose OpenEXR");
    EXPECT_FAILURE(writePicture(folder / "a.exr", noise(2, 2, 5), PictureFormat::exr), "have no names");
    EXPECT_FAILURE(writePicture(folder / "a.jpg", noise(2, 2, 3), PictureFormat::png8), "does not fit the format PNG");
    EXPECT_FAILURE(writePicture(folder / "a.exr", noise(2, 2, 33), PictureFormat::exr), "33 channels");
    EXPECT_TRUE(folder.files().empty());
}

/// Disk with this many free bytes.
class SmallDisk : public FileOps {
public:
    explicit SmallDisk(unsigned long long left) : left_(left) {}
    unsigned long long freeBytes(const char* /*folder*/) override { return left_; }

private:
    unsigned long long left_;
};

class NoRename : public FileOps {
public:
    int rename(const char* /*from*/, const char* /*to*/) override
    {
        errno = EIO;
        return -1;
    }
};

TEST(WritePicture, KeepsTheOldFileWhenAnythingFails)
{
    const TemporaryFolder folder;
    for (const auto& [first, second] : formats) {
        const std::string name = first;
        const PictureFormat format = second;
        test::writeBytes(folder / name, "old");
        SmallDisk small(40);
        EXPECT_FAILURE(writePicture(folder / name, noise(30, 30, 3), format, {}, small), "free some space");
        NoRename noRename;
        EXPECT_FAILURE(writePicture(folder / name, noise(30, 30, 3), format, {}, noRename), "renaming failed");
        EXPECT_EQ(test::bytesOf(folder / name), "old");
    }
    EXPECT_EQ(folder.files().size(), formats.size()) << "no part file stays";
    for (const auto& [first, second] : formats) {
        const std::string name = first;
        const PictureFormat format = second;
        EXPECT_FAILURE(writePicture(folder / "missing" / name, noise(3, 3, 3), format), "Cannot write");
    }
}

TEST(WritePicture, KeepsTheOldFileOnAFullDisk)
{
    // Disk that reports free space, so that every writer reaches its end.
    class HopefulOps : public FileOps {
    public:
        unsigned long long freeBytes(const char* /*folder*/) override { return 1ULL << 40U; }
    };
    const TemporaryFolder folder;
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
        GTEST_SKIP() << "only root can mount a small disk";
    for (const auto& [first, second] : formats) {
        const std::string name = first;
        const PictureFormat format = second;
        for (const int size : {150, 400}) {
            test::writeBytes(folder / name, "old");
            HopefulOps ops;
            EXPECT_FAILURE(writePicture(folder / name, noise(size, size, 3), format, {}, ops), "Cannot write");
            EXPECT_EQ(test::bytesOf(folder / name), "old") << name;
        }
    }
    EXPECT_EQ(folder.files().size(), formats.size());
    ::umount(folder.path().c_str());
}

}  // namespace
