#pragma once

#include <string>

namespace vitrine {

/// A field of a CSV file: in quotes where it holds a comma, a quote or a line's end (RFC 4180).
[[nodiscard]] inline std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + '"';
}

}  // namespace vitrine
