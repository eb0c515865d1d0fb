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

/// Sheet for the parameters, scaled to the slices if they are given. A sheet that cannot be made is replaced by the
/// nearest that can; `note` then says so, and is empty otherwise.
struct CardSheetFound {
    Sheet sheet;
    std::string note;
};
[[nodiscard]] CardSheetFound cardSheet(const LenticularTable&, const ParameterValues&);

/// Returns the refractive indices of a plastic at red (611 nm), green (549 nm) and blue (465 nm). `index` is that at
/// 587.6 nm. Cauchy's formula with two terms.
[[nodiscard]] glm::dvec3 dispersedIndex(double index, double abbeNumber);

/// Returns the pitch of the lenses divided by that of strips for an eye at the parameter `distance`, by the parameter
/// `model`. It is 1 at infinity.
[[nodiscard]] double pitchRatio(const LenticularTable&, const ParameterValues&, const Sheet&);

/// Returns half the size in meters of a picture inside the card's margin. `aspect` is width / height.
[[nodiscard]] glm::dvec2 pictureHalfSize(const LenticularTable&, const ParameterValues&, double aspect);

/// Data of a print for the shader, and its texture.
struct CardPicture {
    CardPrintBlock block;
    std::shared_ptr<const render::Texture> texture;  ///< Null if there is not enough memory.
    bool raster = false;
};
[[nodiscard]] CardPicture cardPicture(const LenticularTable&, const ParameterValues&, const Sheet&,
                                      const std::shared_ptr<const CardSource>&, render::AssetStore&);

/// Returns whether the lenses of the print are horizontal, by the parameters or by the printed file.
[[nodiscard]] bool horizontal(const LenticularTable&, const ParameterValues&, const CardSource&);

}  // namespace vitrine::lenticular
