#pragma once

#include "render/image/image_limits.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// What a WebP file (RFC 9649) says ahead of its pixels.
struct WebpHeader {
    DeclaredImage size{};
    bool animated = false;
    int orientation = 1;    ///< Of its Exif block.
    std::string profile{};  ///< ICC profile; empty when there is none.
};

/// Reads the chunks of the file. Sizes that it does not find are 0.
[[nodiscard]] WebpHeader webpHeader(std::string_view bytes);

}  // namespace vitrine::render
