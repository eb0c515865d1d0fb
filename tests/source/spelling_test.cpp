// One spelling, the American one, in code, comments and what people read.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {
namespace {

/// The word's first letters, then the rest: put together only here, so that this file does not find itself.
const std::vector<std::pair<std::string, std::string>> british{
    {"col", "our"},     {"neigh", "bour"}, {"behav", "iour"},   {"fav", "our"},    {"gr", "ey"},
    {"met", "re"},      {"cent", "re"},    {"fib", "re"},       {"theat", "re"},   {"lit", "re"},
    {"lic", "ence"},    {"def", "ence"},   {"cance", "lled"},   {"trave", "lled"}, {"labe", "lled"},
    {"marve", "llous"}, {"norma", "lise"}, {"initia", "lise"},  {"optim", "ise"},  {"visua", "lise"},
    {"recogn", "ise"},  {"organ", "ise"},  {"synchron", "ise"}, {"ana", "lyse"},   {"cata", "logue"},
    {"mou", "lding"},   {"arte", "fact"},  {"draug", "ht"},     {"ker", "b "},     {"alumin", "ium"},
    {"mis", "spelt"},   {"whil", "st "},   {"initia", "lising"}};

/// The first British word of a text; empty: none.
std::string britishWord(std::string text)
{
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [first, rest] : british) {
        std::string word = first + rest;
        if (text.find(word) != std::string::npos) return word;
    }
    return {};
}

TEST(Spelling, IsAmerican)
{
    const std::vector<std::string> extensions{".h",  ".cpp", ".glsl", ".vert", ".frag", ".comp",
                                              ".py", ".md",  ".txt",  ".sh",   ".cmake"};
    for (const char* folder : {"app", "assets", "exhibits", "render", "shaders", "tests", "ui"})
        for (const std::string& file : test::sourceFiles(folder, extensions)) {
            if (file.starts_with("tests/bench/results/")) continue;  // Output of programs of their time.
            int number = 0;
            for (const std::string& line : test::lines(test::sourceText(file))) {
                ++number;
                EXPECT_EQ(britishWord(line), "") << file << ':' << number;
            }
        }
}

TEST(SpellingControl, TheOtherOneIsSeen)
{
    for (const auto& [first, rest] : british) EXPECT_EQ(britishWord("A " + first + rest + ' '), first + rest);
    EXPECT_EQ(britishWord("the color of a neighbor, 3 meters from the center"), "");
}

}  // namespace
}  // namespace vitrine
