#pragma once

#include "render/files/strict_json.h"

#include <string>

namespace vitrine::app {

/// Text for HTML, outside of tags and in attributes.
[[nodiscard]] std::string escaped(const std::string& text);
/// Text in place of the word, which stands in it once.
[[nodiscard]] std::string with(std::string text, const std::string& word, const std::string& replacement);
/// So many significant digits; a dash where the number is not finite.
[[nodiscard]] std::string pageNumber(double x, int digits = 4);
/// JSON for a script element, which nothing in it ends.
[[nodiscard]] std::string scriptJson(const render::Json&);
/// A page of the program from its first line to where its content begins: language, title, the style that all have.
[[nodiscard]] std::string pageHead(const std::string& title);

}  // namespace vitrine::app
