#pragma once

#include "render/image/oiio_codec.h"

namespace vitrine::render {

/// What every file says of when it was made: OpenImageIO would write the time of day, and the same picture must give
/// the same bytes.
inline constexpr const char* timelessDate = "1970:01:01 00:00:00";

/// The work of OiioCodec::write; may throw.
[[nodiscard]] std::string writeWithOiio(const StoredPicture&, const OiioTarget&);

}  // namespace vitrine::render
