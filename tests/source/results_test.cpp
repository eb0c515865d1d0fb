// What is in tests/bench/results was made by tests/bench/results.sh and not touched since, and what the READMEs say was
// measured stands there, word for word.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

const std::string results = "tests/bench/results/";

struct Entry {
    bool drawn = false;
    std::string command;
};

/// What `results.sh --list` says of each name.
const std::map<std::string, Entry>& entries()
{
    static const std::map<std::string, Entry> all = [] {
        std::map<std::string, Entry> found;
        FILE* pipe = ::popen("sh '" VITRINE_SOURCE_DIR "/tests/bench/results.sh' --list", "r");
        std::string text;
        std::array<char, 4096> bytes{};
        while (const std::size_t got = pipe ? std::fread(bytes.data(), 1, bytes.size(), pipe) : 0)
            text.append(bytes.data(), got);
        if (pipe) ::pclose(pipe);
        for (const std::string& line : test::lines(text)) {
            std::istringstream words(line);
            std::string name, kind, command;
            words >> name >> kind >> std::ws;
            std::getline(words, command);
            if (!command.empty()) found[name] = {kind == "gl", command};
        }
        return found;
    }();
    return all;
}

/// As the program cksum has it (POSIX): a checksum and the number of bytes.
std::string cksum(const std::string& text)
{
    std::uint32_t crc = 0;
    const auto add = [&crc](std::uint32_t byte) {
        crc ^= byte << 24;
        for (int bit = 0; bit < 8; ++bit) crc = crc & 0x80000000U ? (crc << 1) ^ 0x04C11DB7U : crc << 1;
    };
    for (const char c : text) add(static_cast<unsigned char>(c));
    for (std::size_t length = text.size(); length > 0; length >>= 8) add(length & 0xFF);
    return std::to_string(~crc) + ' ' + std::to_string(text.size());
}

/// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5" is llvmpipe, "NVIDIA H200/PCIe/SSE2, 4.6" is nvidia-h200.
std::string slug(const std::string& renderer)
{
    std::string name;
    for (const char c : renderer.substr(0, renderer.find_first_of("(,/"))) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    if (!name.empty() && name.back() == '-') name.pop_back();
    return name;
}

/// A file of results, taken apart.
struct Result {
    std::string title;
    std::map<std::string, std::string> head;
    std::string output;
};

Result parsed(const std::string& text)
{
    Result result;
    const std::size_t end = text.find("\n---\n");
    static const std::regex row(R"(\| ([a-z ]+) \| (.*) \|)");
    for (const std::string& line : test::lines(text.substr(0, end))) {
        std::smatch match;
        if (line.rfind("# ", 0) == 0) result.title = line.substr(2);
        if (std::regex_match(line, match, row)) result.head[match[1]] = match[2];
    }
    if (end == std::string::npos) return result;
    result.output = text.substr(end + 5);
    const std::string fence = "```\n";
    if (result.output.rfind(fence, 0) == 0 && result.output.size() >= 2 * fence.size() &&
        result.output.substr(result.output.size() - fence.size()) == fence)
        result.output = result.output.substr(fence.size(), result.output.size() - 2 * fence.size());
    return result;
}

/// Why a file of this name with this text is not the unedited output of a command of the list; empty when it is.
std::string complaint(const std::string& file, const std::string& text)
{
    const Result result = parsed(text);
    static const std::map<std::string, std::regex> form{
        {"command", std::regex("`.+`")},
        {"commit", std::regex("[0-9a-f]{40}(, with uncommitted changes)?")},
        {"date", std::regex(R"(\d{4}-\d\d-\d\d \d\d:\d\d UTC)")},
        {"renderer", std::regex(".+")},
        {"processor", std::regex(R"(.+, \d+ threads)")},
        {"load before", std::regex(R"(\d+\.\d+)")},
        {"memcpy", std::regex(R"(\d+\.\d GB/s before, \d+\.\d GB/s after)")},
        {"took", std::regex(R"(\d+ s)")},
        {"output", std::regex(R"(cksum \d+ \d+)")},
    };
    for (const auto& [name, pattern] : form)
        if (const auto row = result.head.find(name);
            row == result.head.end() || !std::regex_match(row->second, pattern))
            return "its head does not say the " + name;
    const auto entry = entries().find(result.title);
    if (entry == entries().end()) return "results.sh knows no " + result.title;
    const std::string name = entry->second.drawn ? result.title + '-' + slug(result.head.at("renderer")) : result.title;
    if (file != name + ".md") return "its name should be " + name + ".md";
    if (result.head.at("command") != '`' + entry->second.command + '`')
        return "its command is not that of results.sh: " + entry->second.command;
    if (result.head.at("output") != "cksum " + cksum(result.output))
        return "its output is not what the command printed";
    return {};
}

std::set<std::string> resultFiles()
{
    std::set<std::string> names;
    const fs::path folder = fs::path(VITRINE_SOURCE_DIR) / results;
    if (!fs::exists(folder)) return names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
}

TEST(Results, AreTheUneditedOutputOfOneCommandEach)
{
    ASSERT_FALSE(entries().empty());
    std::set<std::string> measured;
    std::set<std::string> rest = resultFiles();
    for (const std::string& file : resultFiles()) {
        if (fs::path(file).extension() != ".md") continue;
        const std::string text = test::sourceText(results + file);
        EXPECT_EQ(complaint(file, text), "") << file;
        const Result result = parsed(text);
        measured.insert(result.title);
        rest.erase(file);
    }
    EXPECT_EQ(rest, std::set<std::string>{}) << "are of no command";
    std::string missing;
    for (const auto& [name, entry] : entries())
        if (!measured.contains(name)) missing += ' ' + name;
    if (!missing.empty())
        GTEST_SKIP() << "not measured since the last change of what they measure: sh tests/bench/results.sh" << missing;
}

TEST(Results, WouldBeRefusedIfTheyWereEdited)
{
    EXPECT_EQ(cksum("123456789"), "930766865 9");  // As coreutils prints it.
    EXPECT_EQ(slug("NVIDIA H200/PCIe/SSE2, 4.6"), "nvidia-h200");
    const std::string output = "| what | ms |\n";
    const std::string head = "# hall_costs\n\n| command | `build/release/tests/bench_hall_costs` |\n| commit | " +
                             std::string(40, 'a') +
                             " |\n| date | 2026-01-01 00:00 UTC |\n| renderer | llvmpipe (LLVM 15), 4.5 |\n| processor "
                             "| A, 2 threads |\n| load before | 0.10 |\n"
                             "| memcpy | 9.1 GB/s before, 9.0 GB/s after |\n| took | 9 s |\n";
    const std::string good = head + "| output | cksum " + cksum(output) + " |\n\n---\n" + output;
    ASSERT_EQ(complaint("hall_costs-llvmpipe.md", good), "");
    EXPECT_NE(complaint("hall_costs.md", good), "");
    EXPECT_NE(complaint("hall_costs-llvmpipe.md", good + "the quietest run\n"), "");
    for (const char* line : {"| commit |", "| load before |", "| memcpy |", "| command |"}) {
        std::string without = good;
        without.replace(without.find(line), 2, "");
        EXPECT_NE(complaint("hall_costs-llvmpipe.md", without), "") << line;
    }
    for (const char* command : {"bench_nothing`", "bench_hall_costs --rounds 1`"})
        EXPECT_NE(
            complaint("hall_costs-llvmpipe.md", std::regex_replace(good, std::regex("bench_hall_costs`"), command)), "")
            << command;
}

/// What `git ARGUMENTS` prints in the source folder; empty where it fails.
std::string gitPrints(const std::string& arguments)
{
    FILE* pipe = ::popen(("git -C '" VITRINE_SOURCE_DIR "' " + arguments + " 2>/dev/null").c_str(), "r");
    std::string text;
    std::array<char, 65536> bytes{};
    while (const std::size_t got = pipe ? std::fread(bytes.data(), 1, bytes.size(), pipe) : 0)
        text.append(bytes.data(), got);
    return pipe && ::pclose(pipe) == 0 ? text : std::string();
}

TEST(Results, NameCommitsOfTheHistory)
{
    if (gitPrints("rev-parse --is-shallow-repository") != "false\n")
        GTEST_SKIP() << "the history is not at hand: no clone, or a shallow one";
    const std::vector<std::string> commits = test::lines(gitPrints("rev-list HEAD"));
    const std::set<std::string> history(commits.begin(), commits.end());
    ASSERT_FALSE(history.contains(std::string(40, 'a')));
    for (const std::string& file : resultFiles()) {
        if (fs::path(file).extension() != ".md") continue;
        const std::string commit = parsed(test::sourceText(results + file)).head["commit"].substr(0, 40);
        EXPECT_TRUE(history.contains(commit))
            << file << " names the commit " << commit << ", which is not in the history: measure it again";
    }
}

TEST(Results, ArePrintedByProgramsThatExist)
{
    for (const auto& [name, entry] : entries()) {
        std::smatch bench;
        if (std::regex_search(entry.command, bench, std::regex(R"(tests/bench_(\w+))"))) {
            EXPECT_TRUE(fs::exists(fs::path(VITRINE_SOURCE_DIR) / "tests/bench" / (bench[1].str() + ".cpp")))
                << entry.command;
        } else if (std::smatch script;
                   std::regex_match(entry.command, script, std::regex(R"(sh (tests/bench/\w+\.sh))"))) {
            EXPECT_TRUE(fs::exists(fs::path(VITRINE_SOURCE_DIR) / script[1].str())) << entry.command;
        } else {
            EXPECT_TRUE(entry.command.find("build/release/vitrine study ") == 0 ||
                        entry.command.find("ctest ") != std::string::npos)
                << entry.command;
        }
    }
}

/// The lines between <!-- from FILE "SECTION" "START"... --> and <!-- end --> of a README, and what should stand there.
struct Excerpt {
    int line = 0;
    std::string given, wanted;
    bool measured = true;  ///< The file exists; where it does not, nothing may stand there.
};

std::vector<Excerpt> excerptsOf(const std::string& text)
{
    std::vector<Excerpt> found;
    static const std::regex marker(R"re(<!-- from (\S+)((?: "[^"]+")+) -->)re");
    static const std::regex quoted("\"([^\"]+)\"");
    bool inside = false;
    int number = 0;
    for (const std::string& line : test::lines(text)) {
        ++number;
        std::smatch match;
        if (line == "<!-- end -->") {
            inside = false;
        } else if (std::regex_match(line, match, marker)) {
            inside = true;
            found.push_back({number, "", "", fs::exists(fs::path(VITRINE_SOURCE_DIR) / match[1].str())});
            if (!found.back().measured) continue;
            const std::string words = match[2];
            std::vector<std::string> starts;
            for (auto word = std::sregex_iterator(words.begin(), words.end(), quoted); word != std::sregex_iterator();
                 ++word)
                starts.push_back((*word)[1]);
            std::string section;
            if (starts.front().front() == '#') {
                section = starts.front();
                starts.erase(starts.begin());
            }
            bool within = section.empty();
            for (const std::string& source : test::lines(test::sourceText(match[1]))) {
                if (!section.empty() && source.rfind('#', 0) == 0) within = source == section;
                if (within && std::any_of(starts.begin(), starts.end(),
                                          [&](const std::string& start) { return source.rfind(start, 0) == 0; }))
                    found.back().wanted += source + '\n';
            }
        } else if (inside) {
            found.back().given += line + '\n';
        }
    }
    EXPECT_FALSE(inside) << "an excerpt has no end";
    return found;
}

std::vector<std::string> readmes()
{
    std::vector<std::string> files{"README.md", "tests/bench/README.md"};
    for (const std::string& file : test::sourceFiles("exhibits", {".md"})) files.push_back(file);
    return files;
}

TEST(Readme, MeasuredNumbersStandInTheResultsWordForWord)
{
    std::size_t excerpts = 0;
    for (const std::string& file : readmes()) {
        for (const Excerpt& excerpt : excerptsOf(test::sourceText(file))) {
            ++excerpts;
            EXPECT_EQ(excerpt.wanted.empty(), !excerpt.measured) << file << ':' << excerpt.line << " finds nothing";
            EXPECT_EQ(excerpt.given, excerpt.wanted)
                << file << ':' << excerpt.line << ": run sh tests/bench/results.sh readme";
        }
    }
    EXPECT_GT(excerpts, 10U);
}

/// Lines of prose that give a measured number: of a time, of memory, of an error, or how many times something is of
/// another.
std::vector<std::string> measuredLines(const std::string& text)
{
    static const std::regex measured(
        R"(\d ?(ms|µs|MB|GB|MPixel/s)\b|\b\d+\.\d+ times\b|\b(errs? by|off by|RMSE of|error of|costs|takes?|took) (about )?\d+(\.\d+)?(?![.\d]| (samples|steps|minutes|hours?|places?|texels)))");
    std::vector<std::string> found;
    bool inside = false;
    for (const std::string& line : test::lines(text)) {
        if (line.rfind("<!-- from ", 0) == 0) inside = true;
        if (line == "<!-- end -->") inside = false;
        if (!inside && line.rfind("| `", 0) != 0 && std::regex_search(line, measured)) found.push_back(line);
    }
    return found;
}

TEST(Readme, HasNoMeasuredNumberThatStandsInNoResult)
{
    for (const std::string& file : readmes())
        for (const std::string& line : measuredLines(test::sourceText(file)))
            ADD_FAILURE() << file << ": " << line
                          << "\nPrint it with a bench, and take it over between <!-- from --> and <!-- end -->.";
    EXPECT_EQ(measuredLines("the beams took 47 ms to march").size(), 1U);
    EXPECT_EQ(measuredLines("halving the error costs 2.03 times the steps").size(), 1U);
    EXPECT_EQ(measuredLines("fins errs by 0.142").size(), 1U);
    EXPECT_EQ(measuredLines("<!-- from a \"b\" -->\nit took 47 ms\n<!-- end -->").size(), 0U);
    EXPECT_EQ(
        measuredLines("640 x 360, 16 views, a sun of 2.9 degrees; one takes 16 samples, the whole takes 10 minutes")
            .size(),
        0U);
}

}  // namespace
}  // namespace vitrine
