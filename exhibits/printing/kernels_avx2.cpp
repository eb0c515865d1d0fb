#include "exhibits/printing/kernel_sets.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>
#include <cstring>

// The target attribute is explicit: the compiler splits vectors of eight before it knows that AVX2 supports them.
#define VITRINE_AVX2 [[gnu::target("avx2")]]

namespace vitrine::printing::kernels {
namespace {

[[gnu::always_inline]] VITRINE_AVX2 inline __m256 weighted(const std::uint16_t* pair, __m256 weights)
{
    const __m256i wide = _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(pair)));
    return _mm256_mul_ps(_mm256_cvtepi32_ps(wide), weights);
}

/// Adds the sums of the even columns and of the odd ones.
[[gnu::always_inline]] VITRINE_AVX2 inline void store(__m256 sum, float* out)
{
    const __m256 odd = _mm256_permutevar8x32_ps(sum, _mm256_setr_epi32(3, 4, 5, 6, 7, 7, 7, 7));
    _mm_storeu_ps(out, _mm_add_ps(_mm256_castps256_ps128(sum), _mm256_castps256_ps128(odd)));
}

/// For views of different widths, or of many columns per lens.
VITRINE_AVX2 void filterEach(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses,
                             float* slots)
{
    for (std::size_t lens = lenses.first; lens < lenses.last; ++lens) {
        float* out = slots + lens * plan.views * 3;
        for (std::size_t slot = 0; slot < plan.views; ++slot, out += 3) {
            const LensPlan::Span span = plan.spans[plan.spansOf[slot] + lens];
            const std::uint16_t* at = rows[slot] + static_cast<std::size_t>(span.column) * 3;
            __builtin_prefetch(at + ahead);
            const float* w = plan.weights.data() + span.first;
            __m256 sum = _mm256_setzero_ps();
            for (int pair = 0; pair < span.pairs; ++pair, at += 6, w += 8)
                sum = _mm256_add_ps(sum, weighted(at, _mm256_loadu_ps(w)));
            store(sum, out);
        }
    }
}

/// For views of one width: each lens has one span, whose weights stay in registers.
template <std::size_t pairs>
VITRINE_AVX2 void filterAlike(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses,
                              float* slots)
{
    float* out = slots + lenses.first * plan.views * 3;
    for (std::size_t lens = lenses.first; lens < lenses.last; ++lens) {
        const LensPlan::Span span = plan.spans[lens];
        const std::size_t column = static_cast<std::size_t>(span.column) * 3;
        __m256 weights[pairs];
        for (std::size_t pair = 0; pair < pairs; ++pair)
            weights[pair] = _mm256_loadu_ps(plan.weights.data() + span.first + pair * 8);
        for (std::size_t slot = 0; slot < plan.views; ++slot, out += 3) {
            const std::uint16_t* at = rows[slot] + column;
            __builtin_prefetch(at + ahead);
            __m256 sum = weighted(at, weights[0]);
            for (std::size_t pair = 1; pair < pairs; ++pair)
                sum = _mm256_add_ps(sum, weighted(at + pair * 6, weights[pair]));
            store(sum, out);
        }
    }
}

void filterLenses(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses, float* slots)
{
    const int pairs = plan.spans[0].pairs;
    const auto alike = [&](const LensPlan::Span& span) { return span.pairs == pairs; };
    if (plan.spans.size() == plan.lenses && std::all_of(plan.spans.begin(), plan.spans.end(), alike)) {
        switch (pairs) {
        case 1: return filterAlike<1>(plan, rows, lenses, slots);
        case 2: return filterAlike<2>(plan, rows, lenses, slots);
        case 3: return filterAlike<3>(plan, rows, lenses, slots);
        case 4: return filterAlike<4>(plan, rows, lenses, slots);
        default: break;
        }
    }
    filterEach(plan, rows, lenses, slots);
}

/// `taps` is that of every column, or 0 if they differ.
template <std::size_t taps>
VITRINE_AVX2 void mixColumnsOf(const LensPlan& plan, const float* slots, std::size_t x0, std::size_t x1,
                               std::uint16_t* out)
{
    const std::size_t all = taps > 0 ? taps : plan.taps;
    const float* weight = plan.tapWeights.data() + x0 * all;
    const __m128 half = _mm_set1_ps(0.5F);
    for (std::size_t x = x0; x < x1; ++x, out += 3, weight += all) {
        const float* slot = slots + static_cast<std::size_t>(plan.firstSlot[x]) * 3;
        __m128 sum = _mm_mul_ps(_mm_loadu_ps(slot), _mm_set1_ps(weight[0]));
        for (std::size_t tap = 1; tap < all; ++tap)
            sum = _mm_add_ps(sum, _mm_mul_ps(_mm_loadu_ps(slot + tap * 3), _mm_set1_ps(weight[tap])));
        const __m128i codes = _mm_cvttps_epi32(_mm_add_ps(sum, half));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(out), _mm_packus_epi32(codes, codes));
    }
}

void mixColumns(const LensPlan& plan, const float* slots, std::size_t x0, std::size_t x1, std::uint16_t* out)
{
    switch (plan.taps) {
    case 1: return mixColumnsOf<1>(plan, slots, x0, x1, out);
    case 2: return mixColumnsOf<2>(plan, slots, x0, x1, out);
    case 3: return mixColumnsOf<3>(plan, slots, x0, x1, out);
    case 4: return mixColumnsOf<4>(plan, slots, x0, x1, out);
    default: return mixColumnsOf<0>(plan, slots, x0, x1, out);
    }
}

VITRINE_AVX2 void blend(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, int drop, std::size_t count,
                        std::uint16_t* out)
{
    const __m256i parts = _mm256_set1_epi16(static_cast<short>(part));
    const __m128i places = _mm_cvtsi32_si128(drop);
    std::size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const __m256i from = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(a + i));
        const __m256i to = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b + i));
        const __m256i up = _mm256_mulhi_epu16(_mm256_subs_epu16(to, from), parts);
        const __m256i down = _mm256_mulhi_epu16(_mm256_subs_epu16(from, to), parts);
        const __m256i mixed = _mm256_sub_epi16(_mm256_add_epi16(from, up), down);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + i), _mm256_srl_epi16(mixed, places));
    }
    for (; i < count; ++i) out[i] = blended(a[i], b[i], part, drop);
}

}  // namespace

const Kernels avx2Kernels = {
    filterLenses, mixColumns,
    [](const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count, std::uint8_t* out) {
        blendAndLookUp<blend, dropped>(a, b, part, codes8().data(), count, out);
    },
    [](const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count, std::uint16_t* out) {
        blendAndLookUp<blend, 0>(a, b, part, codes16().data(), count, out);
    }};

}  // namespace vitrine::printing::kernels

#endif
