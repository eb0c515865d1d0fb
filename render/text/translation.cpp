#include "render/text/translation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace vitrine {

/// A sentence with placeholders: the text before, between and after them, and the number of each.
struct SentencePattern {
    std::vector<std::string> pieces;  ///< One more than `places`.
    std::vector<int> places;
    std::string translation;
    std::size_t letters = 0;  ///< Total letters of all pieces, which must match.
};

namespace {

constexpr int deepest = 6;                 ///< Nesting depth of sentences in sentences.
constexpr std::size_t mostKept = 4096;     ///< Number of cached results.
constexpr std::size_t fewLetters = 4;      ///< With fewer letters of its own, an entry would match nearly any text.
constexpr std::size_t longestText = 8192;  ///< Bytes: a longer text is not the program's.

/// Returns the number of a placeholder "{1}" at `at`, or nothing.
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

/// Returns the texts at the placeholders, or nothing if the pattern does not match. Between two placeholders the first
/// match counts.
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

/// A translated text, and how many of its letters the catalog covers.
struct Said {
    std::string text;
    std::size_t letters = 0;
};

/// Returns whether a text without a translation may stay in a translated sentence: a name, a number, a value with its
/// unit, or quoted words. Several English words may not.
bool isNeutral(std::string_view text)
{
    if (text.find(' ') == std::string_view::npos) return true;
    const auto quoted = [&](std::string_view open, std::string_view close) {
        return text.size() > open.size() + close.size() && text.starts_with(open) && text.ends_with(close) &&
               text.find(close, open.size()) == text.size() - close.size();
    };
    if (quoted("\"", "\"") || quoted("“", "”") || (text.starts_with('/') && text.find(": ") == std::string_view::npos))
        return true;
    // A text is also neutral if it has only numbers with units, or is a list of numbers or of names.
    std::size_t from = 0;
    bool first = true;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        const std::string_view word = text.substr(from, end - from);
        // The last name of a list has no comma.
        const bool ends = from >= 2 && text[from - 2] == ',' && end == text.size();
        const bool named = ends || word.ends_with(',') || std::any_of(word.begin(), word.end(), [](unsigned char c) {
                               return std::isalpha(c) == 0 && c != '.' && c != ';' && c != ':' && c != '-';
                           });
        const bool unit = !first && lettersOf(word) <= 3 && end == text.size();
        if (!named && !unit && lettersOf(word) > 0) return false;
        first = false;
        from = end + 1;
    }
    return true;
}

}  // namespace

struct Catalog::Texts {
    std::unordered_map<std::string, std::string> whole;
    std::unordered_map<std::string, std::string> sentences;  ///< Sentences with placeholders, by the English one.
    std::vector<SentencePattern> patterns;                   ///< Sorted by their number of letters, most first.
    mutable std::mutex mutex;
    mutable std::unordered_map<std::string, std::string> kept;
};

namespace {

/// Translation of one text, with cached results for its parts.
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
    /// Translates a text. Returns it unchanged if it is unknown but neutral; nothing if it is unknown.
    [[nodiscard]] std::optional<Said> saidOrNeutral(std::string_view english, int depth)
    {
        std::optional<Said> said = of(english, depth);
        return said || !isNeutral(english) ? said : std::optional(Said{std::string(english), 0});
    }

    const std::unordered_map<std::string, std::string>& whole_;
    const std::vector<SentencePattern>& patterns_;
    /// One cache for each depth, because deeper texts are searched less far.
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
        if (asIs && pattern.letters < fewLetters && here->second.find(' ') != std::string_view::npos)
            return std::nullopt;
        if (asIs || lettersOf(here->second) == 0) {
            made.text += here->second;
        } else {
            const std::optional<Said> inner =
                depth < deepest ? saidOrNeutral(here->second, depth + 1) : std::optional<Said>();
            if (!inner) return std::nullopt;
            made.text += inner->text;
            made.letters += inner->letters;
        }
        i += asIs ? 3 : 2;
    }
    return made;
}

/// Translates a text by one entry of the catalog. If several match, takes the one that leaves the fewest letters in
/// English.
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

/// Translates a text as two parts separated by `between`.
std::optional<Said> Reading::inParts(std::string_view english, std::string_view between, std::size_t keptBefore,
                                     int depth)
{
    for (std::size_t at = english.find(between); at != std::string_view::npos; at = english.find(between, at + 1)) {
        const std::string_view rest = english.substr(at + between.size());
        const auto first = wholeOf(english.substr(0, at + keptBefore), depth);
        if (!first || rest.empty()) continue;
        const auto second = saidOrNeutral(rest, depth);
        if (!second) continue;
        return Said{first->text + std::string(between.substr(keptBefore)) + second->text,
                    first->letters + second->letters};
    }
    return std::nullopt;
}

std::optional<Said> Reading::of(std::string_view english, int depth)
{
    if (english.find('\n') != std::string_view::npos) {
        const std::size_t line = english.find('\n');
        const auto first = saidOrNeutral(english.substr(0, line), depth);
        const auto rest = first ? saidOrNeutral(english.substr(line + 1), depth) : first;
        if (!rest) return std::nullopt;
        return Said{first->text + '\n' + rest->text, first->letters + rest->letters};
    }
    if (const auto entry = whole_.find(std::string(english)); entry != whole_.end())
        return Said{entry->second, lettersOf(english)};
    // Splits a text of several sentences first: a placeholder of a pattern would include the second sentence.
    if (auto sentences = inParts(english, ". ", 1, depth)) return sentences;
    return wholeOf(english, depth);
}

}  // namespace

Catalog::Catalog(Entries entries)
{
    auto texts = std::make_unique<Texts>();
    for (auto& [english, translation] : entries) {
        if (translation.empty()) continue;
        if (english.find("{1}") != std::string::npos) texts->sentences.emplace(english, translation);
        if (auto pattern = patternOf(english, translation))
            texts->patterns.push_back(std::move(*pattern));
        else
            texts->whole.emplace(std::move(english), std::move(translation));
    }
    const auto size = [](const SentencePattern& pattern) {
        std::size_t sum = 0;
        for (const std::string& piece : pattern.pieces) sum += piece.size();
        return std::pair(pattern.letters, sum);
    };
    std::stable_sort(texts->patterns.begin(), texts->patterns.end(),
                     [&](const SentencePattern& a, const SentencePattern& b) { return size(a) > size(b); });
    texts_ = std::move(texts);
}

Catalog::~Catalog() = default;

std::string Catalog::filled(std::string_view sentence, const std::vector<std::string>& places) const
{
    const auto known = texts_->sentences.find(std::string(sentence));
    return withPlaces(known == texts_->sentences.end() ? sentence : std::string_view(known->second), places);
}

std::string Catalog::translated(const Message& message) const
{
    if (message.kind_ == Message::Kind::verbatim) return message.text_;
    // Without words of its own, such as "{1}:{2}: {3}", it is in the language of its arguments.
    const std::string_view own = message.text();
    const bool hasWords =
        std::any_of(own.begin(), own.end(), [](unsigned char c) { return c > 127 || std::isalpha(c) != 0; });
    if (!message.isMarked() && (hasWords || message.arguments_.empty()))
        return recognized(message.english());  // Completely or not at all.
    if (message.arguments_.empty()) {
        const auto known = texts_->whole.find(std::string(message.text()));
        return known == texts_->whole.end() ? std::string(message.text()) : known->second;
    }
    std::vector<std::string> places;
    for (const Message& argument : message.arguments_) places.push_back(translated(argument));
    return filled(message.text(), places);
}

std::string Catalog::recognized(const std::string& key) const
{
    if (key.empty() || key.size() > longestText) return key;
    {
        const std::lock_guard lock(texts_->mutex);
        if (const auto known = texts_->kept.find(key); known != texts_->kept.end()) return known->second;
    }
    const std::optional<Said> said = Reading(texts_->whole, texts_->patterns).of(key, 0);
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

std::shared_ptr<const Catalog> chosenTexts()
{
    Language& chosen = chosenLanguage();
    const std::lock_guard lock(chosen.mutex);
    return chosen.texts;
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

std::string translated(const Message& message)
{
    const std::shared_ptr<const Catalog> texts = chosenTexts();
    return texts ? texts->translated(message) : message.english();
}

std::string translated(std::string_view sentence, std::initializer_list<std::string> places)
{
    const std::shared_ptr<const Catalog> texts = chosenTexts();
    return texts ? texts->filled(sentence, places) : withPlaces(sentence, places);
}

}  // namespace vitrine
