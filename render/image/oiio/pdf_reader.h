#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Implements OiioCodec::openPdfReader; may throw.
[[nodiscard]] std::string openPdfReaderWithQpdf(const std::string& path, std::unique_ptr<OiioRowReader>& out);

}  // namespace vitrine::render
