// Sizes of images, and views of images with their own pixels.

#include "render/plan/image_info.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace render;

const Camera camera{{0.3, 1.2, 4}, {0, 1, 0}, 0.9, {0.05, -0.1}};

Raster tileOf(glm::ivec2 size)
{
    return {.size = size, .offset = size / 2, .tile = size / 4, .jitter = {0.3, -0.4}};
}

TEST(ImageInfo, HasAFractionOfTheTileAFixedSizeOrADivisionOfTheWholePicture)
{
    const Raster raster = tileOf({101, 60});
    EXPECT_EQ(sizeOf({.name = "a"}, raster), glm::ivec2(25, 15));
    EXPECT_EQ(sizeOf({.name = "a", .scale = 0.5}, raster), glm::ivec2(13, 8));
    EXPECT_EQ(sizeOf({.name = "a", .size = {7, 9}}, raster), glm::ivec2(7, 9));
    EXPECT_EQ(sizeOf({.name = "a", .divisor = 4}, raster), glm::ivec2(26, 15));
    EXPECT_EQ(sizeOf({.name = "a", .divisor = 1000}, raster), glm::ivec2(1, 1));
    EXPECT_EQ(sizeOf({.name = "a", .size = {7, 9}, .divisor = 4}, raster), glm::ivec2(7, 9));
}

TEST(ImageInfo, WithItsOwnPixelsSeesTheSameWhateverTileAndJitterIsDrawn)
{
    for (const ImageInfo& info :
         {ImageInfo{.name = "a", .divisor = 3}, ImageInfo{.name = "a", .size = {40, 20}, .ownPixels = true}}) {
        const View whole = viewOfOwnPixels(makeView(camera, {.size = {101, 60}}), info);
        const View tile = viewOfOwnPixels(makeView(camera, tileOf({101, 60})), info);
        EXPECT_EQ(whole.clipFromWorld, tile.clipFromWorld);
        EXPECT_EQ(tile.raster.size, sizeOf(info, tileOf({101, 60})));
        EXPECT_EQ(tile.raster.drawn(), tile.raster.size);
        EXPECT_EQ(tile.raster.jitter, glm::dvec2(0));
    }
}

// The center of pixel (i, j) of the small image is the center of a block of the picture, also in the last row and
// column.
TEST(ImageInfo, OfADivisionCoversBlocksOfThePicture)
{
    const glm::ivec2 size(101, 60);
    for (const int divisor : {1, 2, 3, 7, 64}) {
        const View picture = makeView(camera, {.size = size});
        const View small = viewOfOwnPixels(picture, {.name = "a", .divisor = divisor});
        for (const glm::ivec2 pixel : {glm::ivec2(0), small.raster.size / 2, small.raster.size - 1}) {
            const glm::dvec2 place = (glm::dvec2(pixel) + 0.5) * static_cast<double>(divisor);
            const glm::dvec3 expected = picture.direction(place / glm::dvec2(size) * 2.0 - 1.0);
            const glm::dvec3 seen =
                small.direction((glm::dvec2(pixel) + 0.5) / glm::dvec2(small.raster.size) * 2.0 - 1.0);
            EXPECT_LT(glm::distance(expected, seen), 1e-13) << divisor;
            // The same with the matrix for meshes.
            const glm::dvec4 clip = small.clipFromWorld * glm::dvec4(picture.eye + 3.0 * expected, 1);
            const glm::dvec2 there = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(small.raster.size);
            EXPECT_LT(glm::distance(there, glm::dvec2(pixel) + 0.5), 1e-9) << divisor;
        }
    }
}

}  // namespace
}  // namespace vitrine
