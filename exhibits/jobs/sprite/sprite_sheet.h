#pragma once

#include "exhibits/jobs/sprite/sprite_table.h"
#include "render/image/image.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine {

/// 8-bit sRGB codes.
using Rgb8 = glm::u8vec3;

/// One drawn picture of a sprite.
struct SpriteFrame {
    int direction = 0;
    double azimuth = 0;    ///< Of the camera around the object, radians; 0: it looks at the object's front, +Z.
    render::Image color;   ///< Linear light; a: opacity, 0 where nothing is.
    render::Image normal;  ///< View space; a: 0 or 1.
    render::Image depth;   ///< One channel, 1 near to 0 far over the object's own depth; 0 where nothing is.
    glm::dvec2 pivot{0};   ///< Where the object stands, texels from the upper left corner of the picture.
};

/// Returns whether a pixel is visible: its opacity is not 0 in 8 bits.
[[nodiscard]] inline bool isSeen(const render::Image& color, int x, int y)
{
    return color.at(x, y, 3) > 0.5F / 255;
}
/// Returns the number of visible pixels of a frame.
[[nodiscard]] int seenPixels(const SpriteFrame&);

struct SpriteSheetOptions {
    int colors = 32;  ///< Of the palette that is made of all frames, 1 to 256; unused where `palette` is given.
    std::vector<Rgb8> palette{};  ///< In its place.
    SpriteDither dither = SpriteDither::none;
    SpritePivot pivot = SpritePivot::origin;
    bool trimmed = false;  ///< Without the empty rows and columns around each frame.
    double frameSeconds = 1.0 / 12;
    std::string imageName;                  ///< Of the sheet, as the description names it.
    std::string normalName{}, depthName{};  ///< Of the maps; empty: there is none.
    SpriteDirectionNames directionNames = SpriteDirectionNames::numbers;
    SpriteNormalY normalY = SpriteNormalY::up;
    SpriteJson json = SpriteJson::array;
};

/// Position of a frame in the sheet, and the margin that was cut off. In texels, from upper left corners.
struct SpriteCell {
    glm::ivec2 place{0}, size{0};
    glm::ivec2 cutOff{0};  ///< To the left and above.
};

/// All frames in one picture, a row for each direction.
struct SpriteSheet {
    render::Image color;   ///< RGBA, linear; colors of the palette only where alpha is above 0, black elsewhere.
    render::Image normal;  ///< RGBA, n / 2 + 1/2 as raw codes, y as `SpriteSheetOptions::normalY` says; alpha as color.
    render::Image depth;   ///< Gray, raw codes.
    std::vector<SpriteCell> cells;
    std::vector<glm::ivec2> pivots;  ///< Of each frame, as the description has them.
    double frameSeconds = 0;         ///< Likewise.
    std::vector<Rgb8> palette;
    std::string description;    ///< As `describe` returns it (sprite_description.h).
    std::string godot;          ///< As `godotResource` returns it.
    std::string settings = {};  ///< The preset that the picture carries: the look that it was drawn in; empty: none.
    std::vector<std::string> warnings;  ///< What will disappoint, sentences.
};

/// Makes a sheet of frames of one size, ordered by direction. Throws Failure (ErrorKind::usage) if there are none.
[[nodiscard]] SpriteSheet spriteSheet(const std::vector<SpriteFrame>&, const SpriteSheetOptions&);

}  // namespace vitrine
