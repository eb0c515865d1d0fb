#include "ui/kit/hyphens.h"

#include <algorithm>
#include <array>

namespace vitrine::ui {
namespace {
namespace hyphens {

constexpr qsizetype leastLetters = 3;  // Letters before the first hyphen and after the last one.
// Letters that begin a syllable together, the longest first.
constexpr std::array sounds{"schr", "schl", "schm", "schn", "schw", "sch", "str",
                            "spr",  "st",   "sp",   "ch",   "ck",   "ph",  "th"};

bool isVowel(QChar c)
{
    return QStringLiteral("aeiouyäöü").contains(c.toLower());
}

bool isConsonant(QChar c)
{
    return c.isLetter() && !isVowel(c);
}

/// Returns the beginning of the syllable whose last consonant is at this place.
qsizetype beginOf(const QString& word, qsizetype last)
{
    for (const char* sound : sounds) {
        const QLatin1String letters(sound);
        const qsizetype begin = last + 1 - letters.size();
        if (begin >= 0 && word.mid(begin, letters.size()).compare(letters, Qt::CaseInsensitive) == 0) return begin;
    }
    return last;
}

}  // namespace hyphens
}  // namespace

QString withSoftHyphens(const QString& word)
{
    QString parts;
    qsizetype done = 0;
    for (qsizetype i = 1; i + 1 < word.size(); ++i) {
        if (!hyphens::isConsonant(word[i]) || !hyphens::isVowel(word[i + 1])) continue;
        const qsizetype begin = hyphens::beginOf(word, i);
        const QString part = word.mid(done, begin - done);
        const bool isSyllable = std::any_of(part.begin(), part.end(), hyphens::isVowel);
        if (!isSyllable || begin < hyphens::leastLetters || word.size() - begin < hyphens::leastLetters) continue;
        parts += part + softHyphen;
        done = begin;
    }
    return parts + word.mid(done);
}

}  // namespace vitrine::ui
