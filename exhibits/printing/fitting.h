#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_place.h"
#include "render/image/image.h"

#include <cstdint>
#include <string>

namespace vitrine::printing {

/// Fitting of a picture into a print of another aspect ratio.
enum class Fitting : std::uint8_t {
    crop,     ///< Fills the print; the rest is cropped equally at two sides.
    fit,      ///< Is completely visible, between white margins at two sides.
    stretch,  ///< Fills the print, distorted.
};

/// Returns width divided by height of a print, including bleed.
[[nodiscard]] double aspectOf(const PrintSettings&);

/// Returns the picture with the shape `aspect` (width divided by height), to the nearest pixel. It is unchanged if it
/// has that shape, and for `stretch`. A place rotates and shifts the picture before it is cropped, so cropped parts can
/// move into view; outside the picture it is white. Interpolation is bilinear; a shift by whole pixels keeps their
/// values.
[[nodiscard]] render::Image fitted(render::Image, double aspect, Fitting, const ViewPlace& = {});

/// Returns a full sentence on what `fitted` does to a picture whose shape differs by more than two percent. Empty
/// otherwise, and for `stretch` (see `stretchWarning`).
[[nodiscard]] std::string fittingNote(const render::Image&, double aspect, Fitting);

}  // namespace vitrine::printing
