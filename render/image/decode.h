#pragma once

#include "render/image/image_limits.h"
#include "render/image/oiio_codec.h"
#include "render/image/stored_picture.h"

#include <string>
#include <string_view>

namespace vitrine::render {

/// Unpacks a picture with the one decoder for `format`: libpng for PNG, FFmpeg for BMP and GIF, else
/// OpenImageIO. Rows stay as stored:
/// `orient` turns them as the file's `orientation` says. Throws Failure naming `name`.
[[nodiscard]] StoredPicture decodePicture(std::string_view bytes, ImageFormat format, const std::string& name,
                                          const DecodeRequest&);

/// The format of a file's bytes. Throws Failure naming `name` when it is none that is read, or when the header claims
/// what must not be handed to a decoder (`whyExrRefused`).
[[nodiscard]] ImageFormat formatOf(std::string_view bytes, const std::string& name);

}  // namespace vitrine::render
