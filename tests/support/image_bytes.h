#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::test {

// Picture files made by hand, so that the tests can lie in their headers.

[[nodiscard]] std::string bigEndian32(std::uint32_t);
[[nodiscard]] std::string littleEndian32(std::uint32_t);

/// A chunk of a PNG file with its checksum.
[[nodiscard]] std::string pngChunk(const std::string& type, const std::string& data);
/// A PNG whose header claims this size and whose pixels are `idat`, taken as they are.
[[nodiscard]] std::string pngClaiming(std::uint32_t width, std::uint32_t height, int bits, int colorType,
                                      const std::string& idat);

/// A Radiance HDR file that claims this size; the pixels are `rgbe`, not run-length encoded.
[[nodiscard]] std::string hdrClaiming(std::uint32_t width, std::uint32_t height, const std::string& rgbe);

/// A little-endian TIFF that claims this size, with 8-bit samples in one strip.
[[nodiscard]] std::string tiffClaiming(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                                       const std::string& pixels, std::uint32_t orientation = 1);

/// A tiled, uncompressed OpenEXR with one float channel "Y"; pixel (x, y) is x + 100 y.
[[nodiscard]] std::string tiledExr(std::uint32_t width, std::uint32_t height, std::uint32_t tile);

/// A window of an OpenEXR file: the first and the last column and row.
struct ExrWindow {
    int left, top, right, bottom;
};
/// An uncompressed OpenEXR of scanlines with float channels, whose names come in alphabetical order. Channel c of pixel
/// (x, y), in the coordinates of the windows, is x + 10 y + 100 c. `more` are further attributes.
[[nodiscard]] std::string exrBytes(const std::vector<std::string>& channels, const ExrWindow& data,
                                   const ExrWindow& display, const std::string& more = {});
[[nodiscard]] std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value);

/// The smallest ICC profile (version 2) of a display: three colorants in XYZ of D50, and for all of them one gamma or,
/// where it is given, one curve of values at equal steps.
[[nodiscard]] std::string iccProfile(const std::vector<std::vector<double>>& colorants, double gamma,
                                     const std::vector<double>& curve = {});
/// Adobe RGB (1998): colorants and gamma as its specification publishes them.
[[nodiscard]] std::string adobeRgb();

/// An Exif block that says how the picture is to be shown, 1 to 8.
[[nodiscard]] std::string exifBlock(int orientation);

[[nodiscard]] std::string unbase64(std::string_view text);

/// A JPEG of 16 x 8 pixels, all of them (200, 100, 50), made with libjpeg at quality 100.
[[nodiscard]] std::string jpegBytes();

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace vitrine::test
