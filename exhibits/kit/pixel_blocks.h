#pragma once

#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine {

/// Blocks of `side` × `side` pixels that cover the drawn tile, on the grid of the whole picture, and `margin` blocks
/// around them. A tile may begin within a block, so adjacent tiles agree exactly. `count` is the size of an image with
/// one texel per block.
struct PixelBlocks {
    PixelBlocks(const render::Raster& raster, int pixels, int margin = 0)
        : side(pixels), first(raster.offset / pixels - margin),
          count(glm::max((raster.offset + raster.drawn() + pixels - 1) / pixels - first, glm::ivec2(1)) + margin)
    {
    }

    int side;          ///< Pixels.
    glm::ivec2 first;  ///< The block of the whole picture in which the tile begins, less the margin.
    glm::ivec2 count;  ///< At least 1 × 1.
};

}  // namespace vitrine
