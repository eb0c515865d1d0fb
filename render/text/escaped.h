#pragma once

#include <string>
#include <string_view>

namespace vitrine {

/// Escapes text for the content and the attributes of HTML and XML.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace vitrine
