#pragma once

#include "render/image/sound.h"

#include <string>

namespace vitrine::render::ffmpeg {

/// Decodes a WAV or FLAC file. Opens only this file. Throws Problem.
[[nodiscard]] Sound soundOf(const std::string& path);

}  // namespace vitrine::render::ffmpeg
