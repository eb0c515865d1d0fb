#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// The work of OiioCodec::write; may throw.
[[nodiscard]] std::string writeWithOiio(const StoredPicture&, const OiioTarget&);

}  // namespace vitrine::render
