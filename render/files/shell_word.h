#pragma once

#include <string>
#include <string_view>

namespace vitrine::render {

/// Quotes the word for a POSIX shell, if necessary.
[[nodiscard]] inline std::string shellWord(const std::string& word)
{
    const std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,/:+%@";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + '\'';
}

}  // namespace vitrine::render
