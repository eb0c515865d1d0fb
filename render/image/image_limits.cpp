#include "render/image/image_limits.h"

#include <algorithm>

namespace vitrine::render {

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
