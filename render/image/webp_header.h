#pragma once

#include "render/image/image_limits.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Header data of a WebP file (RFC 9649).
struct WebpHeader {
    DeclaredImage size{};
    bool animated = false;
    int orientation = 1;    ///< From its Exif block.
    std::string profile{};  ///< ICC profile; empty: none.
};

/// Reads the chunks of the file. Sizes that it does not find are 0.
[[nodiscard]] WebpHeader webpHeader(std::string_view bytes);

}  // namespace vitrine::render
