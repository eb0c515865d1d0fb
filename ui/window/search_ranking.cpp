#include "ui/window/search_ranking.h"

#include "render/text/edit_distance.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vitrine::ui {
namespace {

/// Scores of a typed word that equals a word, begins it, is within it, or is misspelled; 0: no match.
struct Scores {
    int equal, begins, within, misspelled;
};

constexpr Scores inTitle{100, 80, 50, 40};
constexpr Scores inPlace{45, 35, 20, 15};
constexpr Scores inMore{30, 20, 10, 0};
constexpr std::size_t leastWithin = 3;  // Letters of a word that is looked for within others.
constexpr int costOfError = 5;
constexpr int wholeBeginning = 30;  // Bonus if the title begins with all that is typed.

std::size_t mostErrors(const std::string& typed)
{
    return typed.size() >= 8 ? 2 : typed.size() >= 4 ? 1 : 0;
}

int misspelled(const std::string& typed, const std::string& word, int score)
{
    const std::size_t most = mostErrors(typed);
    if (most == 0 || score == 0 || word.size() + most < typed.size()) return 0;
    // The word may not be typed to its end yet.
    const std::size_t errors = std::min(editDistance(typed, word), editDistance(typed, word.substr(0, typed.size())));
    return errors <= most ? score - costOfError * static_cast<int>(errors) : 0;
}

int scoreOf(const std::string& typed, const std::string& word, const Scores& scores)
{
    if (word == typed) return scores.equal;
    if (word.starts_with(typed)) return scores.begins;
    if (typed.size() >= leastWithin && word.find(typed) != std::string::npos) return scores.within;
    return misspelled(typed, word, scores.misspelled);
}

int bestOf(const std::string& typed, const std::vector<std::string>& words, const Scores& scores)
{
    int best = 0;
    for (const std::string& word : words) best = std::max(best, scoreOf(typed, word, scores));
    return best;
}

std::string together(const std::vector<std::string>& words)
{
    return std::accumulate(words.begin(), words.end(), std::string());
}

int scoreOfAll(const std::vector<std::string>& query, const SearchText& text)
{
    int sum = 0;
    for (const std::string& typed : query) {
        const int best = std::max(
            {bestOf(typed, text.title, inTitle), bestOf(typed, text.place, inPlace), bestOf(typed, text.more, inMore)});
        if (best == 0) return 0;
        sum += best;
    }
    return sum / static_cast<int>(query.size());
}

}  // namespace

std::vector<std::string> searchWords(const QString& text)
{
    std::vector<std::string> words;
    QString word;
    const auto finish = [&] {
        if (!word.isEmpty()) words.push_back(word.toStdString());
        word.clear();
    };
    QString plain = text.normalized(QString::NormalizationForm_KD).toCaseFolded();
    plain.replace(QChar(u'ß'), QStringLiteral("ss"));
    for (const QChar c : std::as_const(plain)) {
        if (c.isLetterOrNumber())
            word += c;
        else if (!c.isMark())
            finish();
    }
    finish();
    return words;
}

SearchText searchText(const QString& title, const QString& place, const QString& more)
{
    SearchText text{searchWords(title), searchWords(place), searchWords(more)};
    if (text.title.size() > 1) text.title.push_back(together(text.title));  // "heatmap" finds "Heat map".
    std::sort(text.more.begin(), text.more.end());
    text.more.erase(std::unique(text.more.begin(), text.more.end()), text.more.end());
    return text;
}

int searchScore(const std::vector<std::string>& query, const SearchText& text)
{
    if (query.empty()) return 0;
    const std::string whole = together(query);
    const int score = std::max(scoreOfAll(query, text), query.size() > 1 ? bestOf(whole, text.title, inTitle) : 0);
    if (score == 0) return 0;
    // Two matches of equal score are ordered by length: people who search usually mean the shorter title.
    const int length = std::min(static_cast<int>(text.title.size()), 9);
    return 10 * (score + (together(text.title).starts_with(whole) ? wholeBeginning : 0)) - length;
}

}  // namespace vitrine::ui
