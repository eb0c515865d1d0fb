#pragma once

#include "exhibits/printing/print_raster.h"
#include "render/image/image.h"

#include <limits>

namespace vitrine::printing {

/// Position from which the print is viewed.
struct Eye {
    double angle = 0;  ///< Angle across the lenses in radians; positive to the right, or below for horizontal lenses.
    double angleAlong = 0;  ///< Angle along the lenses; positive above, or to the right for horizontal lenses.
    double distance = std::numeric_limits<double>::infinity();  ///< Distance of the eye's plane, in millimeters.
};

/// Returns what the eye sees of a printed raster through its sheet, one pixel per lens and square, in linear light.
///
/// `raster` is the print itself (RGB or gray, linear, of the layout's size), not its views. Every lens is the mean over
/// its aperture, with exact refraction. A ray that leaves its own strip shows what is printed under the neighboring
/// lens, so the views repeat at the edge of the zone. White paper is beyond the print.
///
/// The sheet has a lens axis through the center of the print. Throws Failure if the sizes differ.
[[nodiscard]] render::Image lookThrough(const PrintLayout&, const render::Image& raster, const Eye&,
                                        int apertureParts = 128);

/// The same for a print in a file of any size; memory holds the rows of a few lenses.
[[nodiscard]] render::Image lookThrough(PrintRaster&, const Eye&, int apertureParts = 128);

/// Returns the eye's angle across the lenses, in radians, for view `k`: the center of the zone's k-th part. It is the
/// inverse of the exact mean over the lens.
[[nodiscard]] double angleOfView(const PrintLayout&, int k);

}  // namespace vitrine::printing
