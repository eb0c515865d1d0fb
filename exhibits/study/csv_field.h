#pragma once

#include <string>

namespace vitrine::study {

/// Returns a field of a CSV file, quoted if it contains a comma, a quote or a line break (RFC 4180).
[[nodiscard]] inline std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + '"';
}

}  // namespace vitrine::study
