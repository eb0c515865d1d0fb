#include "ui/parameters/panel_groups.h"

#include "exhibits/exhibits.h"
#include "tests/ui/sample_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace vitrine::ui {
namespace {

std::vector<std::string> titlesOf(const std::vector<PanelGroup>& groups)
{
    std::vector<std::string> titles;
    for (const PanelGroup& group : groups) titles.emplace_back(group.title);
    return titles;
}

std::vector<std::string> namesIn(const PanelGroup& group, const Parameters& table)
{
    std::vector<std::string> names;
    for (const std::size_t row : group.rows) names.emplace_back(table.rows()[row].name);
    return names;
}

using Names = std::vector<std::string>;

TEST(PanelGroups, PutEssentialsFirstPinnedOnesBelowAndFoldTheOthers)
{
    const test::EssentialTable table;
    const std::size_t weight = table.find("weight").value();
    const auto groups = panelGroups(table.rows(), [&](std::size_t row) { return row == weight; });
    ASSERT_EQ(titlesOf(groups), (Names{"Essentials", "Pinned", "Display", "Screen space", "Air"}));
    EXPECT_EQ(namesIn(groups[0], table), (Names{"technique", "airDensity", "tint"}));
    EXPECT_EQ(namesIn(groups[1], table), (Names{"weight"}));
    EXPECT_EQ(namesIn(groups[3], table), (Names{"decay"}));
    EXPECT_EQ(groups[3].members.size(), 2U) << "a lock of the group holds the pinned parameter, too";
    for (const PanelGroup& group : groups)
        EXPECT_EQ(group.foldedAtFirst, group.kind == PanelGroup::Kind::table) << group.title;
}

TEST(PanelGroups, KeepATableWithoutEssentialsAsItIs)
{
    const test::SampleTable table;
    const auto groups = panelGroups(table.rows(), [](std::size_t) { return true; });
    std::vector<std::size_t> shown;
    for (const PanelGroup& group : groups) {
        EXPECT_EQ(group.kind, PanelGroup::Kind::table);
        EXPECT_FALSE(group.foldedAtFirst);
        shown.insert(shown.end(), group.rows.begin(), group.rows.end());
    }
    EXPECT_EQ(shown.size(), table.rows().size());
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
}

TEST(PanelGroups, ShowEveryParameterOfEveryExhibitOnceAndSixAtFirst)
{
    for (const auto& exhibit : allExhibits()) {
        const Parameters& table = exhibit->parameters();
        std::vector<std::size_t> shown;
        std::size_t unfolded = 0;
        for (const PanelGroup& group : panelGroups(table.rows(), [](std::size_t) { return false; })) {
            shown.insert(shown.end(), group.rows.begin(), group.rows.end());
            if (!group.foldedAtFirst) unfolded += group.rows.size();
        }
        std::sort(shown.begin(), shown.end());
        EXPECT_EQ(shown.size(), table.rows().size()) << exhibit->name();
        EXPECT_EQ(std::adjacent_find(shown.begin(), shown.end()), shown.end()) << exhibit->name();
        EXPECT_EQ(unfolded, 6U) << exhibit->name();
    }
}

}  // namespace
}  // namespace vitrine::ui
