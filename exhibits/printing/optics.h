#pragma once

#include "exhibits/printing/sheet.h"

#include <optional>
#include <utility>
#include <vector>

namespace vitrine::printing {

/// Point where a ray, from the eye through a lens, meets the print. Lengths are in millimeters.
struct LensHit {
    double x = 0;       ///< Position on the print, across the lens, from the lens's axis.
    double weight = 0;  ///< Area of this part of the lens visible to the eye, per length of x0.
    double depth = 0;   ///< Distance from the surface down to the print.
    double psi = 0;     ///< Angle of the ray inside the sheet, in the plane across the lens.
};

/// Returns how far the lens's surface is below its top at `x0` from the axis. `x0` must be on the surface.
[[nodiscard]] double sag(const Sheet&, double x0);

/// Traces the ray that meets the lens at `x0` with exact refraction (Snell's law on a conic). `theta` is the eye's
/// angle from the normal in radians, positive if the eye is on the side of positive x. Returns nothing if the surface
/// does not exist there, faces away from the eye, or is hidden by the next lens.
[[nodiscard]] std::optional<LensHit> trace(const Sheet&, double x0, double theta);

/// Returns the landing to first order in x0 and theta: x0 (1 - t/f) - t/n theta, with f = n r / (n-1).
[[nodiscard]] double paraxial(const Sheet&, double x0, double theta);

/// Returns the index that reduces a ray out of the cross-section by `beta` (radians) to a plane problem: sqrt(n^2 -
/// sin^2 beta) / cos beta. Exact for cylinders, since refraction preserves the component along them.
[[nodiscard]] double effectiveIndex(double index, double beta);

/// A lens as seen from one direction: equal parts of its width, each with the piece of print that it shows and its
/// share of the light. Invisible parts are left out; shares sum to 1.
struct Aperture {
    struct Part {
        double from = 0, to = 0;  ///< Range on the print, across, from the lens's axis; `from` may exceed `to`.
        double share = 0;
        double depth = 0, psi = 0;
    };
    std::vector<Part> parts{};
    double mean = 0;  ///< Mean of x on the print.
    double rms = 0;   ///< Root mean square of x about the mean: the size of the spot.
};
/// Returns the aperture. `beta` is the eye's angle out of the cross-section. Empty if nothing of the lens is visible.
[[nodiscard]] Aperture aperture(const Sheet&, double theta, double beta = 0, int parts = 256);

/// Return the full angle in which all views are seen once, in radians, by two definitions.
[[nodiscard]] double zoneByChiefRay(const Sheet&);
[[nodiscard]] double
zoneByAperture(const Sheet&);  ///< Viewing zone, from the angle at which the mean over the lens is half a pitch.

}  // namespace vitrine::printing
