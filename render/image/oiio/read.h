#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Implements OiioCodec::decode; may throw.
[[nodiscard]] std::string decodeWithOiio(std::string_view bytes, ImageFormat, const DecodeRequest&, StoredPicture& out);

/// Implements OiioCodec::readText; may throw.
[[nodiscard]] std::string readTextWithOiio(std::string_view bytes, ImageFormat, const std::string& key,
                                           std::string& out);

/// Implements OiioCodec::readProfile; may throw.
[[nodiscard]] std::string readProfileWithOiio(std::string_view bytes, ImageFormat, std::string& out);

}  // namespace vitrine::render
