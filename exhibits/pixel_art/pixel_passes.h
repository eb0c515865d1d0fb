#pragma once

#include "exhibits/kit/surface_draw.h"
#include "exhibits/pixel_art/palette.h"
#include "exhibits/pixel_art/pixel_camera.h"
#include "exhibits/pixel_art/small_world.h"
#include "render/plan/frame_plan.h"

#include <cstdint>
#include <vector>

namespace vitrine::pixel_art {

#include "shaders/pixel_art/object_block.glsl"

/// Images of a small picture, of its size, row 0 at the bottom.
inline constexpr const char* pixelSurfaceImage = "pixel_art.surface";  ///< Packed as in shaders/pixel_art/surface.glsl.
inline constexpr const char* pixelTruthImage = "pixel_art.truth";  ///< Drawn normals; a: the object's number, 0: none.
inline constexpr const char* pixelDrawnDepthImage = "pixel_art.drawn_depth";  ///< Reversed, 32-bit.
/// Translucent parts alone, if there are any: color premultiplied, opacity in a. Normal and reversed depth are those of
/// the nearest of them.
inline constexpr const char* pixelTranslucentImage = "pixel_art.translucent";
inline constexpr const char* pixelTranslucentNormalImage = "pixel_art.translucent_normal";
inline constexpr const char* pixelTranslucentDepthImage = "pixel_art.translucent_depth";
inline constexpr const char* pixelLitImage = "pixel_art.lit";      ///< Linear display light before the palette.
inline constexpr const char* pixelShownImage = "pixel_art.shown";  ///< Display light with the palette; a: coverage.

/// Input of a small picture.
struct PixelShot {
    const PixelArtTable& table;
    const ParameterValues& values;
    PixelCamera camera;
    double time = 0;  ///< Seconds, in whole steps.
    std::vector<WorldPart> parts;
    std::uint64_t partsId = 0;                 ///< Hash that changes if a part is replaced.
    const PaletteTextures* palette = nullptr;  ///< Null: all colors.
    bool keepsLit = true;                      ///< Whether pixelLitImage is needed; error diffusion always writes it.
    bool seenSmaller = true;  ///< Whether a texel may be smaller than a pixel of the view; then mip levels are made.
};

/// Returns whether a part is blended over what is behind it.
[[nodiscard]] bool isTranslucent(const WorldPart&);
[[nodiscard]] bool hasTranslucent(const std::vector<WorldPart>&);

/// Adds the passes that draw a small picture, which is kept until anything about it changes. Returns their block.
PixelBlock planPixelPicture(const PixelShot&, render::FramePlan&);

/// Returns the normals in view space from a surface image that was read back; a: the object's number, 0: none.
[[nodiscard]] render::Image normalsOf(const render::Image& surfaces);

/// Returns the number of texels of depth that a method reads for one normal; the drawn normal counts as one.
[[nodiscard]] int fetchesOf(NormalsBy);

}  // namespace vitrine::pixel_art
