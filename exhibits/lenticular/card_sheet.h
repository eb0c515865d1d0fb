#pragma once

#include "exhibits/lenticular/card_prints.h"
#include "exhibits/lenticular/lenticular_table.h"
#include "exhibits/printing/sheet.h"
#include "render/glsl/std140.h"

#include <string>

namespace vitrine::lenticular {

using printing::Sheet;

#include "shaders/lenticular/card_block.glsl"

/// Half the card's width, height and thickness, in meters.
inline const glm::dvec3 cardHalfSize{0.3, 0.2, 0.0025};

/// The sheet that the table asks for, scaled to the slices if they are given. What cannot be made is replaced
/// by the nearest that can, and `note` says so; it is empty otherwise.
struct CardSheetFound {
    Sheet sheet;
    std::string note;
};
[[nodiscard]] CardSheetFound cardSheet(const LenticularTable&, const ParameterValues&);

/// Refractive index at red (611 nm), green (549) and blue (465) of a plastic whose index at 587.6 nm and Abbe
/// number are given: Cauchy's formula with two terms.
[[nodiscard]] glm::dvec3 dispersedIndex(double index, double abbeNumber);

/// Lens pitch over the pitch of strips made for an eye at `distance` meters, by the table's model; 1 at infinity.
[[nodiscard]] double pitchRatio(const LenticularTable&, const ParameterValues&, const Sheet&);

/// Half the size, in meters, of a picture of this aspect ratio (width / height) inside the card's margin.
[[nodiscard]] glm::dvec2 pictureHalfSize(const LenticularTable&, const ParameterValues&, double aspect);

/// What the shader knows of a print, and the texture that it samples.
struct CardPicture {
    CardPrintBlock block;
    std::shared_ptr<const render::Texture> texture;  ///< Null where memory does not hold it.
    bool raster = false;
};
[[nodiscard]] CardPicture cardPicture(const LenticularTable&, const ParameterValues&, const Sheet&,
                                      const std::shared_ptr<const CardSource>&, render::AssetStore&);

/// The lenses of the print lie horizontally: as the table says, or the printed file.
[[nodiscard]] bool horizontal(const LenticularTable&, const ParameterValues&, const CardSource&);

}  // namespace vitrine::lenticular
