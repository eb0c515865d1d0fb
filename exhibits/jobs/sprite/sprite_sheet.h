#pragma once

#include "exhibits/jobs/sprite/sprite_table.h"
#include "render/image/image.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::jobs {

/// 8-bit sRGB codes.
using Rgb8 = glm::u8vec3;

/// One drawn picture of a sprite.
struct SpriteFrame {
    int direction = 0;
    double azimuth = 0;    ///< Azimuth of the camera around the object, in radians; 0: it looks at the front, +Z.
    render::Image color;   ///< Linear light; a: opacity, 0 where nothing is.
    render::Image normal;  ///< View space; a: 0 or 1.
    render::Image depth;   ///< One channel, 1 near to 0 far over the object's own depth; 0 where nothing is.
    glm::dvec2 pivot{0};   ///< Position of the object, in texels from the upper left corner of the picture.
};

/// Returns whether a pixel is visible: its opacity is not 0 in 8 bits.
[[nodiscard]] inline bool isSeen(const render::Image& color, int x, int y)
{
    return color.at(x, y, 3) > 0.5F / 255;
}
/// Returns the number of visible pixels of a frame.
[[nodiscard]] int seenPixels(const SpriteFrame&);

struct SpriteSheetOptions {
    int colors = 32;  ///< Colors of the palette that is made from all frames, 1 to 256; unused if `palette` is given.
    std::vector<Rgb8> palette{};  ///< Given palette; empty: made from all frames.
    SpriteDither dither = SpriteDither::none;
    SpritePivot pivot = SpritePivot::origin;
    bool trimmed = false;  ///< Whether the empty rows and columns around each frame are cut off.
    double frameSeconds = 1.0 / 12;
    std::string imageName;                  ///< File name of the sheet, as the description names it.
    std::string normalName{}, depthName{};  ///< File names of the maps; empty: none.
    SpriteDirectionNames directionNames = SpriteDirectionNames::numbers;
    SpriteNormalY normalY = SpriteNormalY::up;
    SpriteJson json = SpriteJson::array;
};

/// Position of a frame in the sheet, and the margin that was cut off. In texels, from upper left corners.
struct SpriteCell {
    glm::ivec2 place{0}, size{0};
    glm::ivec2 cutOff{0};  ///< Size of the margin that was cut off to the left and above.
};

/// All frames in one picture, a row for each direction.
struct SpriteSheet {
    render::Image color;   ///< RGBA, linear; colors of the palette only where alpha is above 0, black elsewhere.
    render::Image normal;  ///< RGBA, n / 2 + 1/2 as raw codes, y as `SpriteSheetOptions::normalY` says; alpha as color.
    render::Image depth;   ///< Gray, raw codes.
    std::vector<SpriteCell> cells;
    std::vector<glm::ivec2> pivots;  ///< Pivot of each frame, as written in the description.
    double frameSeconds = 0;         ///< Duration of a frame, as written in the description.
    std::vector<Rgb8> palette;
    std::string description;    ///< Text from `describe` (sprite_description.h).
    std::string godot;          ///< Text from `godotResource`.
    std::string settings = {};  ///< Preset that the picture carries, the one that it was drawn with; empty: none.
    std::vector<std::string> warnings;  ///< Sentences on flaws of the sheet.
};

/// Makes a sheet of frames of one size, ordered by direction. Throws Failure (ErrorKind::usage) if there are none.
[[nodiscard]] SpriteSheet spriteSheet(const std::vector<SpriteFrame>&, const SpriteSheetOptions&);

}  // namespace vitrine::jobs
