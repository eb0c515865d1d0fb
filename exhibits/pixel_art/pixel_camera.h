#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/glsl/std140.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine {

#include "shaders/pixel_art/pixel_block.glsl"

/// Texels of the small picture.
[[nodiscard]] glm::ivec2 sizeOf(PixelResolution);

/// Where the small world is seen from, and through what.
struct PixelCamera {
    glm::dvec3 target{0};
    double azimuth = 0, elevation = 0;  ///< Radians; 0 looks along -z, 90 degrees of elevation straight down.
    double distance = 20;               ///< Meters from the target.
    double tall = 8;                    ///< Height of the picture at the target, meters.
    bool orthographic = true;
    glm::ivec2 size{240, 135};  ///< Texels.
};

/// Of the table, turned by where the visitor stands (`aside`: radians to the right and up of straight before the
/// screen). With `snap`, whole steps of turning.
[[nodiscard]] PixelCamera pixelCamera(const PixelArtTable&, const ParameterValues&, glm::dvec2 aside);

/// What the passes of one small picture share.
struct PixelEye {
    render::View view;  ///< Of the world passes: finite far plane, reversed depth.
    PixelBlock block;   ///< Lens and matrices; light, depth and divider are filled by who has them.
};

/// With `snap`, the target's place across the picture is a whole number of texels, and `remainder` what is left.
[[nodiscard]] PixelEye pixelView(const PixelCamera&, bool snap);

}  // namespace vitrine
