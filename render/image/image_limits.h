#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// What a picture file may be at most. Checked against the file's header, before anything is allocated.
struct ImageLimits {
    std::uint64_t fileBytes = 512ULL << 20U;
    std::uint64_t side = 32768;          ///< Of width and of height, in pixels.
    std::uint64_t pixels = 268'435'456;  ///< 2^28.
    std::uint64_t decodedBytes = 2ULL << 30U;
    std::uint64_t channels = 4;
    std::uint64_t exrChannels = 16;  ///< Of those that are read; a file may have more.
};

/// The file formats that are read. Everything else is refused: the decoders of Debian's OpenImageIO for
/// other formats (BMP, GIF, DPX, PSD, ...) are its own and known to be unsafe. WebP is libwebp's, BMP and GIF are
/// FFmpeg's.
enum class ImageFormat : std::uint8_t { png, jpeg, tiff, exr, hdr, webp, bmp, gif };

/// The formats for people.
inline constexpr std::string_view readFormats = "PNG, JPEG, TIFF, OpenEXR, HDR, WebP, BMP or GIF";

[[nodiscard]] std::string_view toString(ImageFormat);  ///< "PNG", ...

/// The format that the first bytes of a file show.
[[nodiscard]] std::optional<ImageFormat> sniffImage(std::string_view bytes);

/// Whether a file of this name may hold `format` (".jpg" and ".jpeg", any case). A name without extension may.
[[nodiscard]] bool extensionAllows(const std::filesystem::path&, ImageFormat);

/// Whether a file of this name may hold one of the formats; a name without extension does not.
[[nodiscard]] bool hasPictureExtension(const std::filesystem::path&);

/// What a picture's header declares.
struct DeclaredImage {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t channels = 0;
    std::uint64_t bytesPerSample = 0;  ///< Once decoded.
};

/// Why the declared picture is refused, as a half sentence ("it is 100000 pixels wide, more than 32768");
/// empty when it may be decoded. Beyond `limits` it refuses pictures that claim to unpack to more than 1200
/// (PNG: deflate's bound is 1032:1) or 4000 times the file's size. WebP, BMP and GIF have no such bound.
[[nodiscard]] std::string whyTooLarge(const DeclaredImage&, ImageFormat, std::uint64_t fileBytes, const ImageLimits&);

}  // namespace vitrine::render
