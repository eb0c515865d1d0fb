#include "render/image/png_filter.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace vitrine::render {
namespace {

using Bytes = std::uint8_t __attribute__((vector_size(16)));
using Words = std::uint16_t __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Bytes load(const std::uint8_t* at)
{
    Bytes bytes;
    std::memcpy(&bytes, at, sizeof bytes);
    return bytes;
}

/// As numbers from -128 to 127.
unsigned absolute(std::uint8_t difference)
{
    return std::min<unsigned>(difference, 256U - difference);
}

/// Absolute values of 16 differences, added up in pairs.
[[gnu::always_inline]] inline Words absolute(Bytes difference)
{
    const Bytes negative = Bytes{} - difference;
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

/// From byte `pixel` on.
Sums sumsOf(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t pixel)
{
    constexpr std::size_t together = 16 * 200;  // 200 pairs of up to 256 fit into 16 bits.
    Sums sums;
    std::size_t i = pixel;
    while (i + 16 <= bytes) {
        Words none{};
        Words left{};
        Words up{};
        const std::size_t end = std::min(i + together, bytes - 15);
        for (; i < end; i += 16) {
            const Bytes here = load(row + i);
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
    for (; i + 16 <= bytes; i += 16) {
        const Bytes difference = load(from + i) - load(what + i);
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
