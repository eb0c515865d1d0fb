#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/image/image.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine::pixel_art {

/// 8-bit sRGB codes.
using Rgb8 = glm::u8vec3;

/// Returns the colors of a shipped palette, as published for the machine; empty for `none` and `goldenHour`.
[[nodiscard]] std::span<const Rgb8> shippedPalette(PaletteName);

/// Returns the main colors of pixels (linear Rec. 709), at most `count` (1 to 256): a median cut in Oklab, refined to
/// the means of the nearest pixels. The same pixels give the same colors. Sources: Heckbert 1982, "Color image
/// quantization for frame buffer display"; Lloyd 1982; Ottosson 2020, "A perceptual color space for image processing".
[[nodiscard]] std::vector<Rgb8> mainColors(std::span<const glm::vec3> pixels, int count);
/// The same for a picture, with at most 65536 of its pixels.
[[nodiscard]] std::vector<Rgb8> mainColors(const render::Image&, int count);

/// Returns Oklab coordinates of a linear Rec. 709 color.
[[nodiscard]] glm::vec3 oklab(const glm::vec3& linear);
[[nodiscard]] glm::vec3 linearOf(const Rgb8&);
/// Returns the index of the nearest color of a palette, by distance in Oklab; 0 if it is empty.
[[nodiscard]] int nearestColor(std::span<const Rgb8>, const glm::vec3& linear);

/// Palette in the form of shaders/pixel_art/palette.glsl: sorted by luminance, at most 256 colors.
struct PaletteTextures {
    std::vector<Rgb8> colors;
    std::shared_ptr<const render::Texture> linear;   ///< One row of floats.
    std::shared_ptr<const render::Texture> nearest;  ///< 32 layers of 32 x 32 indices.
};
/// Returns the textures of a palette. `colors` must not be empty.
[[nodiscard]] PaletteTextures paletteTextures(std::vector<Rgb8> colors);

}  // namespace vitrine::pixel_art
