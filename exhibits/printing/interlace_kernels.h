#pragma once

#include "exhibits/printing/lens_plan.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The inner loops of the interlacer, for the basic instruction set and for newer ones. All give the same bits: the
/// order of operations is fixed, and multiplications are not fused with additions.
namespace vitrine::printing {

/// Instruction sets with kernels of their own. AVX-512 kernels made a print of 9600 x 6400 pixels 11 % faster (median
/// of six pairs), less than the 15 % that would have justified them.
enum class Instructions : std::uint8_t { plain, avx2 };

/// Returns the newest instructions that this processor supports.
[[nodiscard]] Instructions bestInstructions();

namespace kernels {

/// Floats that an array of slots needs after its last slot.
constexpr std::size_t behindSlots = 64;
/// Samples that `mixColumns` may write before the first and after the last.
constexpr std::size_t besideColumns = 16;

/// Inner loops; each entry is the same function for different instructions.
struct Kernels {
    /// Sets slots to the mean of a view over each lens's span, for the lenses from `first` to `last`, excluding the
    /// end. `rows` has one row per slot of a lens, and three more that may be read.
    void (*filterLenses)(const LensPlan&, const std::uint16_t* const* rows, LensPlan::Lenses, float* slots);
    /// Sets out[3 x + c] to the weighted sum of slots, rounded, for the columns from x0 to x1, excluding the end.
    void (*mixColumns)(const LensPlan&, const float* slots, std::size_t x0, std::size_t x1, std::uint16_t* out);
    /// Write the sRGB codes of a + (b - a) part / 65536, rounded towards a, for samples of linear light in 16 bits.
    void (*encode8)(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                    std::uint8_t* out);
    void (*encode16)(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                     std::uint16_t* out);
};

/// Returns the kernels for instructions that the processor must support.
[[nodiscard]] const Kernels& kernelsFor(Instructions);

/// Mixes views: each slot of view i becomes the sum of that lens's slots of all views k, weighted by `matrix` [i *
/// views + k]. Results are clamped to 0 and 65535.
void combineViews(const LensPlan&, const float* slots, const std::vector<double>& matrix, LensPlan::Lenses, float* out);

}  // namespace kernels
}  // namespace vitrine::printing
