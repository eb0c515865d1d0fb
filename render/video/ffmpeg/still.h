#pragma once

#include "render/image/stored_picture.h"

#include <string_view>

namespace vitrine::render::ffmpeg {

/// Decodes the only picture of a BMP or GIF. Throws Problem.
[[nodiscard]] StoredPicture stillPicture(std::string_view bytes, bool isGif);

}  // namespace vitrine::render::ffmpeg
