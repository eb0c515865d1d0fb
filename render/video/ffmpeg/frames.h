#pragma once

#include "render/image/video_codec.h"

#include <cstddef>
#include <memory>
#include <string>

namespace vitrine::render::ffmpeg {

/// Opens a video to read its frames. Throws Problem.
[[nodiscard]] std::unique_ptr<VideoReader> readerOf(const std::string& path);

/// Counts the frames of a video without decoding them. Throws Problem.
[[nodiscard]] std::size_t framesOf(const std::string& path);

}  // namespace vitrine::render::ffmpeg
