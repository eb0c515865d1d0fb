#pragma once

#include "exhibits/printing/interlace_kernels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// Definitions shared by the sets of kernels.
namespace vitrine::printing::kernels {

extern const Kernels plainKernels;
#if defined(__x86_64__)
extern const Kernels avx2Kernels;
#endif

/// Prefetch distance in samples. Views are read in turn, a little of each, which is too many streams for the
/// processor's own prefetching.
constexpr std::size_t ahead = 1024;

/// Bits dropped for the table of 8-bit codes: 13 bits of linear light fit into the first cache. In the darkest tones,
/// where a code is 20 of 65536, the cells are 8 wide, so every 8-bit code is reproduced.
constexpr int dropped = 3;
using Codes8 = std::array<std::uint8_t, (65536U >> dropped)>;
[[nodiscard]] const Codes8& codes8();
using Codes16 = std::array<std::uint16_t, 65536>;
[[nodiscard]] const Codes16& codes16();

constexpr std::size_t chunk = 512;

/// Writes the samples of a + (b - a) part / 65536, without their lowest `drop` bits.
using Blend = void (*)(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, int drop, std::size_t count,
                       std::uint16_t* out);

template <Blend blend, int drop, typename Code>
void blendAndLookUp(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, const Code* table,
                    std::size_t count, Code* out)
{
    std::array<std::uint16_t, chunk> mixed;
    for (std::size_t at = 0; at < count; at += chunk) {
        const std::size_t size = std::min(chunk, count - at);
        blend(a + at, b + at, part, drop, size, mixed.data());
        std::size_t i = 0;
        for (; i + 8 <= size; i += 8) {
#pragma GCC unroll 8
            for (std::size_t j = i; j < i + 8; ++j) out[at + j] = table[mixed[j]];
        }
        for (; i < size; ++i) out[at + i] = table[mixed[i]];
    }
}

/// Returns one sample of `Blend`.
[[nodiscard]] inline std::uint16_t blended(std::uint32_t from, std::uint32_t to, std::uint32_t part, int drop)
{
    const std::uint32_t mixed = to > from ? from + (((to - from) * part) >> 16U) : from - (((from - to) * part) >> 16U);
    return static_cast<std::uint16_t>(mixed >> static_cast<unsigned>(drop));
}

}  // namespace vitrine::printing::kernels
