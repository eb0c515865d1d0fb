// Blocks of pixels lie on one grid, whatever part of the picture is drawn.

#include "exhibits/kit/pixel_blocks.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

render::Raster tileAt(glm::ivec2 offset, glm::ivec2 size)
{
    render::Raster raster;
    raster.size = {640, 360};
    raster.offset = offset;
    raster.tile = size;
    return raster;
}

TEST(PixelBlocks, HoldEveryPixelOfTheTileAndNoBlockBesideIt)
{
    for (const int side : {1, 2, 4, 8})
        for (const glm::ivec2 offset : {glm::ivec2(0), glm::ivec2(8, 16), glm::ivec2(13, 7), glm::ivec2(639, 359)}) {
            const glm::ivec2 size = glm::min(glm::ivec2(37, 90), glm::ivec2(640, 360) - offset);
            const PixelBlocks blocks(tileAt(offset, size), side);
            for (int axis = 0; axis < 2; ++axis) {
                const int first = offset[axis], last = offset[axis] + size[axis] - 1;
                EXPECT_EQ(blocks.first[axis], first / side);
                EXPECT_EQ(blocks.first[axis] + blocks.count[axis] - 1, last / side);
                const PixelBlocks wider(tileAt(offset, size), side, 1);
                EXPECT_EQ(wider.first[axis], blocks.first[axis] - 1);
                EXPECT_EQ(wider.count[axis], blocks.count[axis] + 2);
            }
        }
}

TEST(PixelBlocks, AreAtLeastOne)
{
    render::Raster empty;
    empty.size = {0, 0};
    EXPECT_EQ(PixelBlocks(empty, 8).count, glm::ivec2(1));
}

}  // namespace
}  // namespace vitrine
