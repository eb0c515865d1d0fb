#pragma once

#include <string>
#include <string_view>

namespace vitrine::app {

/// Encodes bytes as base64 (RFC 4648, section 4, padded), without line breaks.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace vitrine::app
