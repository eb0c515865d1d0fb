#include "render/image/image_io.h"
#include "render/image/jpeg_end.h"

#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <random>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using test::TemporaryFolder;

/// Writes `bytes` as a file and reads it as a picture.
Image read(const std::string& name, const std::string& bytes)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / name, bytes);
    return readImage(folder / name);
}

TEST(HostileImage, OfGiantClaimedSizeIsRefusedBeforeMemoryIsTaken)
{
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    EXPECT_FAILURE(read("a.png", test::pngClaiming(1'000'000, 1'000'000, 8, 2, "x")), "Cannot read");
    EXPECT_FAILURE(read("a.png", test::pngClaiming(60'000, 60'000, 8, 2, "x")), "Cannot read");
    EXPECT_FAILURE(read("a.png", test::pngClaiming(16'000, 16'000, 8, 0, "x")), "times its size");
    EXPECT_FAILURE(read("a.png", test::pngClaiming(30'000, 30'000, 8, 0, "x")), "more than the 268435456 allowed");
    EXPECT_FAILURE(read("a.hdr", test::hdrClaiming(200'000, 200'000, "x")), "200000 pixels in a row");
    EXPECT_FAILURE(read("a.tif", test::tiffClaiming(100'000, 100'000, 1, "x")), "Cannot read");
    EXPECT_FAILURE(read("a.tif", test::tiffClaiming(4, 4, 5000, "x")), "Cannot read");
    EXPECT_FAILURE(read("a.tif", test::tiffClaiming(20'000, 12'000, 1, "x")), "Cannot read");
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 400 * 1024) << "KiB, OpenImageIO's own 131 MB included";
}

TEST(HostileImage, ExrThatClaimsMoreThanItHoldsIsRefusedBeforeMemoryIsTaken)
{
    const TemporaryFolder folder;
    writePicture(folder / "warm.exr", Image(1, 1, 3), PictureFormat::exr);
    (void)readImage(folder / "warm.exr");
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    // Attribute of 2.1 GB in 22 bytes.
    const std::string start = "\x76\x2f\x31\x01" + test::littleEndian32(2);
    EXPECT_FAILURE(read("a.exr", start + std::string("a\0string\0", 9) + test::littleEndian32(0x7f000000)),
                   "its attribute \"a\" claims 2130706432 bytes, and the file has 0 left");
    // Chunk tables of 16 GB, for a window of 2^31 - 1 rows, and of 8 GB, for tiles of one pixel.
    EXPECT_FAILURE(read("a.exr", test::exrBytes({"Y"}, {0, 0, 3, -1}, {0, 0, 3, 3})), "it has no pixels");
    std::string high = test::exrBytes({"Y"}, {0, 0, 3, 3}, {0, 0, 3, 3});
    const std::size_t window = high.find(std::string("dataWindow\0", 11)) + 11 + 6 + 4;
    high.replace(window + 12, 4, test::littleEndian32(0x7ffffffe));
    EXPECT_FAILURE(read("a.exr", high), "rows");
    std::string tiles = test::tiledExr(32, 32, 1);
    const std::size_t tiled = tiles.find(std::string("dataWindow\0", 11)) + 11 + 6 + 4;
    tiles.replace(tiled + 8, 8, test::littleEndian32(16383) + test::littleEndian32(16383));
    EXPECT_FAILURE(read("a.exr", tiles), "its header claims more than the file holds");
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024) << "KiB";
}

/// OpenEXR reads as many bytes as an attribute's type has, whatever its stated length. With a wrong length it would
/// continue at the wrong place, and allocate a wrong size.
TEST(HostileImage, ExrAttributeOfAnotherSizeThanItsTypeIsRefused)
{
    const auto with = [](const std::string& name, const std::string& type, const std::string& value) {
        const std::string bytes =
            name + '\0' + type + '\0' + test::littleEndian32(static_cast<std::uint32_t>(value.size())) + value;
        return test::exrBytes({"Y"}, {0, 0, 3, 3}, {0, 0, 3, 3}, bytes);
    };
    const auto refused = [&](const std::string& type, const std::string& value) {
        EXPECT_FAILURE(read("a.exr", with("a", type, value)), "its attribute \"a\" does not have the size of its type");
    };
    for (const auto& [type, size] :
         {std::pair{"box2i", 16}, {"v2f", 8}, {"compression", 1}, {"timecode", 8}, {"m44f", 64}}) {
        EXPECT_NO_THROW(read("a.exr", with("a", type, std::string(static_cast<std::size_t>(size), '\0')))) << type;
        refused(type, std::string(static_cast<std::size_t>(size) - 1, '\0'));
        refused(type, std::string(static_cast<std::size_t>(size) + 1, '\0'));
    }
    EXPECT_NO_THROW(read("a.exr", with("a", "stringvector", test::littleEndian32(2) + "ab" + test::littleEndian32(0))));
    refused("stringvector", test::littleEndian32(3) + "ab");
    refused("preview", test::littleEndian32(2) + test::littleEndian32(1) + std::string(7, '\0'));
    // 4 x 2^31 x 2^31 bytes overflow to 0 in 64 bits.
    refused("preview", test::littleEndian32(0x80000000) + test::littleEndian32(0x80000000));
    EXPECT_FAILURE(read("a.exr", with("dataWindow", "string", std::string(16, '\0'))),
                   "\"dataWindow\" does not have the size");
    std::string list = test::exrBytes({"Y"}, {0, 0, 3, 3}, {0, 0, 3, 3});
    list[list.find("chlist") + 7] = 18;  // Removes the zero byte that ends the list.
    EXPECT_FAILURE(read("a.exr", list), "its attribute \"channels\" does not have the size of its type");
}

TEST(HostileImage, IsKnownByItsContentAndNotItsName)
{
    EXPECT_FAILURE(read("a.png", test::hdrClaiming(1, 1, "\x80\x80\x80\x80")),
                   "its content is HDR although its name ends in \".png\"");
    EXPECT_FAILURE(read("a.png", test::jpegBytes()), "its content is JPEG");
    EXPECT_FAILURE(read("a.png", "SDPX" + std::string(4000, '\0')),
                   "not a PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF");
    EXPECT_FAILURE(read("a.dpx", "SDPX" + std::string(4000, '\0')),
                   "not a PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF");
    EXPECT_FAILURE(read("a.gif", "GIF89a" + std::string(100, '\0')), "it is cut short");
    EXPECT_FAILURE(read("a.bmp", "BM" + std::string(100, '\0')), "it has no pixels");
    EXPECT_FAILURE(read("a.png", "BM" + std::string(100, '\0')), "its content is BMP");
    EXPECT_FAILURE(read("a.png", ""), "not a PNG");
    EXPECT_NO_THROW(read("a", test::jpegBytes())) << "a name without extension may hold any";
}

TEST(HostileImage, WithTilesThatStickOutIsRefused)
{
    EXPECT_NO_THROW(read("a.exr", test::tiledExr(32, 32, 16)));
    EXPECT_FAILURE(read("a.exr", test::tiledExr(32, 24, 16)), "its size is no multiple of its tiles' size");
    EXPECT_FAILURE(read("a.exr", test::tiledExr(30, 32, 16)), "its size is no multiple of its tiles' size");
}

TEST(HostileImage, ThatEndsEarlyIsRefused)
{
    const TemporaryFolder folder;
    Image image(64, 64, 3, 0.5F);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i * 7919 % 1000) / 1000;
    writePicture(folder / "a.png", image, PictureFormat::png8);
    writePicture(folder / "a.exr", image, PictureFormat::exr);
    writePicture(folder / "a.tif", image, PictureFormat::tiff8);
    writePicture(folder / "a.jpg", image, PictureFormat::jpeg);
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
        const std::string whole = test::bytesOf(folder / name);
        for (const std::size_t part : {8UL, 40UL, whole.size() / 2, whole.size() - 100}) {
            EXPECT_FAILURE(read(name, whole.substr(0, part)), "Cannot read");
        }
    }
    const std::string tiled = test::tiledExr(32, 32, 16);
    EXPECT_FAILURE(read("a.exr", tiled.substr(0, tiled.size() - 500)), "Cannot read");
}

TEST(HostileImage, JpegIsWholeOnlyWithItsOwnEndMarker)
{
    const std::string whole = test::jpegBytes();
    EXPECT_TRUE(jpegIsWhole(whole));
    EXPECT_TRUE(jpegIsWhole(whole + "what a phone appends"));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(jpegIsWhole(std::string_view(whole).substr(0, size))) << size;
    // The end of a thumbnail inside of its segment is not the end of the picture.
    const std::string thumbnail = "\xff\xe1" + std::string{'\0', '\6'} + "\xff\xd8\xff\xd9";
    const std::string carrying = whole.substr(0, 2) + thumbnail + whole.substr(2);
    EXPECT_TRUE(jpegIsWhole(carrying));
    EXPECT_FALSE(jpegIsWhole(std::string_view(carrying).substr(0, carrying.size() - 2)));
}

TEST(HostileImage, ThatIsNoFileIsRefused)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "a.png").c_str(), 0600), 0);
    EXPECT_FAILURE(readImage(folder / "a.png"), "not a regular file");
    EXPECT_FAILURE(readImage(folder.path()), "not a regular file");
    EXPECT_FAILURE(readImage(folder / "none.png"), "no such file");
    EXPECT_FAILURE(loadTexture(folder / "a.png", true, true), "not a regular file");
    EXPECT_FAILURE(embeddedPreset(folder / "a.png"), "not a regular file");
}

TEST(LongHostileImage, NeverCrashesWhenDamaged)
{
    const TemporaryFolder folder;
    Image image(24, 16, 3, 0.5F);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i * 7919 % 1000) / 1000;
    writePicture(folder / "a.png", image, PictureFormat::png8, {.preset = "{}"});
    writePicture(folder / "a.exr", image, PictureFormat::exrHalf, {.preset = "{}"});
    writePicture(folder / "a.tif", image, PictureFormat::tiff16);
    test::writeBytes(folder / "a.jpg", test::jpegBytes());
    test::writeBytes(folder / "a.hdr", test::hdrClaiming(8, 8, std::string(256, 'x')));
    std::mt19937 generator(5);
    const auto random = [&generator] { return static_cast<unsigned>(generator()); };
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg", "a.hdr"}) {
        const std::string whole = test::bytesOf(folder / name);
        for (int i = 0; i < (test::isSanitized ? 20 : 300); ++i) {
            std::string bytes = whole;
            for (unsigned n = random() % 6 + 1; n > 0; --n)
                bytes[4 + random() % (bytes.size() - 4)] = static_cast<char>(random());
            const std::string damaged = "damaged" + std::filesystem::path(name).extension().string();
            test::writeBytes(folder / damaged, bytes);
            try {
                const Image back = readImage(folder / damaged);
                EXPECT_EQ(back.pixels.size(), static_cast<std::size_t>(back.width) *
                                                  static_cast<std::size_t>(back.height) *
                                                  static_cast<std::size_t>(back.channels));
                (void)embeddedPreset(folder / damaged);
            } catch (const Failure& failure) {
                EXPECT_NE(std::string(failure.what()).find(damaged), std::string::npos);
            }
        }
    }
}

}  // namespace
