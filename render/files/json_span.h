#pragma once

#include "render/files/strict_json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Place of one value of a JSON text, and its neighbors by their index in the list of all values.
struct JsonSpan {
    enum class Type : std::uint8_t { null, boolean, number, string, array, object };
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    Type type = Type::null;
    std::uint32_t begin = 0, end = 0;        ///< Bytes of the text.
    std::uint32_t keyBegin = 0, keyEnd = 0;  ///< Bytes of its key, quotes included; equal where it is no member.
    std::uint32_t parent = none, firstChild = none, next = none;
};

/// Tells whether a character may stand between two values or brackets of a JSON text.
[[nodiscard]] inline bool isBetweenJsonTokens(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':';
}

/// Places of all values in the order of the text, a parent before its children, noted while the text is parsed. The
/// text must be shorter than 4 GiB. Throws JsonFailure as `parseJson` does.
[[nodiscard]] std::vector<JsonSpan> jsonSpans(std::string_view text, const std::string& name, const JsonLimits&);

}  // namespace vitrine::render
