// The table of picture formats and what follows from it.

#include "render/image/picture_formats.h"

#include "render/video/carried_settings.h"

#include <gtest/gtest.h>

#include <set>

namespace vitrine::render {
namespace {

TEST(PictureFormats, EveryExtensionNamesOneFormat)
{
    std::set<std::string_view> seen;
    for (const PictureFileFormat& format : pictureFormats()) {
        EXPECT_EQ(&fileFormat(format.format), &format);
        for (const std::string_view extension : format.extensions) {
            EXPECT_TRUE(seen.insert(extension).second) << extension;
            EXPECT_EQ(formatNamed("a" + std::string(extension)), &format);
            EXPECT_TRUE(extensionAllows("A.B" + std::string(extension), format.format)) << extension;
        }
    }
    EXPECT_EQ(formatNamed("a.TIFF"), &fileFormat(ImageFormat::tiff));
    for (const char* none : {"a", "a.", "png", "a.dpx", "a.png.part"}) EXPECT_EQ(formatNamed(none), nullptr) << none;
    EXPECT_TRUE(extensionAllows("a", ImageFormat::png));
    EXPECT_FALSE(extensionAllows("a.jpg", ImageFormat::png));
}

TEST(PictureFormats, EveryWrittenDepthIsFoundByNameAndBits)
{
    int depths = 0;
    for (const PictureFileFormat& format : pictureFormats())
        for (const WrittenDepth& depth : format.written) {
            ++depths;
            const std::string name = "a" + std::string(format.extensions.front());
            EXPECT_EQ(writtenFormat(name, depth.bits), depth.format) << name;
            EXPECT_EQ(writtenFormat(name), format.written.front().format) << name;
            EXPECT_EQ(&fileFormat(depth.format), &format);
            EXPECT_EQ(bitsOf(depth.format), depth.bits);
        }
    EXPECT_EQ(depths, 7);
    EXPECT_EQ(writtenFormat("a.png"), PictureFormat::png8);
    EXPECT_EQ(writtenFormat("a.exr", 16), PictureFormat::exrHalf);
    EXPECT_EQ(writtenFormat("a.jpg", 16), std::nullopt);
    EXPECT_EQ(writtenFormat("a.gif"), std::nullopt);
}

TEST(PictureFormats, PeopleReadTheUsualExtensions)
{
    EXPECT_EQ(writtenExtensions(), ".png, .jpg, .tif or .exr");
    EXPECT_EQ(writtenExtensions(16), ".png, .tif or .exr");
    EXPECT_EQ(streamedExtensions(), ".png, .tif or .pdf");
    EXPECT_EQ(streamedEndings(), "png tif tiff pdf");
    EXPECT_EQ(readFormats(), "PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF");
    EXPECT_EQ(carriedSettingsEndings(), "png jpg jpeg tif tiff exr mp4 webm gif webp apng");
}

}  // namespace
}  // namespace vitrine::render
