#include "exhibits/printing/interlace_kernels.h"

#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#if defined(__x86_64__)
#include <immintrin.h>
#define VITRINE_AVX2 [[gnu::target("avx2")]]
#endif

namespace vitrine::printing::kernels {
namespace {

using Four = float __attribute__((vector_size(16)));
using FourCodes = std::uint16_t __attribute__((vector_size(8)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Four load(const float* at)
{
    Four four;
    std::memcpy(&four, at, sizeof four);
    return four;
}

/// In samples: about the same view's next row. It is read after those of the other views, too late for
/// the processor's own prefetching.
constexpr std::size_t ahead = 4096;

[[gnu::always_inline]] inline Four samples(const std::uint16_t* at)
{
    FourCodes codes;
    std::memcpy(&codes, at, sizeof codes);
    return __builtin_convertvector(__builtin_convertvector(codes, FourInts), Four);
}

/// `pairs` is that of every span, or 0 when they differ: a known count needs no guessing of branches.
template <int pairs>
void filterLensesPlain(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count,
                       const float* weights, float* lenses)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Interlacer::LensSpan span = spans[i];
        const std::uint16_t* at = row + static_cast<std::size_t>(span.column) * 4;
        __builtin_prefetch(at + ahead);
        const float* w = weights + span.first;
        Four even{};
        Four odd{};
        const int all = pairs > 0 ? pairs : span.pairs;
        for (int pair = 0; pair < all; ++pair, at += 8, w += 8) {
            even += samples(at) * load(w);
            odd += samples(at + 4) * load(w + 4);
        }
        const Four mean = even + odd;
        std::memcpy(lenses + i * 4, &mean, sizeof mean);
    }
}

#if defined(VITRINE_AVX2)
/// By hand: the compiler takes vectors of eight apart before it knows that there are such.
template <int pairs>
VITRINE_AVX2 void filterLensesAvx2(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count,
                                   const float* weights, float* lenses)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Interlacer::LensSpan span = spans[i];
        const std::uint16_t* at = row + static_cast<std::size_t>(span.column) * 4;
        __builtin_prefetch(at + ahead);
        const float* w = weights + span.first;
        __m256 sum = _mm256_setzero_ps();
        const int all = pairs > 0 ? pairs : span.pairs;
        for (int pair = 0; pair < all; ++pair, at += 8, w += 8) {
            const __m256i wide = _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
            sum = _mm256_add_ps(sum, _mm256_mul_ps(_mm256_cvtepi32_ps(wide), _mm256_loadu_ps(w)));
        }
        _mm_storeu_ps(lenses + i * 4, _mm_add_ps(_mm256_castps256_ps128(sum), _mm256_extractf128_ps(sum, 1)));
    }
}
const bool avx2 = __builtin_cpu_supports("avx2") != 0;
#endif

template <int pairs>
void filterLensesOf(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count,
                    const float* weights, float* lenses)
{
#if defined(VITRINE_AVX2)
    if (avx2) return filterLensesAvx2<pairs>(row, spans, count, weights, lenses);
#endif
    filterLensesPlain<pairs>(row, spans, count, weights, lenses);
}

[[gnu::always_inline]] inline void mixColumnsBody(const float* lenses, const Interlacer::ColumnTap* taps,
                                                  const std::uint32_t* start, std::size_t columns, std::uint16_t* out)
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

/// The samples of a + (b - a) part / 65536, rounded towards a so that equal samples stay as they are, without
/// their lowest `drop` bits.
void blend(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, int drop, std::size_t count,
           std::uint16_t* out)
{
    std::size_t i = 0;
#if defined(__x86_64__)
    const __m128i parts = _mm_set1_epi16(static_cast<short>(part));
    const __m128i places = _mm_cvtsi32_si128(drop);
    for (; i + 8 <= count; i += 8) {
        const __m128i from = _mm_loadu_si128(reinterpret_cast<const __m128i*>(a + i));
        const __m128i to = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b + i));
        const __m128i up = _mm_mulhi_epu16(_mm_subs_epu16(to, from), parts);
        const __m128i down = _mm_mulhi_epu16(_mm_subs_epu16(from, to), parts);
        const __m128i mixed = _mm_sub_epi16(_mm_add_epi16(from, up), down);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(out + i), _mm_srl_epi16(mixed, places));
    }
#endif
    for (; i < count; ++i) {
        const std::uint32_t from = a[i];
        const std::uint32_t to = b[i];
        const std::uint32_t mixed =
            to > from ? from + (((to - from) * part) >> 16U) : from - (((from - to) * part) >> 16U);
        out[i] = static_cast<std::uint16_t>(mixed >> static_cast<unsigned>(drop));
    }
}

/// 13 bits of linear light to 8 of sRGB: small enough for the first cache. In the darkest tones, where a code
/// is 20 of 65536, the cells are 8 wide: every 8-bit code comes back as itself.
constexpr int dropped = 3;
using Codes8 = std::array<std::uint8_t, (65536U >> dropped)>;
const Codes8& codes8()
{
    static const auto table = [] {
        Codes8 t{};
        for (std::size_t i = 0; i < t.size(); ++i)
            t.at(i) = render::srgb8FromLinear(static_cast<float>((static_cast<double>(i << dropped) + 3.5) / 65535));
        return t;
    }();
    return table;
}

const std::array<std::uint16_t, 65536>& codes16()
{
    static const auto table = [] {
        auto t = std::make_unique<std::array<std::uint16_t, 65536>>();
        for (std::size_t i = 0; i < t->size(); ++i)
            t->at(i) = render::srgb16FromLinear(static_cast<float>(static_cast<double>(i) / 65535));
        return t;
    }();
    return *table;
}

template <typename Code>
void blendAndLookUp(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, int drop, const Code* table,
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

#if defined(VITRINE_AVX2)
VITRINE_AVX2 void mixColumnsAvx2(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start,
                                 std::size_t columns, std::uint16_t* out)
{
    mixColumnsBody(lenses, taps, start, columns, out);
}
#endif

}  // namespace

void filterLenses(const std::uint16_t* row, const Interlacer::LensSpan* spans, std::size_t count, const float* weights,
                  float* lenses)
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

void combineViews(const float* lenses, const double* matrix, std::size_t views, std::size_t lensCount, float* out)
{
    const std::size_t samples = lensCount * 4;
    for (std::size_t i = 0; i < views; ++i, out += samples) {
        std::fill_n(out, samples, 0.0F);
        for (std::size_t k = 0; k < views; ++k) {
            const auto weight = static_cast<float>(matrix[i * views + k]);
            const float* from = lenses + k * samples;
            for (std::size_t j = 0; j < samples; ++j) out[j] += weight * from[j];
        }
        for (std::size_t j = 0; j < samples; ++j) out[j] = std::clamp(out[j], 0.0F, 65535.0F);
    }
}

void mixColumns(const float* lenses, const Interlacer::ColumnTap* taps, const std::uint32_t* start, std::size_t columns,
                std::uint16_t* out)
{
#if defined(VITRINE_AVX2)
    if (avx2) return mixColumnsAvx2(lenses, taps, start, columns, out);
#endif
    mixColumnsBody(lenses, taps, start, columns, out);
}

void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                    std::uint8_t* out)
{
    blendAndLookUp(a, b, part, dropped, codes8().data(), count, out);
}

void blendAndEncode(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                    std::uint16_t* out)
{
    blendAndLookUp(a, b, part, 0, codes16().data(), count, out);
}

}  // namespace vitrine::printing::kernels
