#pragma once

#include <glm/glm.hpp>

namespace vitrine::lenticular {

/// Mirrors the struct Print of shaders/lenticular/object.glsl.
struct CardPrintBlock {
    glm::vec4 area{0};   ///< xy: half the picture's size, z: views, w: one lens pitch; meters.
    glm::vec4 shape{0};  ///< Of the lens, in pitches: radius, thickness, conic; w: width of the ink's blur.
    glm::vec4 index{1};  ///< Refractive index for red, green and blue.
    glm::vec4 strips{
        0};  ///< Lens pitch over strips' pitch, phase, slope, then texture (views) or pixels (raster) per lens.
    glm::vec4 size{0};  ///< Of the picture in texels; of a raster across and along the lenses.
};

/// Mirrors the std140 block Object of shaders/lenticular/object.glsl.
struct CardObject {
    glm::mat4 worldFromCard{1};
    glm::mat4 cardFromWorld{1};
    glm::vec4 eyes[2]{};  ///< In the card's space: left and right, or both the camera.
    glm::vec4 card{0};    ///< Half its size; w: the scroll, 0 at rest to 1.
    glm::vec4 axes{0};    ///< Unit vectors of the card's front across the lenses and along them.
    CardPrintBlock prints[2];
};

}  // namespace vitrine::lenticular
