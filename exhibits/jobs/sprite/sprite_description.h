#pragma once

#include "exhibits/jobs/sprite/sprite_sheet.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Largest number of directions that have compass points as names.
inline constexpr int mostCompassDirections = 16;

/// Returns the compass point that an object faces on the picture, from above: "S" faces the viewer, "E" right. It
/// faces +Z, seen from a camera at this azimuth (radians). The nearest of 8 winds, or of 16 for more than 8 directions,
/// so that evenly spaced directions have different names.
[[nodiscard]] std::string_view compassPoint(double azimuth, int directions);

/// Returns the JSON that describes the sheet, with frame tags, the pivot as a slice, and the names of the maps.
///  - `array`: as Aseprite exports it with `--filename-format {frame}`. Phaser, Godot's and Unity's importers read it.
///    Phaser's `createFromAseprite` looks frames up by their numbers, and animations of all sheets by their tags.
///  - `hash`: frames by names that begin with the file's, because Pixi keeps the frames of all sheets by name. Pixi
///    reads `animations` and `anchor`, which Phaser takes as the pivot.
[[nodiscard]] std::string describe(const std::vector<SpriteFrame>&, const SpriteSheet&, const SpriteSheetOptions&);

/// Returns the sheet as text of a Godot 4 resource (.tres): SpriteFrames with one animation per direction, over a
/// CanvasTexture of colors and normals. Paths are relative to the resource.
[[nodiscard]] std::string godotResource(const std::vector<SpriteFrame>&, const SpriteSheet&, const SpriteSheetOptions&);

}  // namespace vitrine::jobs
