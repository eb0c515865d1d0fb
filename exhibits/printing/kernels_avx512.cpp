#include "exhibits/printing/kernel_sets.h"

#if defined(__x86_64__)
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 warns falsely of its own header (GCC bug 105593).
#endif
#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cstring>

#define VITRINE_AVX512 [[gnu::target("avx512f,avx512bw,avx512vl,avx512vbmi")]]

namespace vitrine::printing::kernels {
namespace {

VITRINE_AVX512 [[gnu::always_inline]] inline __m512i loaded(const void* at)
{
    return _mm512_loadu_si512(at);
}

/// The compiler does not see what it is a product of, and does not fuse it with an addition.
VITRINE_AVX512 [[gnu::always_inline]] inline __m512 product(__m512 a, __m512 b)
{
    __m512 result = _mm512_mul_ps(a, b);
    asm("" : "+v"(result));
    return result;
}

/// Two rows' samples of five columns, and one more each.
VITRINE_AVX512 [[gnu::always_inline]] inline __m512i fifteen(const std::uint16_t* a, const std::uint16_t* b)
{
    return _mm512_inserti64x4(_mm512_castsi256_si512(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(a))),
                              _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b)), 1);
}

/// Where the samples of one column of four views, sixteen samples each, are among 64: every second place, the others
/// become 0.
constexpr std::array<std::uint16_t, 32> placesOf(std::size_t column)
{
    std::array<std::uint16_t, 32> places{};
    for (std::size_t i = 0; i < 12; ++i) places.at(2 * i) = static_cast<std::uint16_t>(i / 3 * 16 + column * 3 + i % 3);
    return places;
}
constexpr std::array<std::array<std::uint16_t, 32>, 5> columnPlaces = {placesOf(0), placesOf(1), placesOf(2),
                                                                       placesOf(3), placesOf(4)};
constexpr __mmask32 twelve = 0x555555;

/// Those samples of one column, weighted.
VITRINE_AVX512 [[gnu::always_inline]] inline __m512 column(__m512i a, __m512i b, __m512i places, __m512 weight)
{
    return product(_mm512_cvtepi32_ps(_mm512_maskz_permutex2var_epi16(twelve, a, places, b)), weight);
}

VITRINE_AVX512 void filterShortSpans(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses,
                                     float* slots)
{
    const __m512i places0 = loaded(columnPlaces[0].data());
    const __m512i places1 = loaded(columnPlaces[1].data());
    const __m512i places2 = loaded(columnPlaces[2].data());
    const __m512i places3 = loaded(columnPlaces[3].data());
    const __m512i places4 = loaded(columnPlaces[4].data());
    for (std::size_t lens = lenses.first; lens < lenses.last; ++lens) {
        const LensPlan::ShortSpan& span = plan.shortSpans[lens];
        const __m512 weight0 = _mm512_set1_ps(span.weights[0]);
        const __m512 weight1 = _mm512_set1_ps(span.weights[1]);
        const __m512 weight2 = _mm512_set1_ps(span.weights[2]);
        const __m512 weight3 = _mm512_set1_ps(span.weights[3]);
        const __m512 weight4 = _mm512_set1_ps(span.weights[4]);
        float* out = slots + lens * plan.views * 3;
        for (std::size_t slot = 0; slot < plan.views; slot += 4, out += 12) {
            const std::uint16_t* const* row = rows + slot;
            for (std::size_t i = 0; i < 4; ++i) __builtin_prefetch(row[i] + span.sample + ahead);
            const __m512i a = fifteen(row[0] + span.sample, row[1] + span.sample);
            const __m512i b = fifteen(row[2] + span.sample, row[3] + span.sample);
            __m512 even = _mm512_add_ps(column(a, b, places0, weight0), column(a, b, places2, weight2));
            even = _mm512_add_ps(even, column(a, b, places4, weight4));
            const __m512 odd = _mm512_add_ps(column(a, b, places1, weight1), column(a, b, places3, weight3));
            // Four floats too many, which what comes next writes again.
            _mm512_storeu_ps(out, _mm512_add_ps(even, odd));
        }
    }
}

void filterLenses(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses, float* slots)
{
    if (plan.shortSpans.empty()) return avx2Kernels.filterLenses(plan, rows, lenses, slots);
    filterShortSpans(plan, rows, lenses, slots);
}

/// `taps` is that of every column; 0 stands for one of weight 1.
template <std::size_t taps>
VITRINE_AVX512 void mixGroups(const LensPlan& plan, const float* slots, std::size_t first, std::size_t last,
                              std::uint16_t* out)
{
    constexpr std::size_t size = LensPlan::groupSize;
    constexpr std::size_t all = std::max<std::size_t>(taps, 1);
    const std::uint8_t* place = plan.places.data() + first * all * size;
    const float* weight = plan.placeWeights.data() + first * all * size;
    const __m512 half = _mm512_set1_ps(0.5F);
    for (std::size_t group = first; group < last; ++group, out += size) {
        const float* window = slots + plan.windowStart[group];
        const __m512 a = _mm512_loadu_ps(window);
        const __m512 b = _mm512_loadu_ps(window + 16);
        __m512 sum = _mm512_setzero_ps();
        for (std::size_t tap = 0; tap < all; ++tap, place += size, weight += size) {
            const __m512i places = _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(place)));
            __m512 part = _mm512_permutex2var_ps(a, places, b);
            if constexpr (taps > 0) part = product(part, _mm512_loadu_ps(weight));
            sum = tap == 0 ? part : _mm512_add_ps(sum, part);
        }
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                            _mm512_cvtepi32_epi16(_mm512_cvttps_epi32(_mm512_add_ps(sum, half))));
    }
}

void mixColumns(const LensPlan& plan, const float* slots, std::size_t x0, std::size_t x1, std::uint16_t* out)
{
    if (plan.windowStart.empty() || plan.taps > 4) return avx2Kernels.mixColumns(plan, slots, x0, x1, out);
    const std::size_t first = x0 * 3 / LensPlan::groupSize;
    const std::size_t last = (x1 * 3 + LensPlan::groupSize - 1) / LensPlan::groupSize;
    out -= x0 * 3 % LensPlan::groupSize;
    switch (plan.single ? 0 : plan.taps) {
    case 0: return mixGroups<0>(plan, slots, first, last, out);
    case 1: return mixGroups<1>(plan, slots, first, last, out);
    case 2: return mixGroups<2>(plan, slots, first, last, out);
    case 3: return mixGroups<3>(plan, slots, first, last, out);
    default: return mixGroups<4>(plan, slots, first, last, out);
    }
}

/// `codes8` in three tables that fit into registers. The darkest values have a code each. Beyond them codes are so far
/// apart that of 8, then of 32 values in a row only the last few have another code, the next one: such a block has the
/// code of its first value, and the greatest of the low bits (in steps of the samples' own 16 bits) that still has it.
struct BlockCodes {
    static constexpr std::size_t darkEnd = 256;  ///< Of 8192.
    static constexpr std::size_t shadeEnd = 2048;
    alignas(64) std::array<std::uint8_t, 256> dark{};
    alignas(64) std::array<std::uint8_t, 256> shadeCode{}, shadeLast{};  ///< Blocks of 8.
    alignas(64) std::array<std::uint8_t, 256> lightCode{}, lightLast{};  ///< Blocks of 32.
    bool possible = true;

    BlockCodes()
    {
        const Codes8& codes = codes8();
        std::copy_n(codes.begin(), dark.size(), dark.begin());
        for (std::size_t i = darkEnd / 8; i < 256; ++i) block(i * 8, 8, shadeCode.at(i), shadeLast.at(i));
        for (std::size_t i = shadeEnd / 32; i < 256; ++i) block(i * 32, 32, lightCode.at(i), lightLast.at(i));
    }
    void block(std::size_t from, std::size_t size, std::uint8_t& code, std::uint8_t& last)
    {
        const std::uint8_t* codes = codes8().data() + from;
        std::size_t same = 1;
        while (same < size && codes[same] == codes[0]) ++same;
        code = codes[0];
        last = static_cast<std::uint8_t>(same * (1U << dropped) - 1);
        for (std::size_t i = same; i < size; ++i) possible = possible && codes[i] == codes[0] + 1;
    }
};
const BlockCodes& blockCodes()
{
    static const BlockCodes codes;
    return codes;
}

/// 256 bytes in registers.
struct Table {
    __m512i first, second, third, fourth;
};

VITRINE_AVX512 [[gnu::always_inline]] inline Table tableOf(const std::array<std::uint8_t, 256>& bytes)
{
    return {loaded(bytes.data()), loaded(bytes.data() + 64), loaded(bytes.data() + 128), loaded(bytes.data() + 192)};
}

VITRINE_AVX512 [[gnu::always_inline]] inline __m512i lookUp(const Table& table, __m512i index)
{
    return _mm512_mask_blend_epi8(_mm512_movepi8_mask(index),
                                  _mm512_permutex2var_epi8(table.first, index, table.second),
                                  _mm512_permutex2var_epi8(table.third, index, table.fourth));
}

constexpr std::array<std::uint8_t, 64> everySecond(std::size_t from)
{
    std::array<std::uint8_t, 64> places{};
    for (std::size_t i = 0; i < 64; ++i) places.at(i) = static_cast<std::uint8_t>(2 * i + from);
    return places;
}
constexpr std::array<std::uint8_t, 64> evenPlaces = everySecond(0);
constexpr std::array<std::uint8_t, 64> oddPlaces = everySecond(1);

/// What codes are found in and by.
struct Registers {
    Table dark, shadeCode, shadeLast, lightCode, lightLast;
    __m512i even, odd;
};

template <int left> VITRINE_AVX512 [[gnu::always_inline]] inline __m512i upperBytes(__m512i a, __m512i b, __m512i odd)
{
    return _mm512_permutex2var_epi8(_mm512_slli_epi16(a, left), odd, _mm512_slli_epi16(b, left));
}

/// `codes8` of twice 32 samples.
VITRINE_AVX512 [[gnu::always_inline]] inline __m512i codesOf(__m512i a, __m512i b, const Registers& r)
{
    const __m512i one = _mm512_set1_epi8(1);
    const __m512i lowSix = _mm512_set1_epi8(0x3F);
    const __m512i low = _mm512_permutex2var_epi8(a, r.even, b);
    const __m512i high = _mm512_permutex2var_epi8(a, r.odd, b);
    const __m512i dark = lookUp(r.dark, upperBytes<8 - dropped>(a, b, r.odd));
    const __m512i shadeAt = upperBytes<8 - dropped - 3>(a, b, r.odd);
    __m512i shade = lookUp(r.shadeCode, shadeAt);
    const __mmask64 shadeNext = _mm512_cmpgt_epu8_mask(_mm512_and_si512(low, lowSix), lookUp(r.shadeLast, shadeAt));
    shade = _mm512_mask_add_epi8(shade, shadeNext, shade, one);
    __m512i light = lookUp(r.lightCode, high);
    const __mmask64 lightNext = _mm512_cmpgt_epu8_mask(low, lookUp(r.lightLast, high));
    light = _mm512_mask_add_epi8(light, lightNext, light, one);
    const __mmask64 isShade = _mm512_cmple_epu8_mask(high, lowSix);
    const __mmask64 isDark = _mm512_cmplt_epu8_mask(high, _mm512_set1_epi8(8));
    return _mm512_mask_mov_epi8(_mm512_mask_mov_epi8(light, isShade, shade), isDark, dark);
}

template <bool blends>
VITRINE_AVX512 [[gnu::always_inline]] inline __m512i mixed(const std::uint16_t* a, const std::uint16_t* b, __m512i part)
{
    const __m512i from = loaded(a);
    if constexpr (!blends) return from;
    const __m512i to = loaded(b);
    const __m512i up = _mm512_mulhi_epu16(_mm512_subs_epu16(to, from), part);
    const __m512i down = _mm512_mulhi_epu16(_mm512_subs_epu16(from, to), part);
    return _mm512_sub_epi16(_mm512_add_epi16(from, up), down);
}

template <bool blends>
VITRINE_AVX512 void encodeBlocks(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count,
                                 std::uint8_t* out)
{
    const BlockCodes& codes = blockCodes();
    const Registers r{tableOf(codes.dark),      tableOf(codes.shadeCode), tableOf(codes.shadeLast),
                      tableOf(codes.lightCode), tableOf(codes.lightLast), loaded(evenPlaces.data()),
                      loaded(oddPlaces.data())};
    const __m512i parts = _mm512_set1_epi16(static_cast<short>(part));
    // Whole lines of memory, from the first one on that begins inside; what is left at both ends is written twice.
    const std::size_t aligned = (64 - reinterpret_cast<std::uintptr_t>(out) % 64) % 64;
    for (std::size_t i = 0; i < count;) {
        const std::size_t at = std::min(i, count - 64);
        _mm512_storeu_si512(
            out + at, codesOf(mixed<blends>(a + at, b + at, parts), mixed<blends>(a + at + 32, b + at + 32, parts), r));
        i = i == 0 && aligned > 0 ? aligned : i + 64;
    }
}

void encode8(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count, std::uint8_t* out)
{
    if (count < 64 || !blockCodes().possible) return avx2Kernels.encode8(a, b, part, count, out);
    if (part == 0 || a == b)
        encodeBlocks<false>(a, a, 0, count, out);
    else
        encodeBlocks<true>(a, b, part, count, out);
}

}  // namespace

const Kernels avx512Kernels = {filterLenses, mixColumns, encode8, avx2Kernels.encode16};

}  // namespace vitrine::printing::kernels

#endif
