#pragma once

#include <cstdint>
#include <vector>

namespace vitrine::render::gl {

/// A picture as a screen shows it: sRGB, 8 bits each of red, green, blue and 255, row 0 at the top, without gaps.
struct ScreenPixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace vitrine::render::gl
