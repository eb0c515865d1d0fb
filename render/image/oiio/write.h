#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// Constant creation date of every file. OpenImageIO would write the current time, but the same picture must give the
/// same bytes.
inline constexpr const char* timelessDate = "1970:01:01 00:00:00";

/// Implements OiioCodec::write; may throw.
[[nodiscard]] std::string writeWithOiio(const StoredPicture&, const OiioTarget&);

}  // namespace vitrine::render
