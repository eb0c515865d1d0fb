#include "render/text/nearest_word.h"

#include "render/text/joined.h"

#include <algorithm>
#include <iterator>

namespace vitrine {
namespace {

/// Returns the number of letters inserted, deleted, replaced or swapped with the next one (Damerau 1964, "A technique
/// for computer detection and correction of spelling errors", in the restricted form).
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

std::string nearestWord(std::string_view typed, const std::vector<std::string>& words)
{
    constexpr std::size_t longest = 64;  // A longer text is no mistyped word.
    if (typed.empty() || typed.size() > longest) return {};
    std::vector<std::string> begun;
    std::copy_if(words.begin(), words.end(), std::back_inserter(begun),
                 [&](const std::string& word) { return word.starts_with(typed); });
    if (begun.size() == 1) return begun.front();
    std::string best;
    // At least one letter is right: "xx" is not like "en".
    std::size_t least = std::min(std::max<std::size_t>(2, typed.size() / 3) + 1, typed.size());
    for (const std::string& word : words)
        if (const std::size_t distance = editDistance(typed, word.substr(0, longest)); distance < least) {
            least = distance;
            best = word;
        }
    return best;
}

std::string noSuchChoice(const std::string& option, const std::string& typed, const std::vector<std::string>& names)
{
    const std::string near = nearestWord(typed, names);
    return option + " \"" + typed + "\": " + (near.empty() ? "" : "did you mean " + near + "? ") + "give one of " +
           joined(names) + '.';
}

std::string didYouMean(std::string_view typed, const std::vector<std::string>& words)
{
    const std::string near = nearestWord(typed, words);
    return near.empty() ? ";" : "; did you mean " + near + "?";
}

}  // namespace vitrine
