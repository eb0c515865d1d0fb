#pragma once

#include "exhibits/kit/surface_draw.h"
#include "exhibits/pixel_art/palette.h"
#include "exhibits/pixel_art/pixel_camera.h"
#include "exhibits/pixel_art/small_world.h"
#include "render/plan/frame_plan.h"

#include <cstdint>
#include <vector>

namespace vitrine {

#include "shaders/pixel_art/object_block.glsl"

/// Images of a small picture, of its size, row 0 at the bottom.
inline constexpr const char* pixelSurfaceImage = "pixel_art.surface";  ///< As shaders/pixel_art/surface.glsl packs it.
inline constexpr const char* pixelTruthImage = "pixel_art.truth";      ///< As drawn; a: the object's number, 0: none.
inline constexpr const char* pixelDrawnDepthImage = "pixel_art.drawn_depth";  ///< Reversed, 32-bit.
/// Translucent parts alone, where there are any: color premultiplied, opacity in a; and of the nearest of them the
/// normal and the reversed depth.
inline constexpr const char* pixelTranslucentImage = "pixel_art.translucent";
inline constexpr const char* pixelTranslucentNormalImage = "pixel_art.translucent_normal";
inline constexpr const char* pixelTranslucentDepthImage = "pixel_art.translucent_depth";
inline constexpr const char* pixelLitImage = "pixel_art.lit";      ///< Linear display light before the palette.
inline constexpr const char* pixelShownImage = "pixel_art.shown";  ///< The same with the palette; a: coverage.

/// What a small picture is made of.
struct PixelShot {
    const PixelArtTable& table;
    const ParameterValues& values;
    PixelCamera camera;
    double time = 0;  ///< Seconds, in whole steps.
    std::vector<WorldPart> parts;
    std::uint64_t partsId = 0;                 ///< Another number when a part is another.
    const PaletteTextures* palette = nullptr;  ///< Null: all colors.
    bool keepsLit = true;                      ///< Whether pixelLitImage is there; it is when errors are diffused.
    bool seenSmaller = true;  ///< Whether a texel may be smaller than a pixel of who looks: means of texels are made.
};

/// Whether a part is blended over what is behind it.
[[nodiscard]] bool isTranslucent(const WorldPart&);
[[nodiscard]] bool hasTranslucent(const std::vector<WorldPart>&);

/// Adds the passes that draw it, kept until anything about it changes. Returns the block that they share.
PixelBlock planPixelPicture(const PixelShot&, render::FramePlan&);

/// Of a surface image as it was read back: normals in view space; a: the object's number, 0: none.
[[nodiscard]] render::Image normalsOf(const render::Image& surfaces);

/// Texels of depth that a method reads for one normal, the drawn normal counted as one.
[[nodiscard]] int fetchesOf(NormalsBy);

}  // namespace vitrine
