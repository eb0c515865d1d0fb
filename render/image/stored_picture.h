#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// A picture as a file holds it, before or after the meaning of its numbers is considered: interleaved
/// channels, row 0 at the top, no padding.
struct StoredPicture {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
    std::vector<std::string> channelNames;  ///< One per channel when the format names them, else empty.
    std::vector<std::string> warnings;      ///< Full sentences without the file's name.

    [[nodiscard]] std::size_t rowSamples() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    }
    [[nodiscard]] std::size_t sampleCount() const { return rowSamples() * static_cast<std::size_t>(height); }
};

}  // namespace vitrine::render
