#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Implements OiioCodec::openRows; may throw.
[[nodiscard]] std::string openRowsWithOiio(const OiioRowTarget&, std::unique_ptr<OiioRows>& out);

/// Implements OiioCodec::checkRows; may throw.
[[nodiscard]] std::string checkRowsWithOiio(const OiioRowTarget&, const std::vector<WrittenRow>&);

}  // namespace vitrine::render
