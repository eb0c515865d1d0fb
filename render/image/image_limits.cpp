#include "render/image/image_limits.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace vitrine::render {

std::string_view toString(ImageFormat format)
{
    constexpr std::array<std::string_view, 8> names = {"PNG", "JPEG", "TIFF", "OpenEXR", "HDR", "WebP", "BMP", "GIF"};
    return names.at(static_cast<std::size_t>(format));
}

std::optional<ImageFormat> sniffImage(std::string_view bytes)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return ImageFormat::png;
    if (bytes.starts_with("\xff\xd8\xff"sv)) return ImageFormat::jpeg;
    if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return ImageFormat::tiff;
    if (bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv)) return ImageFormat::tiff;  // BigTIFF.
    if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return ImageFormat::exr;
    if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return ImageFormat::hdr;
    if (bytes.size() >= 12 && bytes.starts_with("RIFF"sv) && bytes.substr(8, 4) == "WEBP"sv) return ImageFormat::webp;
    if (bytes.starts_with("GIF87a"sv) || bytes.starts_with("GIF89a"sv)) return ImageFormat::gif;
    if (bytes.starts_with("BM"sv)) return ImageFormat::bmp;
    return std::nullopt;
}

namespace {

std::string loweredExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace

bool extensionAllows(const std::filesystem::path& path, ImageFormat format)
{
    const std::string extension = loweredExtension(path);
    if (extension.empty()) return true;
    switch (format) {
    case ImageFormat::png: return extension == ".png";
    case ImageFormat::jpeg: return extension == ".jpg" || extension == ".jpeg";
    case ImageFormat::tiff: return extension == ".tif" || extension == ".tiff";
    case ImageFormat::exr: return extension == ".exr";
    case ImageFormat::hdr: return extension == ".hdr" || extension == ".rgbe";
    case ImageFormat::webp: return extension == ".webp";
    case ImageFormat::bmp: return extension == ".bmp";
    case ImageFormat::gif: return extension == ".gif";
    }
    return false;
}

bool hasPictureExtension(const std::filesystem::path& path)
{
    if (path.extension().empty()) return false;
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::jpeg, ImageFormat::tiff, ImageFormat::exr,
                                     ImageFormat::hdr, ImageFormat::webp, ImageFormat::bmp, ImageFormat::gif})
        if (extensionAllows(path, format)) return true;
    return false;
}

std::string whyTooLarge(const DeclaredImage& image, ImageFormat format, std::uint64_t fileBytes,
                        const ImageLimits& limits)
{
    const auto more = [](std::uint64_t n, const std::string& what, std::uint64_t most) {
        return "it has " + std::to_string(n) + ' ' + what + ", more than the " + std::to_string(most) + " allowed";
    };
    if (image.width < 1 || image.height < 1) return "it has no pixels";
    if (image.width > limits.side) return more(image.width, "pixels in a row", limits.side);
    if (image.height > limits.side) return more(image.height, "rows", limits.side);
    const std::uint64_t mostChannels = format == ImageFormat::exr ? limits.exrChannels : limits.channels;
    if (image.channels < 1) return "it has no channels";
    if (image.channels > mostChannels) return more(image.channels, "channels", mostChannels);
    // With the default limits at most 2^15 * 2^15 * 16 * 8, which does not overflow; larger limits are checked here.
    std::uint64_t pixels = 0;
    std::uint64_t bytes = 0;
    if (__builtin_mul_overflow(image.width, image.height, &pixels) || pixels > limits.pixels) {
        return more(pixels, "pixels", limits.pixels);
    }
    if (__builtin_mul_overflow(pixels, image.channels * image.bytesPerSample, &bytes) || bytes > limits.decodedBytes) {
        return more(bytes, "bytes once unpacked", limits.decodedBytes);
    }
    if (format == ImageFormat::webp || format == ImageFormat::bmp || format == ImageFormat::gif) return {};
    const std::uint64_t mostRatio = format == ImageFormat::png ? 1200 : 4000;
    // A few rows of slack, so that tiny pictures with large headers are accepted.
    if (bytes / mostRatio > fileBytes + 64) {
        return "it claims to unpack to " + std::to_string(bytes / std::max<std::uint64_t>(fileBytes, 1)) +
               " times its size, more than the format can pack";
    }
    return {};
}

}  // namespace vitrine::render
