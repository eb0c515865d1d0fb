// Results of scripts. Measured tables in tests/bench/results: each belongs to a command that results.sh lists, and
// names a commit of the history. Pictures of the documents: assets/pictures.sh names presets that exist.

#include "render/files/read_file.h"
#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Returns the standard output of a shell command in the source folder; empty if it fails.
std::string outputOf(const std::string& command)
{
    FILE* pipe = ::popen(("cd '" VITRINE_SOURCE_DIR "' && " + command + " 2>/dev/null").c_str(), "r");
    std::string text;
    std::array<char, 65536> bytes{};
    while (const std::size_t got = pipe ? std::fread(bytes.data(), 1, bytes.size(), pipe) : 0)
        text.append(bytes.data(), got);
    return pipe && ::pclose(pipe) == 0 ? text : std::string();
}

std::set<std::string> resultFiles()
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(VITRINE_SOURCE_DIR) / "tests/bench/results"))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(Results, AreOfCommandsThatCanBeRunAgain)
{
    std::set<std::string> names;
    for (const std::string& line : test::lines(outputOf("sh tests/bench/results.sh --list")))
        names.insert(line.substr(0, line.find(' ')));
    ASSERT_TRUE(names.contains("hall_costs"));
    for (const std::string& file : resultFiles()) {
        EXPECT_TRUE(file.ends_with(".md")) << file << ": results are Markdown";
        EXPECT_TRUE(names.contains(file.substr(0, file.find_first_of("-.")))) << "results.sh makes no " << file;
    }
}

/// Returns the presets that a script of pictures names, as paths.
std::vector<std::string> presetsNamedIn(const std::string& script)
{
    std::vector<std::string> paths;
    for (const std::string& line : test::lines(script)) {
        std::istringstream words(line);
        std::string word, exhibit, size, prefix;
        words >> word >> exhibit >> size >> prefix;
        if (word == "presets")
            while (words >> word) paths.push_back("assets/presets/" + exhibit + '/' + word + ".json");
        static const std::regex path(R"(--preset (assets/presets/[\w/-]+\.json))");
        std::smatch found;
        if (std::regex_search(line, found, path)) paths.push_back(found[1]);
    }
    return paths;
}

TEST(PicturesOfDocuments, AreOfPresetsThatExist)
{
    const fs::path source = VITRINE_SOURCE_DIR;
    const std::vector<std::string> named =
        presetsNamedIn(render::readFile(source / "assets/pictures.sh", std::size_t{1} << 20U));
    EXPECT_GT(named.size(), 20U);
    for (const std::string& path : named) EXPECT_TRUE(fs::exists(source / path)) << path;
    EXPECT_EQ(presetsNamedIn("presets noise 1x1 n- storm wax\npicture a --preset assets/presets/hall/b-c.json --size"),
              (std::vector<std::string>{"assets/presets/noise/storm.json", "assets/presets/noise/wax.json",
                                        "assets/presets/hall/b-c.json"}));
}

TEST(Benchmarks, StayShort)
{
    // A question that is answered loses its case.
    constexpr std::size_t most = 1800;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(VITRINE_SOURCE_DIR) / "tests/bench")) {
        const fs::path extension = entry.path().extension();
        if (extension == ".cpp" || extension == ".h")
            count += test::lines(render::readFile(entry.path(), 1U << 20U)).size();
    }
    EXPECT_GT(count, most / 2);
    EXPECT_LE(count, most) << "lines in tests/bench; remove what is answered";
}

/// Returns the commit that the head of a result names; empty if it names none.
std::string commitOf(const std::string& text)
{
    static const std::regex row(R"(\n\| commit \| ([0-9a-f]{40})[ ,])");
    std::smatch match;
    return std::regex_search(text, match, row) ? match[1].str() : std::string();
}

TEST(Results, NameCommitsOfTheHistory)
{
    EXPECT_EQ(commitOf("# a\n| commit | " + std::string(40, 'a') + " |\n"), std::string(40, 'a'));
    if (outputOf("git rev-parse --is-shallow-repository") != "false\n")
        GTEST_SKIP() << "the history is not at hand: no clone, or a shallow one";
    const std::vector<std::string> commits = test::lines(outputOf("git rev-list HEAD"));
    const std::set<std::string> history(commits.begin(), commits.end());
    ASSERT_FALSE(history.contains(std::string(40, 'a')));
    for (const std::string& file : resultFiles()) {
        const std::string commit = commitOf(test::sourceText("tests/bench/results/" + file));
        EXPECT_TRUE(history.contains(commit))
            << file << " names the commit \"" << commit << "\", which is not in the history: measure it again";
    }
}

}  // namespace
}  // namespace vitrine
