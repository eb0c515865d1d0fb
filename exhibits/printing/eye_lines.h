#pragma once

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/proof.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// RGB in file encoding: sRGB, 8 bit, row 0 at the top, no padding.
struct CodedPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb{};
};

/// Part of what an eye sees of a lens: position across it from its center in millimeters, and share of the whole.
struct SeenPoint {
    double across = 0;
    float share = 0;
};

/// A print made along a few lines only, for a preview through its lenses.
///
/// Across the lenses, the lines are the printed raster, pixel by pixel. Along them, where neighbors hardly differ, only
/// as many lines are kept as a preview shows.
///
/// `lookThrough` is the complete simulation of a finished print. This class uses the same optics in a hundredth of the
/// time. It neglects that a ray from above or below also moves along the lens, by less than the sheet's thickness.
class EyeLines {
public:
    /// Makes at most `lines` lines. The layout must outlive it; the interlacer is used here only.
    EyeLines(const PrintLayout&, const Interlacer&, int lines);

    /// Returns what the eye sees, about `side` pixels along the longer side. A lens covers several pixels, or a pixel
    /// shows the lens under its center.
    [[nodiscard]] CodedPicture seen(const Eye&, int side) const;

private:
    /// Returns the linear color of these points of a lens. `start` is in pixels along the line, `off` in millimeters to
    /// the center of the lens. `along` selects the line, 0 to 1.
    [[nodiscard]] std::array<float, 3> under(const std::vector<SeenPoint>&, double start, double off,
                                             double along) const;
    [[nodiscard]] std::int64_t acrossPixels() const { return upright_ ? layout_.width() : layout_.height(); }
    [[nodiscard]] std::int64_t alongPixels() const { return upright_ ? layout_.height() : layout_.width(); }

    const PrintLayout& layout_;
    bool upright_;
    int lines_;
    std::vector<std::uint8_t> codes_;  ///< Line by line, each across the lenses, with three channels.
};

}  // namespace vitrine::printing
