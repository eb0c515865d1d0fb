#pragma once

#include "render/text/message.h"

#include <initializer_list>
#include <memory>
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
/// A message is looked up by its English text with placeholders, "Cannot read {1}: {2}; choose another picture.", and
/// filled with its translated arguments.
///
/// A finished text that no message gives (of code that is not converted yet) is recognized by the text around the
/// placeholders; the text in their place is translated in the same way. Such a text is translated completely or not at
/// all: if a part of it has no entry, and is no name or number either, all of it stays English.
class Catalog {
public:
    /// Pairs of English text and translation, with placeholders {1} to {9} in both. In a translation, {=1} inserts the
    /// text untranslated: names, paths, typed text, messages of other libraries. An entry with {=1} needs four letters
    /// outside of its placeholders; otherwise {=1} matches a single word only.
    using Entries = std::vector<std::pair<std::string, std::string>>;
    explicit Catalog(Entries);
    ~Catalog();
    Catalog(const Catalog&) = delete;
    Catalog& operator=(const Catalog&) = delete;

    /// Returns the translation of the message, or English if the catalog lacks it. Thread-safe.
    [[nodiscard]] std::string translated(const Message&) const;
    /// Returns the translation of a sentence with placeholders, given as in the catalog. They are filled with texts
    /// that are already translated.
    [[nodiscard]] std::string filled(std::string_view sentence, const std::vector<std::string>& places) const;

private:
    [[nodiscard]] std::string recognized(const std::string& english) const;

    struct Texts;
    std::unique_ptr<const Texts> texts_;
};

/// Sets the language of all displayed texts from now on: its code ("de") and its catalog. "en" needs none.
void setLanguage(std::string code, std::shared_ptr<const Catalog>);
/// Returns the code that was set last; "en" at first.
[[nodiscard]] std::string language();
/// Translates to the program's language. Thread-safe.
[[nodiscard]] std::string translated(const Message&);
/// Translates a sentence with placeholders, "“{1}” is above {2}". They are filled with texts that are already
/// translated.
[[nodiscard]] std::string translated(std::string_view sentence, std::initializer_list<std::string> places);

}  // namespace vitrine
