#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/glsl/std140.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine::pixel_art {

#include "shaders/pixel_art/pixel_block.glsl"

/// Returns the size of the small picture in texels.
[[nodiscard]] glm::ivec2 sizeOf(PixelResolution);

/// Position and lens of the camera in the small world.
struct PixelCamera {
    glm::dvec3 target{0};
    double azimuth = 0, elevation = 0;  ///< Radians; 0 looks along -z, 90 degrees of elevation straight down.
    double distance = 20;               ///< Meters from the target.
    double tall = 8;                    ///< Height of the picture at the target, meters.
    bool orthographic = true;
    glm::ivec2 size{240, 135};  ///< Texels.
};

/// Returns the camera by the parameters, rotated by the position of the user (`aside`: radians to the right of and
/// above the screen's axis). With `snap` it rotates in whole steps.
[[nodiscard]] PixelCamera pixelCamera(const PixelArtTable&, const ParameterValues&, glm::dvec2 aside);

/// State that the passes of one small picture share.
struct PixelEye {
    render::View view;  ///< View of the world passes: finite far plane, reversed depth.
    PixelBlock block;   ///< Lens and matrices. Callers fill in light, depth and divider.
};

/// Returns view and block. With `snap`, the target's position across the picture is a whole number of texels, and the
/// rest is in `remainder`.
[[nodiscard]] PixelEye pixelView(const PixelCamera&, bool snap);

}  // namespace vitrine::pixel_art
