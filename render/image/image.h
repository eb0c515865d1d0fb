#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::render {

/// A picture in memory: 32-bit float, interleaved channels, row 0 at the TOP, no padding.
/// Color is linear Rec. 709 unless the function that returns it says otherwise; alpha is not premultiplied.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;                       ///< 1 to 4, or more for named EXR channels.
    std::vector<float> pixels;              ///< width * height * channels values.
    std::vector<std::string> channelNames;  ///< Empty, or one per channel ("R", "depth.Z", ...).

    Image() = default;
    Image(int w, int h, int c, float fill = 0.0F)
        : width(w), height(h), channels(c),
          pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill)
    {
    }

    [[nodiscard]] std::size_t index(int x, int y, int c = 0) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(c);
    }
    [[nodiscard]] float at(int x, int y, int c = 0) const { return pixels[index(x, y, c)]; }
    [[nodiscard]] float& at(int x, int y, int c = 0) { return pixels[index(x, y, c)]; }
    [[nodiscard]] bool empty() const { return pixels.empty(); }
};

}  // namespace vitrine::render
