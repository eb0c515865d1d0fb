#pragma once

#include "render/image/image_limits.h"

#include <string_view>

namespace vitrine::render {

/// Header data of a BMP or GIF file. Sizes that are not found are 0.
struct StillHeader {
    DeclaredImage size{};
    int pictures = 1;   ///< More than one for an animation.
    bool whole = true;  ///< The blocks of a GIF end within the file.
};

/// Reads the file header and the information header, of OS/2 or Windows.
[[nodiscard]] StillHeader bmpHeader(std::string_view bytes);

/// Returns the header data of a GIF file (GIF89a), read from its blocks without decoding pictures.
[[nodiscard]] StillHeader gifHeader(std::string_view bytes);

}  // namespace vitrine::render
