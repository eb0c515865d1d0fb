#pragma once

#include "render/text/message.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace vitrine::render {

/// Position in a text, for messages: line and column from 1, columns in bytes.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// Returns the position of a byte of a text; beyond the end, that of the end.
[[nodiscard]] inline TextPosition positionAt(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1, static_cast<int>(column)};
}

/// Returns the error text for a zero byte; a sentence without its full stop.
[[nodiscard]] inline Message zeroByteProblem()
{
    return message("here is a zero byte, which no text has; remove it");
}

/// Returns the position of the first zero byte, or nothing. No text file may contain one, because readers differ in
/// whether it ends the text.
[[nodiscard]] inline std::optional<TextPosition> zeroByteIn(std::string_view text)
{
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) return std::nullopt;
    return positionAt(text, zero);
}

}  // namespace vitrine::render
