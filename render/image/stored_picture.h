#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// Color space of a picture's samples, as the file describes it. Without a description, codes of 8 and 16 bits are
/// sRGB-encoded, and floats are linear Rec. 709.
struct PictureColor {
    std::string profile{};  ///< ICC profile; empty when there is none.
    /// x and y of red, green, blue and white; all 0 if the file does not give them.
    std::array<double, 8> chromaticities{};
    double gamma = 0;  ///< Exponent from code to light; 0 if the file does not give it.

    [[nodiscard]] bool isSaid() const { return !profile.empty() || gamma > 0 || chromaticities[0] > 0; }
};

/// A decoded picture with the file's own numbers, before its color space is applied: interleaved channels, row 0 at the
/// top, no padding.
struct StoredPicture {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
    std::vector<std::string> channelNames;  ///< One per channel if the format names them, else empty.
    std::vector<std::string> warnings;      ///< Full sentences without the file's name.
    int orientation = 1;                    ///< Orientation of the rows: 1 to 8, see `orient`.
    PictureColor color{};

    [[nodiscard]] std::size_t rowSamples() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    }
    [[nodiscard]] std::size_t sampleCount() const { return rowSamples() * static_cast<std::size_t>(height); }
};

}  // namespace vitrine::render
