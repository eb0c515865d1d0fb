#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// What a file says about the meaning of its color samples. Where it says nothing, codes of 8 and 16 bits are
/// sRGB-encoded, and floats are linear Rec. 709.
struct PictureColor {
    std::string profile{};  ///< ICC profile; empty when there is none.
    /// x and y of red, green, blue and white; all 0 where the file does not say.
    std::array<double, 8> chromaticities{};
    double gamma = 0;  ///< Exponent from code to light; 0 where the file does not say.

    [[nodiscard]] bool isSaid() const { return !profile.empty() || gamma > 0 || chromaticities[0] > 0; }
};

/// A picture as a file holds it, before or after the meaning of its numbers is considered: interleaved
/// channels, row 0 at the top, no padding.
struct StoredPicture {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
    std::vector<std::string> channelNames;  ///< One per channel when the format names them, else empty.
    std::vector<std::string> warnings;      ///< Full sentences without the file's name.
    int orientation = 1;                    ///< How the rows are to be shown: 1 to 8, as `orient` takes it.
    PictureColor color{};

    [[nodiscard]] std::size_t rowSamples() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    }
    [[nodiscard]] std::size_t sampleCount() const { return rowSamples() * static_cast<std::size_t>(height); }
};

}  // namespace vitrine::render
