// The lists that map features and stability tests to tests: tests/features.md and tests/stability/README.md.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace vitrine {
namespace {

/// Returns "Suite.Name" of all GoogleTest cases of the project.
std::set<std::string> allTests()
{
    static const std::regex macro(R"(\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    std::set<std::string> tests;
    for (const std::string& file : test::sourceFiles("tests", {".cpp"})) {
        const std::string text = test::withoutComments(test::sourceText(file));
        for (auto match = std::sregex_iterator(text.begin(), text.end(), macro); match != std::sregex_iterator();
             ++match)
            tests.insert((*match)[1].str() + '.' + (*match)[2].str());
    }
    return tests;
}

/// Line "| S5 | description | `Suite.Test`, `Suite.*` |" of a list.
struct Feature {
    std::string id, heldBy;
};

std::vector<Feature> features(const std::string& text)
{
    static const std::regex row(R"(^\| ([A-Z]\d+) \| .+ \| ([^|]*) \|$)");
    std::vector<Feature> list;
    for (const std::string& line : test::lines(text))
        if (std::smatch parts; std::regex_match(line, parts, row)) list.push_back({parts[1], parts[2]});
    return list;
}

bool exists(const std::string& named, const std::set<std::string>& tests)
{
    if (!named.ends_with(".*")) return tests.contains(named);
    const std::string suite = named.substr(0, named.size() - 1);
    return std::any_of(tests.begin(), tests.end(), [&](const std::string& test) { return test.starts_with(suite); });
}

/// Returns the fault of a line's last column, which must name existing tests, or give a reason why there are none;
/// empty if it is correct.
std::string fault(const std::string& heldBy, const std::set<std::string>& tests)
{
    static const std::regex name(R"(`(\w+\.(?:\w+|\*))`)");
    bool named = false;
    for (auto n = std::sregex_iterator(heldBy.begin(), heldBy.end(), name); n != std::sregex_iterator(); ++n) {
        named = true;
        if (!exists((*n)[1], tests)) return "there is no test " + (*n)[1].str();
    }
    const bool reason = heldBy.starts_with("not here: ") || heldBy.starts_with("open: ");
    if (named || (reason && heldBy.size() > 20)) return {};
    return "name a test as `Suite.Name` or `Suite.*`, or write \"not here: \" or \"open: \" and the reason";
}

std::set<std::string> checkedIds(const std::string& list)
{
    const std::set<std::string> tests = allTests();
    std::set<std::string> ids;
    for (const Feature& feature : features(test::sourceText(list))) {
        EXPECT_TRUE(ids.insert(feature.id).second) << feature.id << " stands twice in " << list;
        EXPECT_EQ(fault(feature.heldBy, tests), "") << feature.id << " of " << list;
    }
    return ids;
}

TEST(Features, EveryOneHasTestsThatExist)
{
    EXPECT_GT(checkedIds("tests/features.md").size(), 50U);
}

TEST(Features, EveryHardCaseIsListedWithTestsThatExist)
{
    std::set<std::string> all;
    for (int i = 1; i <= 115; ++i) all.insert('H' + std::to_string(i));
    for (const int neverUsed : {8, 24, 29, 46, 55, 64, 83, 88, 111, 114}) all.erase('H' + std::to_string(neverUsed));
    EXPECT_EQ(checkedIds("tests/stability/README.md"), all);
}

TEST(Features, FaultyRowsAreFound)
{
    const std::set<std::string> tests = {"Fog.IsClear"};
    EXPECT_EQ(fault("`Fog.IsClear`", tests), "");
    EXPECT_EQ(fault("`Fog.*`: of the air", tests), "");
    EXPECT_EQ(fault("not here: nothing of the kind exists", tests), "");
    EXPECT_NE(fault("`Fog.IsClear` `Fog.WasRenamed`", tests), "");
    EXPECT_NE(fault("`Glass.*`", tests), "");
    EXPECT_NE(fault("not here: no", tests), "");
    EXPECT_NE(fault("", tests), "");
}

}  // namespace
}  // namespace vitrine
