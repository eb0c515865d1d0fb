#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/eye_lines.h"
#include "exhibits/printing/print_views.h"

#include <memory>
#include <mutex>
#include <optional>

namespace vitrine::printing {

/// Where the lenses lie on a raster: at (x, y), in pixels from its top left corner, `at0 + perX x + perY y`
/// lenses; cusps are where that is a whole number.
struct LensGrid {
    double at0 = 0, perX = 0, perY = 0;
};

/// A print or a chart to look at before it is made, made where it is looked at. Every function may be called from any
/// thread.
class PrintPreview {
public:
    PrintPreview(const PrintLayout&, std::shared_ptr<const PrintViews>);
    PrintPreview(const PrintLayout&, Chart);

    [[nodiscard]] std::int64_t width() const { return layout_.width(); }
    [[nodiscard]] std::int64_t height() const { return layout_.height(); }
    /// On the raster as it is written, mirrored or not.
    [[nodiscard]] LensGrid lenses() const;
    /// The raster itself, exactly as a file of 8 bits will have it. The region must lie on the raster.
    [[nodiscard]] CodedPicture raster(const Region&) const;
    /// The eye that looks at the middle of the print from `right` of its normal and from `above` it, in radians;
    /// `distance` in millimeters.
    [[nodiscard]] Eye eyeAt(double right, double above, double distance) const;
    /// What an eye sees of that raster through the lenses; about `side` pixels along the longer side. Empty for
    /// charts, which are looked at with their sheet in the hand.
    [[nodiscard]] CodedPicture seen(const Eye&, int side) const;

private:
    PrintLayout layout_;
    std::shared_ptr<const PrintViews> views_;  ///< Null for a chart.
    std::optional<Interlacer> interlacer_;
    std::optional<Chart> chart_;
    mutable std::once_flag linesMade_;
    mutable std::unique_ptr<const EyeLines> lines_;  ///< Made when first looked through.
};

}  // namespace vitrine::printing
