#pragma once

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/interlace_kernels.h"
#include "exhibits/printing/lens_plan.h"
#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <cstdint>
#include <optional>

namespace vitrine::printing {

/// Part of the raster, ends excluded.
struct Region {
    std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Makes any part of a print's raster. The bits do not depend on how the raster is divided or on the number of threads.
///
/// Each view is sampled at the axis of the lens that shows it, averaged over one lens, which is all that the lens can
/// resolve. Sampling at the pixel instead would shift the picture by up to one lens between the first view and the
/// last. Everything is mixed in linear light and encoded as sRGB at the end.
///
/// If the layout says so, the views are first compensated for cross-talk, in linear light and clamped to black and
/// white. 8-bit codes are dithered if the layout says so. The border is white.
///
/// Vertical lenses are the fast case: a row of the views is interlaced once, and printed rows are interpolated between
/// two such rows. With Method::nearest nothing is mixed in that direction either, unless the views have more rows than
/// the print.
class Interlacer {
public:
    /// Keeps a reference to the views. The processor must support the instructions; the bits are the same with any.
    /// Throws Failure if layout and views have different numbers of views.
    Interlacer(const PrintLayout&, const ViewSet&, Instructions = bestInstructions());

    /// Fills `out` with RGB, row by row without padding. The region must be inside the raster.
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
    std::optional<LensPlan> plan_;  ///< For vertical lenses only.
    const kernels::Kernels& kernels_;
};

/// Returns what is added to a code before it is rounded down, 0 to 1: an ordered pattern without visible period, even
/// over every small neighborhood. It depends only on the position in the raster. J. Jimenez, Next generation post
/// processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014 (interleaved gradient noise).
[[nodiscard]] double ditherAt(std::int64_t x, std::int64_t y, int channel);

/// Dithers 16-bit codes of a region to 8 bits, rows without padding. Codes that 8 bits can represent are unchanged.
void ditherRows(const Region&, const std::uint16_t* from, std::uint8_t* to);

}  // namespace vitrine::printing
