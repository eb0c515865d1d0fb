#pragma once

#include "render/image/image_limits.h"
#include "render/image/oiio_codec.h"
#include "render/image/stored_picture.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Decodes a picture with the one decoder for `format`: libpng for PNG, FFmpeg for BMP and GIF, else OpenImageIO. Rows
/// stay in stored order; `orient` applies the file's `orientation`. Throws Failure naming `name`.
[[nodiscard]] StoredPicture decodePicture(std::string_view bytes, ImageFormat format, const std::string& name,
                                          const DecodeRequest&);

/// Detects the format of a file from its bytes. Throws Failure naming `name` for an unsupported format, or for a header
/// that is unsafe to pass to a decoder (`whyExrRefused`).
[[nodiscard]] ImageFormat formatOf(std::string_view bytes, const std::string& name);

}  // namespace vitrine::render
