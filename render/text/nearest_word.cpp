#include "render/text/nearest_word.h"

#include "render/text/edit_distance.h"
#include "render/text/joined.h"

#include <algorithm>
#include <iterator>

namespace vitrine {

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
