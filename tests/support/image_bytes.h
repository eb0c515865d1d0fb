#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::test {

// Picture files made byte by byte, so that tests can write false headers.

[[nodiscard]] std::string bigEndian32(std::uint32_t);
[[nodiscard]] std::string littleEndian32(std::uint32_t);

/// Returns a PNG chunk with its checksum.
[[nodiscard]] std::string pngChunk(const std::string& type, const std::string& data);
/// Returns a PNG whose header claims this size. `idat` is written unchanged.
[[nodiscard]] std::string pngClaiming(std::uint32_t width, std::uint32_t height, int bits, int colorType,
                                      const std::string& idat);

/// Returns a Radiance HDR file that claims this size, with the pixels `rgbe`, not run-length encoded.
[[nodiscard]] std::string hdrClaiming(std::uint32_t width, std::uint32_t height, const std::string& rgbe);

/// Returns a little-endian TIFF that claims this size, with 8-bit samples in one strip.
[[nodiscard]] std::string tiffClaiming(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                                       const std::string& pixels, std::uint32_t orientation = 1);

/// Returns a tiled, uncompressed OpenEXR file with one float channel "Y"; pixel (x, y) is x + 100 y.
[[nodiscard]] std::string tiledExr(std::uint32_t width, std::uint32_t height, std::uint32_t tile);

/// Window of an OpenEXR file: first and last column and row.
struct ExrWindow {
    int left, top, right, bottom;
};
/// Returns an uncompressed OpenEXR file of scanlines with float channels. Channel names must be in alphabetical order.
/// Channel c of pixel (x, y), in the coordinates of the windows, is x + 10 y + 100 c. `more` are further attributes.
[[nodiscard]] std::string exrBytes(const std::vector<std::string>& channels, const ExrWindow& data,
                                   const ExrWindow& display, const std::string& more = {});
[[nodiscard]] std::string exrAttribute(const std::string& name, const std::string& type, const std::string& value);

/// Returns a minimal ICC profile (version 2) of a display: three colorants in XYZ of D50 with a common gamma or, if
/// `curve` is given, a common curve of values at equal steps.
[[nodiscard]] std::string iccProfile(const std::vector<std::vector<double>>& colorants, double gamma,
                                     const std::vector<double>& curve = {});
/// Returns Adobe RGB (1998) with the colorants and gamma of its specification.
[[nodiscard]] std::string adobeRgb();

/// Returns an Exif block with an orientation, 1 to 8.
[[nodiscard]] std::string exifBlock(int orientation);

[[nodiscard]] std::string unbase64(std::string_view text);

/// Returns a JPEG of 16 x 8 pixels, all of them (200, 100, 50), made with libjpeg at quality 100.
[[nodiscard]] std::string jpegBytes();

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace vitrine::test
