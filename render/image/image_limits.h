#pragma once

#include "render/image/picture_formats.h"

#include <cstdint>
#include <string>

namespace vitrine::render {

/// Upper limits for a picture file. Checked against the file's header, before anything is allocated.
struct ImageLimits {
    std::uint64_t fileBytes = 512ULL << 20U;
    std::uint64_t side = 32768;          ///< For width and for height, in pixels.
    std::uint64_t pixels = 268'435'456;  ///< 2^28.
    std::uint64_t decodedBytes = 2ULL << 30U;
    std::uint64_t channels = 4;
    std::uint64_t exrChannels = 32;  ///< Number of channels that are read; a file may have more.
};

/// Size of a picture, as its header declares it.
struct DeclaredImage {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t channels = 0;
    std::uint64_t bytesPerSample = 0;  ///< Size when decoded.
};

/// Returns a half sentence that says why the declared picture is refused ("it is 100000 pixels wide, more than 32768");
/// empty if it may be decoded. Besides `limits`, it refuses pictures that claim to be more than 1200 (PNG: deflate's
/// bound is 1032:1) or 4000 times as large as the file. WebP, BMP and GIF have no such bound.
[[nodiscard]] std::string whyTooLarge(const DeclaredImage&, ImageFormat, std::uint64_t fileBytes, const ImageLimits&);

}  // namespace vitrine::render
