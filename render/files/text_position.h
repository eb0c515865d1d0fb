#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace vitrine::render {

/// Position in a text for people: line and column from 1, columns in bytes.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// Position of a byte of a text; of one beyond the end, that of the end.
[[nodiscard]] inline TextPosition positionAt(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1, static_cast<int>(column)};
}

/// Problem of a text that has a zero byte; a sentence without its full stop.
inline constexpr std::string_view zeroByteProblem = "here is a zero byte, which no text has; remove it";

/// Position of the first zero byte, which no text file may have: readers differ in whether it ends the text. Nothing
/// where there is none.
[[nodiscard]] inline std::optional<TextPosition> zeroByteIn(std::string_view text)
{
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) return std::nullopt;
    return positionAt(text, zero);
}

}  // namespace vitrine::render
