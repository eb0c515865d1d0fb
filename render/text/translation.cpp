#include "render/text/translation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace vitrine {

/// A sentence with places: what stands before, between and behind them, and which place each is.
struct SentencePattern {
    std::vector<std::string> pieces;  ///< One more than `places`.
    std::vector<int> places;
    std::string translation;
    std::size_t letters = 0;  ///< Of all pieces: how much has to fit.
};

namespace {

constexpr int deepest = 6;                 ///< Sentences within sentences.
constexpr std::size_t mostKept = 4096;     ///< Answers that are remembered.
constexpr std::size_t longestText = 8192;  ///< Bytes: what is longer is no text of the program.

/// "{1}" at `at`, or nothing.
std::optional<int> placeAt(std::string_view text, std::size_t at)
{
    if (at + 2 >= text.size() || text[at] != '{' || text[at + 2] != '}') return std::nullopt;
    return text[at + 1] >= '1' && text[at + 1] <= '9' ? std::optional(text[at + 1] - '0') : std::nullopt;
}

std::size_t lettersOf(std::string_view text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; }));
}

std::optional<SentencePattern> patternOf(std::string_view english, std::string translation)
{
    SentencePattern made{{{}}, {}, std::move(translation), 0};
    for (std::size_t i = 0; i < english.size(); ++i) {
        if (const auto place = placeAt(english, i)) {
            made.places.push_back(*place);
            made.pieces.emplace_back();
            i += 2;
        } else {
            made.pieces.back() += english[i];
        }
    }
    for (const std::string& piece : made.pieces) made.letters += lettersOf(piece);
    return made.places.empty() || made.letters == 0 ? std::nullopt : std::optional(std::move(made));
}

/// What stands in the places, or nothing where the text is another one. Between two places the first fit counts.
std::optional<std::map<int, std::string_view>> found(const SentencePattern& pattern, std::string_view text)
{
    const std::string& first = pattern.pieces.front();
    const std::string& last = pattern.pieces.back();
    if (text.size() < first.size() + last.size() || !text.starts_with(first) || !text.ends_with(last))
        return std::nullopt;
    std::map<int, std::string_view> places;
    std::size_t at = first.size();
    const std::size_t end = text.size() - last.size();
    for (std::size_t k = 0; k < pattern.places.size(); ++k) {
        std::size_t next = end;
        if (k + 1 < pattern.places.size()) {
            next = text.substr(0, end).find(pattern.pieces[k + 1], at);
            if (next == std::string_view::npos) return std::nullopt;
        }
        const std::string_view here = text.substr(at, next - at);
        const auto [known, added] = places.emplace(pattern.places[k], here);
        if (!added && known->second != here) return std::nullopt;
        at = next + (k + 1 < pattern.places.size() ? pattern.pieces[k + 1].size() : 0);
    }
    return places;
}

/// How a text is said, and how many of its letters stand in entries of the catalog.
struct Said {
    std::string text;
    std::size_t letters = 0;
};

}  // namespace

struct Catalog::Texts {
    std::unordered_map<std::string, std::string> whole;
    std::vector<SentencePattern> patterns;  ///< Those that ask for most letters first.
    mutable std::mutex mutex;
    mutable std::unordered_map<std::string, std::string> kept;
};

namespace {

/// One text, with what was found out about its parts.
class Reading {
public:
    Reading(const std::unordered_map<std::string, std::string>& whole, const std::vector<SentencePattern>& patterns)
        : whole_(whole), patterns_(patterns)
    {
    }

    [[nodiscard]] std::optional<Said> of(std::string_view english, int depth);

private:
    [[nodiscard]] std::optional<Said> wholeOf(std::string_view english, int depth);
    [[nodiscard]] std::optional<Said> by(const SentencePattern&, std::string_view english, int depth);
    [[nodiscard]] std::optional<Said> inParts(std::string_view english, std::string_view between,
                                              std::size_t keptBefore, int depth);
    /// As it is, where it is not known.
    [[nodiscard]] Said saidOrKept(std::string_view english, int depth)
    {
        return of(english, depth).value_or(Said{std::string(english), 0});
    }

    const std::unordered_map<std::string, std::string>& whole_;
    const std::vector<SentencePattern>& patterns_;
    /// By depth: what lies deeper is read less far.
    std::array<std::unordered_map<std::string_view, std::optional<Said>>, deepest + 1> known_;
};

std::optional<Said> Reading::by(const SentencePattern& pattern, std::string_view english, int depth)
{
    const auto places = found(pattern, english);
    if (!places) return std::nullopt;
    Said made{{}, pattern.letters};
    const std::string& into = pattern.translation;
    for (std::size_t i = 0; i < into.size(); ++i) {
        const bool asIs = into.compare(i, 2, "{=") == 0;
        const auto place = asIs ? placeAt("{" + into.substr(i + 2, 2), 0) : placeAt(into, i);
        const auto here = place ? places->find(*place) : places->end();
        if (here == places->end()) {
            made.text += into[i];
            continue;
        }
        const bool translate = !asIs && depth < deepest && lettersOf(here->second) > 0;
        const Said inner = translate ? saidOrKept(here->second, depth + 1) : Said{std::string(here->second), 0};
        made.text += inner.text;
        made.letters += inner.letters;
        i += asIs ? 3 : 2;
    }
    return made;
}

/// As one entry of the catalog: of several that fit, the one that leaves the fewest letters in English.
std::optional<Said> Reading::wholeOf(std::string_view english, int depth)
{
    const std::size_t all = lettersOf(english);
    if (const auto entry = whole_.find(std::string(english)); entry != whole_.end()) return Said{entry->second, all};
    auto& known = known_.at(static_cast<std::size_t>(depth));
    if (const auto before = known.find(english); before != known.end()) return before->second;
    std::optional<Said> best;
    for (const SentencePattern& pattern : patterns_) {
        std::optional<Said> said = by(pattern, english, depth);
        if (said && (!best || said->letters > best->letters)) best = std::move(said);
        if (best && best->letters >= all) break;
    }
    known.emplace(english, best);
    return best;
}

/// As two texts with `between` between them, of which at least the first is known.
std::optional<Said> Reading::inParts(std::string_view english, std::string_view between, std::size_t keptBefore,
                                     int depth)
{
    for (std::size_t at = english.find(between); at != std::string_view::npos; at = english.find(between, at + 1)) {
        const std::string_view rest = english.substr(at + between.size());
        const auto first = wholeOf(english.substr(0, at + keptBefore), depth);
        if (!first || rest.empty()) continue;
        const Said second = saidOrKept(rest, depth);
        return Said{first->text + std::string(between.substr(keptBefore)) + second.text,
                    first->letters + second.letters};
    }
    return std::nullopt;
}

std::optional<Said> Reading::of(std::string_view english, int depth)
{
    if (english.find('\n') != std::string_view::npos) {
        const std::size_t line = english.find('\n');
        const Said first = saidOrKept(english.substr(0, line), depth);
        const Said rest = saidOrKept(english.substr(line + 1), depth);
        return Said{first.text + '\n' + rest.text, first.letters + rest.letters};
    }
    if (const auto entry = whole_.find(std::string(english)); entry != whole_.end())
        return Said{entry->second, lettersOf(english)};
    // A text of several sentences first: a pattern's place would take the second along.
    if (auto sentences = inParts(english, ". ", 1, depth)) return sentences;
    return wholeOf(english, depth);
}

}  // namespace

Catalog::Catalog(Entries entries)
{
    auto texts = std::make_unique<Texts>();
    for (auto& [english, translation] : entries) {
        if (translation.empty()) continue;
        if (auto pattern = patternOf(english, translation))
            texts->patterns.push_back(std::move(*pattern));
        else
            texts->whole.emplace(std::move(english), std::move(translation));
    }
    std::stable_sort(texts->patterns.begin(), texts->patterns.end(),
                     [](const SentencePattern& a, const SentencePattern& b) { return a.letters > b.letters; });
    texts_ = std::move(texts);
}

Catalog::~Catalog() = default;

std::string Catalog::translated(std::string_view english) const
{
    if (english.empty() || english.size() > longestText) return std::string(english);
    const std::string key(english);
    {
        const std::lock_guard lock(texts_->mutex);
        if (const auto known = texts_->kept.find(key); known != texts_->kept.end()) return known->second;
    }
    const std::optional<Said> said = Reading(texts_->whole, texts_->patterns).of(english, 0);
    std::string made = said ? said->text : key;
    const std::lock_guard lock(texts_->mutex);
    if (texts_->kept.size() >= mostKept) texts_->kept.clear();
    texts_->kept.emplace(key, made);
    return made;
}

namespace {

struct Language {
    std::mutex mutex;
    std::string code = "en";
    std::shared_ptr<const Catalog> texts;
};

Language& chosenLanguage()
{
    static Language chosen;
    return chosen;
}

}  // namespace

void setLanguage(std::string code, std::shared_ptr<const Catalog> texts)
{
    Language& chosen = chosenLanguage();
    const std::lock_guard lock(chosen.mutex);
    chosen.code = std::move(code);
    chosen.texts = std::move(texts);
}

std::string language()
{
    Language& chosen = chosenLanguage();
    const std::lock_guard lock(chosen.mutex);
    return chosen.code;
}

std::string translated(std::string_view english)
{
    std::shared_ptr<const Catalog> texts;
    {
        Language& chosen = chosenLanguage();
        const std::lock_guard lock(chosen.mutex);
        texts = chosen.texts;
    }
    return texts ? texts->translated(english) : std::string(english);
}

}  // namespace vitrine
