// tests/features.md: which tests hold which feature, checked from both sides.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace vitrine {
namespace {

const std::regex testMacro(R"(\bTEST(?:_F|_P)?\((\w+), (\w+)\))");

/// "Suite.Name" of every GoogleTest case of the project.
std::set<std::string> allTests()
{
    std::set<std::string> tests;
    for (const std::string& file : test::sourceFiles("tests", {".cpp"})) {
        const std::string text = test::withoutComments(test::sourceText(file));
        for (auto match = std::sregex_iterator(text.begin(), text.end(), testMacro); match != std::sregex_iterator();
             ++match)
            tests.insert((*match)[1].str() + '.' + (*match)[2].str());
    }
    return tests;
}

struct Feature {
    std::string id, name;
    std::vector<std::string> tests;
};

/// The rows "| S5 | what it is | `Suite.Test` `Suite.*` |" of a list.
std::vector<Feature> features(const std::string& text)
{
    static const std::regex row(R"(\| ([A-Z]\d+) \| ([^|]+) \| ([^|]*) \|)"), quoted("`([^`]+)`");
    std::vector<Feature> list;
    for (const std::string& line : test::lines(text)) {
        std::smatch parts;
        if (!std::regex_match(line, parts, row)) continue;
        Feature feature{parts[1], parts[2], {}};
        const std::string named = parts[3];
        for (auto match = std::sregex_iterator(named.begin(), named.end(), quoted); match != std::sregex_iterator();
             ++match)
            feature.tests.push_back((*match)[1]);
        list.push_back(std::move(feature));
    }
    return list;
}

bool exists(const std::string& named, const std::set<std::string>& tests)
{
    if (!named.ends_with(".*")) return tests.contains(named);
    const std::string suite = named.substr(0, named.size() - 1);
    return std::any_of(tests.begin(), tests.end(), [&](const std::string& test) { return test.starts_with(suite); });
}

/// The numbers of lists that a test bears: S9 and S10 of "Scene.S9_S10_TheyIntersect".
std::vector<std::string> idsOf(const std::string& test)
{
    static const std::regex id(R"(([A-Z]\d+)_)");
    std::vector<std::string> ids;
    std::string rest = test.substr(test.find('.') + 1);
    for (std::smatch match; std::regex_search(rest, match, id, std::regex_constants::match_continuous);
         rest = match.suffix())
        ids.push_back(match[1]);
    return ids;
}

TEST(Features, EveryOneHasTestsThatExist)
{
    const std::set<std::string> tests = allTests();
    std::set<std::string> ids;
    for (const Feature& feature : features(test::sourceText("tests/features.md"))) {
        EXPECT_TRUE(ids.insert(feature.id).second) << feature.id << " stands twice";
        EXPECT_FALSE(feature.tests.empty()) << feature.id;
        for (const std::string& named : feature.tests)
            EXPECT_TRUE(exists(named, tests)) << feature.id << " names " << named << ", which is no test";
    }
    EXPECT_GT(ids.size(), 50U);
    EXPECT_FALSE(exists("Shape.S5_WasRenamed", tests));
    EXPECT_FALSE(exists("NoSuchSuite.*", tests));
}

TEST(Features, EveryNumberInATestsNameIsALineOfItsList)
{
    std::map<std::string, Feature> list;
    for (const Feature& feature : features(test::sourceText("tests/features.md"))) list.emplace(feature.id, feature);
    for (const std::string& name : allTests())
        for (const std::string& id : idsOf(name))
            if (id.front() != 'H') {  // Those are HardCaseList's.
                EXPECT_TRUE(list.contains(id)) << name << ": tests/features.md has no " << id;
            }
    EXPECT_EQ(idsOf("Scene.S9_S10_TheyIntersect"), (std::vector<std::string>{"S9", "S10"}));
    EXPECT_TRUE(idsOf("AngleSweep.OfH4IsNone").empty());
}

}  // namespace
}  // namespace vitrine
