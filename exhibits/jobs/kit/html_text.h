#pragma once

#include "render/files/strict_json.h"

#include <string>

namespace vitrine::jobs {

/// Replaces `word`, which occurs once in the text.
[[nodiscard]] std::string with(std::string text, const std::string& word, const std::string& replacement);
/// Formats a number with this many significant digits; a dash if it is not finite.
[[nodiscard]] std::string pageNumber(double x, int digits = 4);
/// Serializes JSON for a script element. Nothing in it can end the element.
[[nodiscard]] std::string scriptJson(const render::Json&);
/// Returns the beginning of an HTML page, up to its content: language, title, and the common style.
[[nodiscard]] std::string pageHead(const std::string& title);

}  // namespace vitrine::jobs
