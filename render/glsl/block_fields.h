#pragma once

#include "render/glsl/lexer.h"

#include <string_view>
#include <vector>

namespace vitrine::render {

/// Field in the list of a uniform block: `FIELD(type, name)` or `ARRAY(type, name, count)`.
struct ListedField {
    std::string_view type, name;
    std::string_view count;  ///< Expression without parentheses; empty: no array.
    std::size_t last = 0;    ///< Index of its closing parenthesis.
};

/// Returns the fields that stand one behind the other from a token on.
[[nodiscard]] std::vector<ListedField> listedFields(const Tokens&, std::size_t first);

}  // namespace vitrine::render
