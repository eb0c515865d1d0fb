#pragma once

#include "exhibits/printing/print_raster.h"
#include "render/image/image.h"

#include <limits>

namespace vitrine::printing {

/// From where the print is looked at.
struct Eye {
    double angle = 0;       ///< Across the lenses, in radians; positive to the right, for horizontal lenses below.
    double angleAlong = 0;  ///< The other way; positive above, for horizontal lenses to the right.
    double distance = std::numeric_limits<double>::infinity();  ///< Of the eye's plane, in millimeters.
};

/// What the eye sees of a printed raster through its sheet, one pixel for each lens and as high as wide, in
/// linear light.
///
/// `raster` is the print itself (RGB or gray, linear, of the layout's size), not its views. Every lens is the
/// mean over its aperture, by exact refraction. A ray that leaves its own strip shows what is printed under the
/// neighboring lens: at the edge of the zone the views start again. Beyond the print there is white paper.
/// The sheet lies with a lens axis through the middle of the print. Throws Failure when the sizes differ.
[[nodiscard]] render::Image lookThrough(const PrintLayout&, const render::Image& raster, const Eye&,
                                        int apertureParts = 128);

/// The same of a print in a file, of any size; memory holds a few lenses' rows of it.
[[nodiscard]] render::Image lookThrough(PrintRaster&, const Eye&, int apertureParts = 128);

/// The eye's angle across the lenses, in radians, at which view `k` is in the middle of the zone's k-th part:
/// the inverse of the exact mean over the lens.
[[nodiscard]] double angleOfView(const PrintLayout&, int k);

}  // namespace vitrine::printing
