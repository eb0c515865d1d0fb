#pragma once

#include <string>
#include <vector>

namespace vitrine::test {

/// Folders under this one of the assets that are named by a language ("de"), sorted; fails the test if there is none.
[[nodiscard]] std::vector<std::string> languagesUnder(const std::string& folder);
/// Names of the files with this ending in that folder of the assets, sorted.
[[nodiscard]] std::vector<std::string> filesIn(const std::string& folder, const std::string& ending);
/// The numbers that stand in a text as digits, sorted; not those in the names of rows and in addresses.
[[nodiscard]] std::vector<std::string> numbersIn(const std::string& text);
/// What keeps a text from being well written UTF-8: a broken character, an umlaut that was taken apart or spelled as an
/// entity. Empty: nothing.
[[nodiscard]] std::string faultOfText(const std::string& text);

}  // namespace vitrine::test
