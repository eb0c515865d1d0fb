#pragma once

#include <string>
#include <vector>

namespace vitrine::test {

/// Returns the subfolders of an assets folder that are named by a language ("de"), sorted. Fails the test if there are
/// none.
[[nodiscard]] std::vector<std::string> languagesUnder(const std::string& folder);
/// Returns the names of files with this suffix in an assets folder, sorted.
[[nodiscard]] std::vector<std::string> filesIn(const std::string& folder, const std::string& ending);
/// Returns the numbers written as digits in a text, sorted, except for those in names of parameters and in addresses.
[[nodiscard]] std::vector<std::string> numbersIn(const std::string& text);
/// Returns why a text is no well-formed UTF-8: a broken character, or an umlaut that is decomposed or written as an
/// entity. Empty if it is correct.
[[nodiscard]] std::string faultOfText(const std::string& text);

}  // namespace vitrine::test
