#pragma once

#include "exhibits/printing/sheet.h"

#include <optional>
#include <utility>
#include <vector>

namespace vitrine::printing {

/// Where one ray, from the eye through a lens, meets the print. Lengths in millimeters.
struct Landing {
    double x = 0;       ///< On the print, across the lens, from the lens's axis.
    double weight = 0;  ///< Area that this part of the lens shows to the eye, per length of x0.
    double depth = 0;   ///< From the surface down to the print.
    double psi = 0;     ///< Angle of the ray inside the sheet, in the plane across the lens.
};

/// How far the lens's surface lies below its top at `x0` from the axis. `x0` must lie on the surface.
[[nodiscard]] double sag(const Sheet&, double x0);

/// Exact refraction (Snell on a conic) of the ray that meets the lens at `x0`. `theta` is the eye's angle from
/// the normal, in radians; positive when the eye is on the side of positive x. Nothing when the surface there
/// does not exist, turns its back to the eye, or is hidden by the next lens.
[[nodiscard]] std::optional<Landing> trace(const Sheet&, double x0, double theta);

/// The undeviated ray through the center of curvature: -(t - r) tan(theta).
[[nodiscard]] double chiefRay(const Sheet&, double theta);

/// First order in x0 and theta: x0 (1 - t/f) - t/n theta, with f = n r / (n-1).
[[nodiscard]] double paraxial(const Sheet&, double x0, double theta);

/// The index that turns a ray out of the cross-section by `beta` (radians) into a plane problem:
/// sqrt(n^2 - sin^2 beta) / cos beta. Exact for cylinders, since refraction keeps the component along them.
[[nodiscard]] double effectiveIndex(double index, double beta);

/// A lens as the eye sees it from one direction: equal parts of its width, each with the piece of print it
/// shows and its share of the light. Parts that are not seen are left out; shares sum to 1.
struct Aperture {
    struct Part {
        double from = 0, to = 0;  ///< On the print, across, from the lens's axis; `from` may exceed `to`.
        double share = 0;
        double depth = 0, psi = 0;
    };
    std::vector<Part> parts{};
    double mean = 0;  ///< Of x on the print.
    double rms = 0;   ///< Of x around the mean: the size of the spot.
};
/// `beta` is the eye's angle out of the cross-section. Empty when nothing of the lens is seen.
[[nodiscard]] Aperture aperture(const Sheet&, double theta, double beta = 0, int parts = 256);

/// The full angle in which the views are seen once, in radians, by the four definitions in use.
[[nodiscard]] double zoneByChiefRay(const Sheet&);
[[nodiscard]] double zoneByAperture(const Sheet&);  ///< Where the exact mean over the lens reaches half a pitch.

}  // namespace vitrine::printing
