#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/eye_lines.h"
#include "exhibits/printing/print_marks.h"
#include "exhibits/printing/print_views.h"
#include "exhibits/printing/soft_proof.h"

#include <memory>
#include <mutex>
#include <optional>

namespace vitrine::printing {

/// Position of the lenses on a raster: at (x, y), in pixels from its top left corner, `at0 + perX x + perY y` lenses.
/// Cusps are where that is a whole number.
struct LensGrid {
    double at0 = 0, perX = 0, perY = 0;
};

/// Preview of a print or chart that computes only the viewed parts. Thread-safe.
class PrintPreview {
public:
    /// `proof` may be null: colors are then shown as they are before they are converted.
    PrintPreview(const PrintLayout&, std::shared_ptr<const PrintViews>, std::shared_ptr<const SoftProof> proof = {});
    PrintPreview(const PrintLayout&, Chart);

    [[nodiscard]] std::int64_t width() const { return layout_.width(); }
    [[nodiscard]] std::int64_t height() const { return layout_.height(); }
    /// Returns the lenses on the raster as written, mirrored or not.
    [[nodiscard]] LensGrid lenses() const;
    /// Returns a part of the raster with its marks, exactly as in an 8-bit file, or with the colors that the printer
    /// makes of it. The region must be inside the raster.
    [[nodiscard]] CodedPicture raster(const Region&) const;
    /// Returns the eye that looks at the center of the print from `right` of its normal and from `above` it, in
    /// radians. `distance` is in millimeters.
    [[nodiscard]] Eye eyeAt(double right, double above, double distance) const;
    /// Returns what an eye sees of that raster through the lenses, about `side` pixels along the longer side. Empty for
    /// charts, which are viewed with the sheet in the hand.
    [[nodiscard]] CodedPicture seen(const Eye&, int side) const;

private:
    PrintLayout layout_;
    std::shared_ptr<const PrintViews> views_;  ///< Null for a chart.
    std::shared_ptr<const SoftProof> proof_;
    PrintMarks marks_;
    std::optional<Interlacer> interlacer_;
    std::optional<Chart> chart_;
    mutable std::once_flag linesMade_;
    mutable std::unique_ptr<const EyeLines> lines_;  ///< Made at the first call of `seen`.
};

}  // namespace vitrine::printing
