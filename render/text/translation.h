#pragma once

#include <memory>
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
/// with anything in its places; these are translated likewise where they are texts of the program themselves.
class Catalog {
public:
    /// By English text; places are {1} to {9} in both. In a translation, {=1} takes what stands there as it is.
    using Entries = std::vector<std::pair<std::string, std::string>>;
    explicit Catalog(Entries);
    ~Catalog();
    Catalog(const Catalog&) = delete;
    Catalog& operator=(const Catalog&) = delete;

    /// The text itself where the catalog lacks it. Several sentences, or lines, are translated one by one. From any
    /// thread.
    [[nodiscard]] std::string translated(std::string_view english) const;

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

}  // namespace vitrine
