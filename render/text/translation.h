#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// Catalog of translations from the program's English texts into another language.
///
/// The program compares, stores and writes English everywhere. A text is translated only where it is displayed. So
/// files, reports and tests are the same in every language, and the language can be changed at any time.
///
/// A sentence with placeholders, "Cannot read {1}: {2}; choose another picture.", is recognized by the text around
/// them; the text in their place is translated in the same way. A text is translated completely or not at all: if a
/// part of it has no entry, and is no name or number either, all of it stays English.
class Catalog {
public:
    /// Pairs of English text and translation, with placeholders {1} to {9} in both. In a translation, {=1} inserts the
    /// text untranslated: names, paths, typed text, messages of other libraries. Such an entry must have four letters
    /// of its own around the placeholder, or else that matches a single word only.
    using Entries = std::vector<std::pair<std::string, std::string>>;
    explicit Catalog(Entries);
    ~Catalog();
    Catalog(const Catalog&) = delete;
    Catalog& operator=(const Catalog&) = delete;

    /// Returns the translation, or the text itself if the catalog lacks any part of it. Thread-safe.
    [[nodiscard]] std::string translated(std::string_view english) const;
    /// Returns the translation of a sentence with placeholders, given as in the catalog. They are filled with texts
    /// that are already translated.
    [[nodiscard]] std::string filled(std::string_view sentence, std::span<const std::string> places) const;

private:
    struct Texts;
    std::unique_ptr<const Texts> texts_;
};

/// Sets the language of all displayed texts from now on: its code ("de") and its catalog. "en" needs none.
void setLanguage(std::string code, std::shared_ptr<const Catalog>);
/// Returns the code that was set last; "en" at first.
[[nodiscard]] std::string language();
/// Translates to the program's language; returns `english` itself for English. Thread-safe.
[[nodiscard]] std::string translated(std::string_view english);
/// Translates a sentence with placeholders, "“{1}” is above {2}". They are filled with texts that are already
/// translated.
[[nodiscard]] std::string translated(std::string_view sentence, std::initializer_list<std::string> places);

}  // namespace vitrine
