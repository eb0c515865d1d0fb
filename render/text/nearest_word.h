#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Suggests the intended word for a mistyped one: the only word that begins with it, or the word at the smallest edit
/// distance. The distance is at most two, or a third of the letters if that is more. Empty if no word is near.
[[nodiscard]] std::string nearestWord(std::string_view typed, const std::vector<std::string>& words);

/// Returns "; did you mean sphere?" if one of the words is similar, else ";".
[[nodiscard]] std::string didYouMean(std::string_view typed, const std::vector<std::string>& words);

/// Returns the refusal of a choice: "--pace \"ease\": did you mean eased? give one of constant, eased."
[[nodiscard]] std::string noSuchChoice(const std::string& option, const std::string& typed,
                                       const std::vector<std::string>& names);

}  // namespace vitrine
