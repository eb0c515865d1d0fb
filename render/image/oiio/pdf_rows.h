#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Implements OiioCodec::openPdfRows; may throw.
[[nodiscard]] std::string openPdfRowsWithQpdf(const OiioRowTarget&, std::unique_ptr<OiioRows>& out);

}  // namespace vitrine::render
