#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/interlace_kernels.h"
#include "exhibits/printing/lens_plan.h"
#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <cstdint>
#include <optional>

namespace vitrine::printing {

/// A part of the raster, ends excluded.
struct Region {
    std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Makes any part of a print's raster, always the same bits however the raster is cut up and however many
/// threads work on it.
///
/// Each view is sampled at the axis of the lens that shows it, averaged over one lens: that is all the lens
/// can resolve, and sampling at the pixel instead would slide the picture by up to one lens between the first
/// view and the last. Everything is mixed in linear light and encoded as sRGB at the end.
///
/// Where the layout asks for it, the views are compensated for cross-talk first, in linear light and held to black
/// and white, and 8-bit codes are dithered. The border is white.
///
/// Vertical lenses are the fast case: a row of the views is interlaced once and printed rows are interpolated
/// between two such rows. With Method::nearest nothing is mixed in that direction either, unless the views
/// have more rows than the print.
class Interlacer {
public:
    /// Keeps a reference to the views. The bits are the same by any instructions, which the processor must have. Throws
    /// Failure when layout and views disagree about the number of views.
    Interlacer(const PrintLayout&, const ViewSet&, Instructions = bestInstructions());

    /// Fills `out` with RGB, row by row without padding. The region must lie on the raster.
    void fill(const Region&, std::uint8_t* out, int threads = 1) const;
    void fill(const Region&, std::uint16_t* out, int threads = 1) const;

private:
    template <typename Code> void fillThreaded(const Region&, Code* out, int threads) const;
    template <typename Code> void fillPart(const Region&, Code* out) const;
    template <typename Code> void fillInner(const Region&, Code* out) const;
    template <typename Code> void fillVertical(const Region&, Code* out) const;
    template <typename Code> void fillSlanted(const Region&, Code* out) const;
    struct Workplace;
    void interlaceViewRow(int row, const Region&, Workplace&, std::uint16_t* out) const;

    PrintLayout layout_;  ///< Without the border.
    std::int64_t borderX_, borderY_;
    const ViewSet& views_;
    ViewMatrix compensation_;
    std::optional<LensPlan> plan_;  ///< Of vertical lenses.
    const kernels::Kernels& kernels_;
};

/// What is added to a code before it is rounded down, 0 to 1: an ordered pattern without visible period, even over
/// every small neighborhood. It depends on the place on the raster and nothing else.
/// J. Jimenez, Next generation post processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014 (interleaved
/// gradient noise).
[[nodiscard]] double ditherAt(std::int64_t x, std::int64_t y, int channel);

/// Codes of 8 bits from codes of 16, a region's rows without padding. Codes that 8 bits have stay as they are.
void ditherRows(const Region&, const std::uint16_t* from, std::uint8_t* to);

}  // namespace vitrine::printing
