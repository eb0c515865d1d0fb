#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The word that was probably meant by a mistyped one: the only one that it begins, or the one with the fewest letters
/// added, left out, changed or swapped, at most two, or one in three; empty where none is near.
[[nodiscard]] std::string nearestWord(std::string_view typed, const std::vector<std::string>& words);

/// "; did you mean sphere?" where one of the words is near, else ";".
[[nodiscard]] std::string didYouMean(std::string_view typed, const std::vector<std::string>& words);

/// "a, b, c".
[[nodiscard]] std::string namesText(const std::vector<std::string>& names);

}  // namespace vitrine
