#pragma once

#include "render/image/image_limits.h"
#include "render/image/stored_picture.h"

#include <functional>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Unpacks a picture with the one decoder for `format`: libpng for PNG, else OpenImageIO.
/// Throws Failure naming `name`.
[[nodiscard]] StoredPicture decodePicture(std::string_view bytes, ImageFormat format, const std::string& name,
                                          const ImageLimits&, const std::function<bool()>& canceled = {});

/// The format of a file's bytes. Throws Failure naming `name` when it is none that is read.
[[nodiscard]] ImageFormat formatOf(std::string_view bytes, const std::string& name);

}  // namespace vitrine::render
