#include "exhibits/lenticular/interlace_kernels.h"

#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#if defined(__x86_64__)
#define VITRINE_AVX2 [[gnu::target("avx2")]]
#endif

namespace vitrine::lenticular::kernels {
namespace {

using Four = float __attribute__((vector_size(16)));
using FourCodes = std::uint16_t __attribute__((vector_size(8)));
using FourInts = std::int32_t __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));
using EightCodes = std::uint16_t __attribute__((vector_size(16)));
using EightInts = std::int32_t __attribute__((vector_size(32)));


[[gnu::always_inline]] inline Four load(const float* at)
{
    Four four;
    std::memcpy(&four, at, sizeof four);
    return four;
}

/// `pairs` is that of every span, or 0 when they differ: a known count needs no guessing of branches.
template <int pairs>
[[gnu::always_inline]] inline void filterLensesOf(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count,
                                                  const float* weights, float* lenses)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Interlacer::LensSpan span = spans[i];
        const std::uint16_t* at = row + static_cast<std::size_t>(span.column) * 4;
        __builtin_prefetch(at + 1024);  // Rows of other views are far apart: the processor does not foresee them.
        const float* w = weights + span.first;
        Eight sum{};
        const int all = pairs > 0 ? pairs : span.pairs;
        for (int pair = 0; pair < all; ++pair, at += 8, w += 8) {
            EightCodes codes;
            Eight weight;
            std::memcpy(&codes, at, sizeof codes);
            std::memcpy(&weight, w, sizeof weight);
            sum += __builtin_convertvector(__builtin_convertvector(codes, EightInts), Eight) * weight;
        }
        const Four mean = __builtin_shufflevector(sum, sum, 0, 1, 2, 3) + __builtin_shufflevector(sum, sum, 4, 5, 6, 7);
        std::memcpy(lenses + i * 4, &mean, sizeof mean);
    }
}

[[gnu::always_inline]] inline void filterLensesBody(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count,
                                                    const float* weights, float* lenses)
{
    bool alike = true;
    for (std::size_t i = 1; i < count; ++i) alike = alike && spans[i].pairs == spans[0].pairs;
    switch (alike ? spans[0].pairs : 0) {
    case 1: return filterLensesOf<1>(row, spans, count, weights, lenses);
    case 2: return filterLensesOf<2>(row, spans, count, weights, lenses);
    case 3: return filterLensesOf<3>(row, spans, count, weights, lenses);
    case 4: return filterLensesOf<4>(row, spans, count, weights, lenses);
    default: return filterLensesOf<0>(row, spans, count, weights, lenses);
    }
}

[[gnu::always_inline]] inline void mixColumnsBody(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start,
                                                  std::size_t columns, std::uint16_t* out)
{
    for (std::size_t x = 0; x < columns; ++x) {
        const Interlacer::ColumnTap* tap = taps + start[x];
        const Interlacer::ColumnTap* end = taps + start[x + 1];
        Four sum = load(lenses + static_cast<std::size_t>(tap->slot) * 4) * tap->weight;
        for (++tap; tap != end; ++tap) sum += load(lenses + static_cast<std::size_t>(tap->slot) * 4) * tap->weight;
        const FourCodes codes = __builtin_convertvector(__builtin_convertvector(sum + 0.5F, FourInts), FourCodes);
        std::memcpy(out + x * 3, &codes, sizeof codes);
    }
}

constexpr std::size_t chunk = 512;

[[gnu::always_inline]] inline void blendBody(const std::uint16_t* a, const std::uint16_t* b, int part, std::size_t count, std::uint16_t* out)
{
    for (std::size_t i = 0; i < count; ++i) {
        const int from = a[i];
        const int to = b[i];
        out[i] = static_cast<std::uint16_t>(from + (((to - from) * part + 16384) >> 15));
    }
}

/// 13 bits of linear light to 8 of sRGB: small enough for the first cache. In the darkest tones, where a code
/// is 20 of 65536, the cells are 8 wide: every 8-bit code comes back as itself.
constexpr int shift = 3;
using Codes8 = std::array<std::uint8_t, (65536U >> shift)>;
const Codes8& codes8()
{
    static const auto table = [] {
        Codes8 t{};
        for (std::size_t i = 0; i < t.size(); ++i) t.at(i) = render::srgb8FromLinear(static_cast<float>((static_cast<double>(i << shift) + 3.5) / 65535));
        return t;
    }();
    return table;
}

const std::array<std::uint16_t, 65536>& codes16()
{
    static const auto table = [] {
        auto t = std::make_unique<std::array<std::uint16_t, 65536>>();
        for (std::size_t i = 0; i < t->size(); ++i) t->at(i) = render::srgb16FromLinear(static_cast<float>(static_cast<double>(i) / 65535));
        return t;
    }();
    return *table;
}

[[gnu::always_inline]] inline void encode(const std::uint16_t* linear, std::size_t count, std::uint8_t* out)
{
    const std::uint8_t* table = codes8().data();
    for (std::size_t i = 0; i < count; ++i) out[i] = table[linear[i] >> shift];
}

[[gnu::always_inline]] inline void encode(const std::uint16_t* linear, std::size_t count, std::uint16_t* out)
{
    const std::uint16_t* table = codes16().data();
    for (std::size_t i = 0; i < count; ++i) out[i] = table[linear[i]];
}

template <typename Code>
[[gnu::always_inline]] inline void blendAndEncodeBody(const std::uint16_t* a, const std::uint16_t* b, int part, std::size_t count, Code* out)
{
    if (part == 0) return encode(a, count, out);
    std::array<std::uint16_t, chunk> mixed;
    for (std::size_t at = 0; at < count; at += chunk) {
        const std::size_t size = std::min(chunk, count - at);
        blendBody(a + at, b + at, part, size, mixed.data());
        encode(mixed.data(), size, out + at);
    }
}

#if defined(VITRINE_AVX2)
VITRINE_AVX2 void filterLensesAvx2(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count, const float* weights, float* lenses)
{
    filterLensesBody(row, spans, count, weights, lenses);
}
VITRINE_AVX2 void mixColumnsAvx2(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start, std::size_t columns, std::uint16_t* out)
{
    mixColumnsBody(lenses, taps, start, columns, out);
}
VITRINE_AVX2 void blendAndEncodeAvx2(const std::uint16_t* a, const std::uint16_t* b, int part, std::size_t count, std::uint8_t* out)
{
    blendAndEncodeBody(a, b, part, count, out);
}
const bool avx2 = __builtin_cpu_supports("avx2") != 0;
#endif

}  // namespace

void filterLenses(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count, const float* weights, float* lenses)
{
#if defined(VITRINE_AVX2)
    if (avx2) return filterLensesAvx2(row, spans, count, weights, lenses);
#endif
    filterLensesBody(row, spans, count, weights, lenses);
}

void mixColumns(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start, std::size_t columns, std::uint16_t* out)
{
#if defined(VITRINE_AVX2)
    if (avx2) return mixColumnsAvx2(lenses, taps, start, columns, out);
#endif
    mixColumnsBody(lenses, taps, start, columns, out);
}

void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, int part, std::size_t count, std::uint8_t* out)
{
#if defined(VITRINE_AVX2)
    if (avx2) return blendAndEncodeAvx2(a, b, part, count, out);
#endif
    blendAndEncodeBody(a, b, part, count, out);
}

void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, int part, std::size_t count, std::uint16_t* out)
{
    blendAndEncodeBody(a, b, part, count, out);
}

}  // namespace vitrine::lenticular::kernels
