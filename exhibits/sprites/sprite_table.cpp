#include "exhibits/sprites/sprite_table.h"

#include <cstdint>

namespace vitrine {
namespace {

constexpr std::int64_t longestSide = 16384;
constexpr std::int64_t mostPixels = std::int64_t{1} << 26U;  // Frames are kept as floats: 36 bytes a pixel.

}  // namespace

const SpriteTable& spriteTable()
{
    static const SpriteTable table;
    return table;
}

std::string whyNoSheet(const ParameterValues& values)
{
    const SpriteTable& t = spriteTable();
    const std::int64_t wide = std::int64_t{values[t.width]} * values[t.frames];
    const std::int64_t high = std::int64_t{values[t.height]} * values[t.directions];
    if (wide > longestSide || high > longestSide)
        return "The sheet would be more than 16384 pixels wide or high; ask for fewer or smaller frames.";
    if (wide * high > mostPixels)
        return "The sheet would have more than 67 million pixels; ask for fewer or smaller frames.";
    return {};
}

}  // namespace vitrine
