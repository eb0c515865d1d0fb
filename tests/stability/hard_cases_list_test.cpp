// That README.md beside this file says of every hard case what holds it, and that what it says is there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path root(VITRINE_SOURCE_DIR);

std::string textOf(const fs::path& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The cases that this list must have: 1 to 115, without those numbers that were never given out.
std::set<int> numbers()
{
    std::set<int> all;
    for (int i = 1; i <= 115; ++i) all.insert(i);
    for (const int never : {8, 24, 29, 46, 55, 64, 83, 88, 111, 114}) all.erase(never);
    return all;
}

/// Every test of the project by the numbers in its name: "Normals.H53_StayAccurateFarAway" under 53.
std::map<int, std::set<std::string>> numberedTests(const std::string& source)
{
    static const std::regex test(R"(\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    static const std::regex number(R"((?:^|_)H(\d+)(?=_))");
    std::map<int, std::set<std::string>> found;
    for (auto t = std::sregex_iterator(source.begin(), source.end(), test); t != std::sregex_iterator(); ++t) {
        const std::string name = (*t)[2];
        for (auto n = std::sregex_iterator(name.begin(), name.end(), number); n != std::sregex_iterator(); ++n)
            found[std::stoi((*n)[1])].insert((*t)[1].str() + '.' + name);
    }
    return found;
}

std::map<int, std::set<std::string>> allNumberedTests()
{
    std::map<int, std::set<std::string>> all;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
        if (entry.path().extension() != ".cpp" || entry.path().filename() == "hard_cases_list_test.cpp") continue;
        for (const auto& [number, names] : numberedTests(textOf(entry.path())))
            all[number].insert(names.begin(), names.end());
    }
    return all;
}

std::set<std::string> allTests()
{
    std::set<std::string> all;
    static const std::regex test(R"(\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string source = textOf(entry.path());
        for (auto t = std::sregex_iterator(source.begin(), source.end(), test); t != std::sregex_iterator(); ++t)
            all.insert((*t)[1].str() + '.' + (*t)[2].str());
    }
    return all;
}

/// What is wrong with the row of one case, or nothing. `heldBy` is the row's last column, `tests` are all that there
/// are and `numbered` those that bear the case's number.
std::string fault(const std::string& heldBy, const std::set<std::string>& tests, const std::set<std::string>& numbered,
                  const fs::path& project)
{
    static const std::regex name(R"(`(\w+\.\w+)`)");
    static const std::regex later(R"(^with `([\w/]+(?:_test\.cpp)?)`: )");
    std::smatch with;
    const bool awaited = std::regex_search(heldBy, with, later);
    if (awaited && !fs::exists(project / with[1].str())) return {};
    bool named = false;
    for (auto n = std::sregex_iterator(heldBy.begin(), heldBy.end(), name); n != std::sregex_iterator(); ++n) {
        named = true;
        if (!tests.contains((*n)[1])) return "there is no test " + (*n)[1].str() + " (any more)";
        if (!numbered.contains((*n)[1])) return (*n)[1].str() + " does not bear the number of this case";
    }
    if (named) return {};
    if (awaited) return with[1].str() + " is there: name the tests of this case";
    if ((heldBy.starts_with("not here: ") || heldBy.starts_with("open: ")) && heldBy.size() > 20)
        return numbered.empty() ? std::string()
                                : "it says that nothing holds it, but " + *numbered.begin() + " bears this number";
    return "say which `Test.Name` holds it, \"with `where its tests will be`: \", or \"not here: \" or \"open: \" and "
           "why";
}

TEST(HardCaseList, HasEveryCaseOnceAndWhatItSaysIsThere)
{
    const auto numbered = allNumberedTests();
    const auto tests = allTests();
    static const std::regex row(R"(^\| H(\d+) \| (.+) \| (.+) \|$)");
    std::stringstream table(textOf(root / "tests/stability/README.md"));
    std::set<int> seen;
    for (std::string line; std::getline(table, line);) {
        std::smatch columns;
        if (!std::regex_match(line, columns, row)) continue;
        const int number = std::stoi(columns[1]);
        EXPECT_TRUE(seen.insert(number).second) << "H" << number << " stands twice";
        const auto bearing = numbered.find(number);
        EXPECT_EQ(fault(columns[3], tests, bearing == numbered.end() ? std::set<std::string>() : bearing->second, root),
                  "")
            << "H" << number;
    }
    EXPECT_EQ(seen, numbers());
    for (const auto& [number, names] : numbered)
        EXPECT_TRUE(numbers().contains(number)) << *names.begin() << " bears a number that no case has";
}

TEST(HardCaseList, FaultyRowsAreSeen)
{
    const auto numbered = numberedTests("TEST(Fog, H66_IsClear)\nTEST_F(Glass, S14_H93_IsNotThere)");
    EXPECT_EQ(numbered.at(66), std::set<std::string>{"Fog.H66_IsClear"});
    EXPECT_EQ(numbered.at(93), std::set<std::string>{"Glass.S14_H93_IsNotThere"});
    const std::set<std::string>& fog = numbered.at(66);
    EXPECT_EQ(fault("`Fog.H66_IsClear`", fog, fog, root), "");
    EXPECT_NE(fault("`Fog.H66_WasRenamed`", fog, fog, root), "");
    EXPECT_NE(fault("`Fog.H66_IsClear`", fog, {}, root), "") << "it bears another number";
    EXPECT_NE(fault("not here: nothing of the kind exists", fog, fog, root), "");
    EXPECT_NE(fault("open: nobody knows how, up to now", fog, fog, root), "");
    EXPECT_NE(fault("not here: no", {}, {}, root), "");
    EXPECT_NE(fault("with `tests/render`: `Fog.IsGone`", fog, {}, root), "");
    EXPECT_NE(fault("with `tests/render`: ", fog, {}, root), "");
    EXPECT_EQ(fault("with `tests/nothing_of_the_kind`: `Fog.WillBeClear`", fog, {}, root), "");
    EXPECT_NE(fault("", fog, fog, root), "");
}

}  // namespace
