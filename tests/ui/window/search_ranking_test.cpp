#include "ui/window/search_ranking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::ui {
namespace {

int score(const char* query, const char* title, const char* place = "", const char* more = "")
{
    return searchScore(searchWords(QString::fromUtf8(query)),
                       searchText(QString::fromUtf8(title), QString::fromUtf8(place), QString::fromUtf8(more)));
}

/// Returns the titles that match, best first.
std::vector<std::string> found(const char* query, std::initializer_list<const char*> titles)
{
    std::vector<std::pair<int, std::string>> ranked;
    for (const char* title : titles)
        if (const int s = score(query, title); s > 0) ranked.emplace_back(-s, title);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (const auto& entry : ranked) names.push_back(entry.second);
    return names;
}

using Names = std::vector<std::string>;

TEST(SearchRanking, FindsWordsInAnyOrderAndNeedsAllOfThem)
{
    EXPECT_GT(score("count shell", "Shell count"), 0);
    EXPECT_GT(score("shell fur", "Shell count", "Fur: Accuracy"), 0);
    EXPECT_EQ(score("shell noise", "Shell count", "Fur: Accuracy"), 0);
    EXPECT_EQ(score("", "Shell count"), 0);
    EXPECT_EQ(score("  -  ", "Shell count"), 0);
}

TEST(SearchRanking, PutsTitlesBeforePlacesBeforeHelp)
{
    const int title = score("shadow", "Shadow method", "Mug", "How it shades itself.");
    const int place = score("shadow", "Sun width", "Shadow", "Angular diameter of the sun.");
    const int help = score("shadow", "Disk samples", "Sun", "Comparisons in a half-shadow.");
    EXPECT_GT(title, place);
    EXPECT_GT(place, help);
    EXPECT_GT(help, 0);
}

TEST(SearchRanking, PutsWholeWordsBeforeBeginningsBeforePartsBeforeTypos)
{
    EXPECT_EQ(found("light", {"Moonlight", "Sligt", "Lighting", "Light"}), (Names{"Light", "Lighting", "Moonlight"}));
    EXPECT_EQ(found("radius", {"Radius of the long handle", "Major radius", "Radius"}),
              (Names{"Radius", "Radius of the long handle", "Major radius"}));
}

TEST(SearchRanking, ForgivesOneErrorFromFourLettersAndTwoFromEight)
{
    // A swapped, a missing, an additional and a wrong letter (Damerau 1964 counts each as one error).
    for (const char* typo : {"raduis", "radus", "raddius", "redius"}) EXPECT_GT(score(typo, "Major radius"), 0) << typo;
    EXPECT_EQ(score("redeus", "Major radius"), 0) << "two errors in six letters";
    EXPECT_GT(score("oclusoin", "Occlusion"), 0) << "two errors in eight letters";
    EXPECT_GT(score("occlsion att", "Occlusion attenuation"), 0);
    EXPECT_GT(score("ocllu", "Occlusion"), 0) << "not typed to its end, and misspelled";
    EXPECT_EQ(score("fig", "Fog"), 0) << "three letters are too few";
    EXPECT_EQ(score("shadwo", "Sun", "", "Casts a shadow."), 0) << "typos are not looked for in help texts";
    EXPECT_GT(score("radius", "Radius"), score("raduis", "Radius"));
}

TEST(SearchRanking, IgnoresCaseAccentsAndPunctuation)
{
    EXPECT_GT(score("uberblendung", "Überblendung"), 0);
    EXPECT_GT(score("GROSSE", "Größe"), 0);
    EXPECT_GT(score("blinnphong", "Blinn-Phong"), 0);
    EXPECT_GT(score("heatmap", "Heat map"), 0);
    EXPECT_GT(score("heat map", "Heatmap"), 0);
    EXPECT_GT(score("shellcount", "Shells", "", "shellCount"), 0) << "the key in presets";
}

}  // namespace
}  // namespace vitrine::ui
