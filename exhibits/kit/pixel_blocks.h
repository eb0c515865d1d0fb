#pragma once

#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine {

/// The blocks of `side` × `side` pixels that hold the drawn tile, on the grid of the whole picture: a tile may begin
/// within a block, so that tiles join to the bit. For images of one texel for each block (`count` is their size).
struct PixelBlocks {
    PixelBlocks(const render::Raster& raster, int pixels)
        : side(pixels), first(raster.offset / pixels),
          count(glm::max((raster.offset + raster.drawn() + pixels - 1) / pixels - first, glm::ivec2(1)))
    {
    }

    int side;          ///< Pixels.
    glm::ivec2 first;  ///< The block of the whole picture in which the tile begins.
    glm::ivec2 count;  ///< At least 1 × 1.
};

}  // namespace vitrine
