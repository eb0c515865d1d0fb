#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/image/image.h"

#include <glm/glm.hpp>

namespace vitrine::pixel_art {

inline const PixelArtTable& table()
{
    static const PixelArtTable t;
    return t;
}

/// Returns the color of a pixel.
inline glm::dvec3 at(const render::Image& image, int x, int y)
{
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

}  // namespace vitrine::pixel_art
