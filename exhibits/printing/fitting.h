#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_place.h"
#include "render/image/image.h"

#include <cstdint>
#include <string>

namespace vitrine::printing {

/// How a picture of another shape is brought into a print.
enum class Fitting : std::uint8_t {
    crop,     ///< Fills the print; what is beyond it at two sides is cut off equally.
    fit,      ///< Is seen whole, between white margins at two sides.
    stretch,  ///< Fills the print, distorted.
};

/// The width of a print by its height, bleed included.
[[nodiscard]] double aspectOf(const PrintSettings&);

/// The picture with the shape `aspect` (width by height), to the nearest pixel; unchanged where it has that shape, and
/// for `stretch`. A place turns and shifts the picture before it is cropped, so that cropped parts can move into view;
/// outside the picture it is white. Interpolation is bilinear; a shift by whole pixels keeps their values.
[[nodiscard]] render::Image fitted(render::Image, double aspect, Fitting, const ViewPlace& = {});

/// A full sentence on what `fitted` does to a picture, where its shape is another by more than two percent; empty for
/// `stretch` (`stretchWarning`).
[[nodiscard]] std::string fittingNote(const render::Image&, double aspect, Fitting);

}  // namespace vitrine::printing
