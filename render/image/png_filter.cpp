#include "render/image/png_filter.h"

#include <algorithm>
#include <array>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>
#define VITRINE_AVX2 [[gnu::target("avx2")]]
#endif

namespace vitrine::render {
namespace {

using ByteVector = std::uint8_t __attribute__((vector_size(16)));
using Words = std::uint16_t __attribute__((vector_size(16)));

[[gnu::always_inline]] inline ByteVector load(const std::uint8_t* at)
{
    ByteVector bytes;
    std::memcpy(&bytes, at, sizeof bytes);
    return bytes;
}

/// Returns the absolute value of a difference, read as a number from -128 to 127.
unsigned absolute(std::uint8_t difference)
{
    return std::min<unsigned>(difference, 256U - difference);
}

/// Returns the absolute values of 16 differences, added in pairs.
[[gnu::always_inline]] inline Words absolute(ByteVector difference)
{
    const ByteVector negative = ByteVector{} - difference;
    const auto least = reinterpret_cast<Words>(difference < negative ? difference : negative);
    return (least & 0xFF) + (least >> 8);
}

unsigned long long total(const Words& sums)
{
    unsigned long long sum = 0;
    for (int i = 0; i < 8; ++i) sum += sums[i];
    return sum;
}

struct Sums {
    unsigned long long none = 0, left = 0, above = 0;
};

#if defined(VITRINE_AVX2)
const bool avx2 = __builtin_cpu_supports("avx2") != 0;

VITRINE_AVX2 [[gnu::always_inline]] inline __m256i load32(const std::uint8_t* at)
{
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
}

/// Adds the absolute values of 32 differences to four sums.
VITRINE_AVX2 [[gnu::always_inline]] inline __m256i added(__m256i sums, __m256i differences)
{
    return _mm256_add_epi64(sums, _mm256_sad_epu8(_mm256_abs_epi8(differences), _mm256_setzero_si256()));
}

VITRINE_AVX2 unsigned long long total32(__m256i sums)
{
    const __m128i two = _mm_add_epi64(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
    return static_cast<unsigned long long>(_mm_extract_epi64(two, 0) + _mm_extract_epi64(two, 1));
}

/// Adds the sums of 32 bytes at a time from byte `from` on; returns the position after the last one.
VITRINE_AVX2 std::size_t addSums32(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes,
                                   std::size_t pixel, std::size_t from, Sums& sums)
{
    __m256i none = _mm256_setzero_si256();
    __m256i left = none;
    __m256i up = none;
    std::size_t i = from;
    for (; i + 32 <= bytes; i += 32) {
        const __m256i here = load32(row + i);
        none = added(none, here);
        left = added(left, _mm256_sub_epi8(here, load32(row + i - pixel)));
        up = added(up, _mm256_sub_epi8(here, load32(above + i)));
    }
    sums.none += total32(none);
    sums.left += total32(left);
    sums.above += total32(up);
    return i;
}

VITRINE_AVX2 std::size_t subtract32(const std::uint8_t* from, const std::uint8_t* what, std::size_t bytes,
                                    std::uint8_t* out)
{
    std::size_t i = 0;
    for (; i + 32 <= bytes; i += 32)
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + i), _mm256_sub_epi8(load32(from + i), load32(what + i)));
    return i;
}
#endif

/// Returns the sums from byte `pixel` on.
Sums sumsOf(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t pixel)
{
    constexpr std::size_t together = 16 * 200;  // 200 pairs of up to 256 fit into 16 bits.
    Sums sums;
    std::size_t i = pixel;
#if defined(VITRINE_AVX2)
    if (avx2) i = addSums32(row, above, bytes, pixel, i, sums);
#endif
    while (i + 16 <= bytes) {
        Words none{};
        Words left{};
        Words up{};
        const std::size_t end = std::min(i + together, bytes - 15);
        for (; i < end; i += 16) {
            const ByteVector here = load(row + i);
            none += absolute(here);
            left += absolute(here - load(row + i - pixel));
            up += absolute(here - load(above + i));
        }
        sums.none += total(none);
        sums.left += total(left);
        sums.above += total(up);
    }
    for (; i < bytes; ++i) {
        sums.none += absolute(row[i]);
        sums.left += absolute(static_cast<std::uint8_t>(row[i] - row[i - pixel]));
        sums.above += absolute(static_cast<std::uint8_t>(row[i] - above[i]));
    }
    return sums;
}

void subtract(const std::uint8_t* from, const std::uint8_t* what, std::size_t bytes, std::uint8_t* out)
{
    std::size_t i = 0;
#if defined(VITRINE_AVX2)
    if (avx2) i = subtract32(from, what, bytes, out);
#endif
    for (; i + 16 <= bytes; i += 16) {
        const ByteVector difference = load(from + i) - load(what + i);
        std::memcpy(out + i, &difference, sizeof difference);
    }
    for (; i < bytes; ++i) out[i] = static_cast<std::uint8_t>(from[i] - what[i]);
}

PngFilter chosen(const Sums& sums, PngFilter before)
{
    const std::array<unsigned long long, 3> of = {sums.none, sums.left, sums.above};
    const auto least = static_cast<std::size_t>(std::min_element(of.begin(), of.end()) - of.begin());
    const unsigned long long kept = of.at(static_cast<std::size_t>(before));
    return kept - kept / 16 <= of.at(least) ? before : static_cast<PngFilter>(least);
}

}  // namespace

void filterPngRow(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t pixel,
                  PngFilter& kind, std::uint8_t* out)
{
    if (std::memcmp(row, above, bytes) == 0) {
        *out = static_cast<std::uint8_t>(PngFilter::above);
        std::memset(out + 1, 0, bytes);
        return;
    }
    kind = chosen(sumsOf(row, above, bytes, std::min(pixel, bytes)), kind);
    *out++ = static_cast<std::uint8_t>(kind);
    switch (kind) {
    case PngFilter::none: std::memcpy(out, row, bytes); return;
    case PngFilter::left:
        std::memcpy(out, row, pixel);
        subtract(row + pixel, row, bytes - pixel, out + pixel);
        return;
    case PngFilter::above: subtract(row, above, bytes, out); return;
    }
}

}  // namespace vitrine::render
