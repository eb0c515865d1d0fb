#include "exhibits/lenticular/dither.h"

#include <array>
#include <cmath>

namespace vitrine::lenticular {
namespace {

double fraction(double x)
{
    return x - std::floor(x);
}

}  // namespace

double ditherAt(std::int64_t x, std::int64_t y, int channel)
{
    // Channels are far apart in the pattern, so that their grains do not add up to gray ones.
    const double along = 0.06711056 * static_cast<double>(x + 47 * channel) + 0.00583715 * static_cast<double>(y + 17 * channel);
    return fraction(52.9829189 * fraction(along));
}

void ditherRows(const Region& region, const std::uint16_t* from, std::uint8_t* to)
{
    for (std::int64_t y = region.y0; y < region.y1; ++y) {
        for (std::int64_t x = region.x0; x < region.x1; ++x) {
            for (int c = 0; c < 3; ++c, ++from, ++to) {
                const auto threshold = static_cast<unsigned>(257 * ditherAt(x, y, c));
                *to = static_cast<std::uint8_t>((*from + threshold) / 257);
            }
        }
    }
}

}  // namespace vitrine::lenticular
