#pragma once

#include <QString>

#include <string>
#include <vector>

namespace vitrine::ui {

/// Words of a text, in lower case and without accents. Everything but letters and digits separates words.
[[nodiscard]] std::vector<std::string> searchWords(const QString&);

/// Words by which something is found.
struct SearchText {
    std::vector<std::string> title;  ///< Words of its name.
    std::vector<std::string> place;  ///< Words of where it is: exhibit, group, menu.
    std::vector<std::string> more;   ///< Words of help, choices and keys.
};

[[nodiscard]] SearchText searchText(const QString& title, const QString& place, const QString& more);

/// Returns how well a text matches the words of a query; 0: not at all. Each word must be found: as a word, at the
/// beginning of one, or within one. Matches of the title count most, those of `more` least. In words of title and
/// place, one error is forgiven from four letters on, two from eight: a missing, additional, wrong or swapped letter.
[[nodiscard]] int searchScore(const std::vector<std::string>& query, const SearchText&);

}  // namespace vitrine::ui
