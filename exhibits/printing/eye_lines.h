#pragma once

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/proof.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// RGB as files store it, sRGB-encoded, 8 bit, row 0 at the top, no padding.
struct CodedPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb{};
};

/// A part of what an eye sees of a lens: across it from its middle, millimeters, and how much of the whole.
struct SeenPoint {
    double across = 0;
    float share = 0;
};

/// A print made along a few lines only, to look at through its lenses while it is being set up.
///
/// Across the lenses the lines are the printed raster, pixel for pixel; along them, where neighbors hardly
/// differ, only as many are kept as a preview shows. `lookThrough` is the full answer for a finished print;
/// this is the same optics in a hundredth of the time. Left out: that a ray from above or below also moves
/// along the lens, by less than the sheet's thickness.
class EyeLines {
public:
    /// Makes at most `lines` lines. Layout must outlive it; the interlacer is only used here.
    EyeLines(const PrintLayout&, const Interlacer&, int lines);

    /// What the eye sees, about `side` pixels along the longer side; one lens fills several of them, or one
    /// pixel shows the lens under its center.
    [[nodiscard]] CodedPicture seen(const Eye&, int side) const;

private:
    /// Linear color of these points of a lens. `start`: pixels along the line, `off`: millimeters to the lens's middle,
    /// `along`: which of the lines, 0 to 1.
    [[nodiscard]] std::array<float, 3> under(const std::vector<SeenPoint>&, double start, double off,
                                             double along) const;
    [[nodiscard]] std::int64_t acrossPixels() const { return upright_ ? layout_.width() : layout_.height(); }
    [[nodiscard]] std::int64_t alongPixels() const { return upright_ ? layout_.height() : layout_.width(); }

    const PrintLayout& layout_;
    bool upright_;
    int lines_;
    std::vector<std::uint8_t> codes_;  ///< Line by line, each across the lenses, three channels.
};

}  // namespace vitrine::printing
