#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// What people read in another language for what the program says in English.
///
/// The program speaks, compares, keeps and writes English everywhere; only where a text is shown to people is it
/// translated, so that files, reports and tests are the same in every language, and another language can be chosen at
/// any time. A sentence with places for what differs, "Cannot read {1}: {2}; choose another picture.", is recognized
/// by what stands around them; what stands in them is translated likewise. A text is translated as a whole or not at
/// all: where a part of it is in no entry, and is no name or number either, all of it stays English.
class Catalog {
public:
    /// By English text; places are {1} to {9} in both. In a translation, {=1} takes what stands there as it is: names,
    /// paths, what was typed, words of another library. Around it the entry must have four letters of its own, or it
    /// takes a single word only.
    using Entries = std::vector<std::pair<std::string, std::string>>;
    explicit Catalog(Entries);
    ~Catalog();
    Catalog(const Catalog&) = delete;
    Catalog& operator=(const Catalog&) = delete;

    /// The text itself where the catalog lacks any part of it. From any thread.
    [[nodiscard]] std::string translated(std::string_view english) const;
    /// A sentence with places, as it stands in the catalog, filled with texts that are in its language already.
    [[nodiscard]] std::string filled(std::string_view sentence, std::span<const std::string> places) const;

private:
    struct Texts;
    std::unique_ptr<const Texts> texts_;
};

/// The language of all that is shown from now on, by its code ("de"), and its texts; "en" needs none.
void setLanguage(std::string code, std::shared_ptr<const Catalog>);
/// The code that was set last, "en" at first.
[[nodiscard]] std::string language();
/// In the program's language; `english` itself in English. From any thread.
[[nodiscard]] std::string translated(std::string_view english);
/// A sentence in the program's language, "“{1}” is above {2}", filled with texts that are in this language already.
[[nodiscard]] std::string translated(std::string_view sentence, std::initializer_list<std::string> places);

}  // namespace vitrine
