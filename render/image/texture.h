#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::render {

/// An 8-bit or float picture for sampling. Must not change once shared: the renderer uploads it once and
/// finds it by address.
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    int channels = 4;    ///< 1, 3 or 4.
    bool sRgb = false;   ///< 8-bit values are sRGB-encoded color.
    bool repeat = true;  ///< Otherwise clamp to edge.
    bool mipmaps = true;
    bool magnifyNearest = false;      ///< Nearest filtering if texels are larger than pixels. Otherwise linear.
    bool minifyNearest = false;       ///< Nearest filtering if texels are smaller than pixels. Otherwise linear.
    bool nearestLevel = false;        ///< Reads only the nearest mip level. Otherwise interpolates between two.
    std::vector<std::uint8_t> bytes;  ///< Row 0 is texture coordinate v = 0. Empty when `floats` is used.
    std::vector<float> floats;
    int layers = 1;  ///< More than one: a 2-D array, layers stored one after another.
};

}  // namespace vitrine::render
