#include "exhibits/printing/dither.h"

namespace vitrine::lenticular {
namespace {

// The pattern's constants as parts of 2^32, and the rest of 52.9829189 beside 52 as a part of 2^16: whole numbers that
// wrap around are the fractions, exactly and everywhere the same.
constexpr std::uint32_t alongX = 288237660;  // 0.06711056
constexpr std::uint32_t alongY = 25070368;   // 0.00583715
constexpr std::uint32_t rest = 64417;        // 0.9829189

/// 0 to 2^16 - 1.
std::uint32_t pattern(std::uint32_t along)
{
    return (52 * along + (along >> 16U) * rest) >> 16U;
}

/// Channels are far apart in the pattern, so that their grains do not add up to gray ones.
std::uint32_t placeOf(std::int64_t x, std::int64_t y, int channel)
{
    return alongX * static_cast<std::uint32_t>(x + 47 * channel) + alongY * static_cast<std::uint32_t>(y + 17 * channel);
}

}  // namespace

double ditherAt(std::int64_t x, std::int64_t y, int channel)
{
    return pattern(placeOf(x, y, channel)) / 65536.0;
}

void ditherRows(const Region& region, const std::uint16_t* from, std::uint8_t* to)
{
    const auto width = static_cast<std::size_t>(region.x1 - region.x0);
    for (std::int64_t y = region.y0; y < region.y1; ++y, from += width * 3, to += width * 3) {
        for (int c = 0; c < 3; ++c) {
            std::uint32_t place = placeOf(region.x0, y, c);
            for (auto at = static_cast<std::size_t>(c); at < width * 3; at += 3, place += alongX) {
                to[at] = static_cast<std::uint8_t>((from[at] + ((257 * pattern(place)) >> 16U)) / 257);
            }
        }
    }
}

}  // namespace vitrine::lenticular
