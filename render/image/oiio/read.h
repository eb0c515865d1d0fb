#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// The work of OiioCodec::decode; may throw.
[[nodiscard]] std::string decodeWithOiio(std::string_view bytes, ImageFormat, const DecodeRequest&, StoredPicture& out);

/// The work of OiioCodec::readText; may throw.
[[nodiscard]] std::string readTextWithOiio(std::string_view bytes, ImageFormat, const std::string& key,
                                           std::string& out);

/// The work of OiioCodec::readProfile; may throw.
[[nodiscard]] std::string readProfileWithOiio(std::string_view bytes, ImageFormat, std::string& out);

/// "openexr", "tiff", ...: the plugin's name.
[[nodiscard]] const char* pluginName(ImageFormat);

}  // namespace vitrine::render
