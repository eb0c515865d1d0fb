#pragma once

#include "exhibits/printing/interlace.h"

#include <cstddef>
#include <cstdint>

/// The inner loops of the interlacer. The first two are compiled for the plain instruction set and for AVX2; both
/// give the same bits, since the order of operations is fixed and multiplications are not fused with additions.
namespace vitrine::printing::kernels {

/// lenses[slot] = the mean of `row` (four samples a pixel) over each span; four floats a lens.
void filterLenses(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count, const float* weights,
                  float* lenses);

/// Every lens of view i as the sum of that lens in all views k, weighted by `matrix` [i * views + k], held to 0 and
/// 65535.
void combineViews(const float* lenses, const double* matrix, std::size_t views, std::size_t lensCount, float* out);

/// out[3 x + c] = the weighted sum of lenses, rounded. Writes one sample beyond the last pixel.
void mixColumns(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start, std::size_t columns,
                std::uint16_t* out);

/// The sRGB codes of a + (b - a) part / 65536, for samples of linear light in 16 bits.
void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                    std::uint8_t* out);
void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                    std::uint16_t* out);

}  // namespace vitrine::printing::kernels
