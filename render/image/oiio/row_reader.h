#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Implements OiioCodec::openRowReader; may throw.
[[nodiscard]] std::string openRowReaderWithOiio(const std::string& path, std::unique_ptr<OiioRowReader>& out);

}  // namespace vitrine::render
