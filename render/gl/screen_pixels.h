#pragma once

#include <cstdint>
#include <vector>

namespace vitrine::render::gl {

/// Picture as a screen shows it: sRGB, 8 bits each of red, green, blue and alpha (255). Row 0 is the top; rows have no
/// padding.
struct ScreenPixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

}  // namespace vitrine::render::gl
