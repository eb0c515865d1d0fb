#pragma once

#include "render/files/strict_json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Position of one value in a JSON text. Its neighbors are given by their index in the list of all values.
struct JsonSpan {
    enum class Type : std::uint8_t { null, boolean, number, string, array, object };
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    Type type = Type::null;
    std::uint32_t begin = 0, end = 0;        ///< Range of bytes in the text.
    std::uint32_t keyBegin = 0, keyEnd = 0;  ///< Range of its key, quotes included; empty if it is no member.
    std::uint32_t parent = none, firstChild = none, next = none;
};

/// Returns whether a character may stand between two values or brackets of a JSON text.
[[nodiscard]] inline bool isBetweenJsonTokens(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':';
}

/// Returns the positions of all values in the order of the text, a parent before its children. The text must be shorter
/// than 4 GiB. Throws JsonFailure as `parseJson` does.
[[nodiscard]] std::vector<JsonSpan> jsonSpans(std::string_view text, const std::string& name, const JsonLimits&);

}  // namespace vitrine::render
