// A function is read at once: none is longer than a page.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace vitrine {
namespace {

constexpr std::size_t mostLines = 60;  ///< From the first line of the signature to the closing brace.

struct Function {
    std::string signature;  ///< Its first line.
    std::size_t line = 0;   ///< From 1.
    std::size_t lines = 0;
};

/// Whether a line before a body belongs to its signature: not empty, not the end or label of something else.
bool isSignature(const std::string& line)
{
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) return false;
    const std::string text = line.substr(first);
    return text.rfind("//", 0) != 0 && text.front() != '}' && text.front() != '#' &&
           std::string(";}{").find(text.back()) == std::string::npos &&
           !(text.back() == ':' && text.find('(') == std::string::npos);
}

/// As clang-format lays them out here: a brace on a line of its own opens the body of a function, and one with the same
/// indent closes it.
std::vector<Function> functionsIn(const std::string& text)
{
    const std::vector<std::string> lines = test::lines(text);
    std::vector<Function> functions;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::size_t indent = lines[i].find_first_not_of(' ');
        if (indent == std::string::npos || lines[i].substr(indent) != "{") continue;
        const std::string closing = std::string(indent, ' ') + '}';
        std::size_t end = i;
        while (end < lines.size() && lines[end].rfind(closing, 0) != 0) ++end;
        std::size_t begin = i;
        while (begin > 0 && isSignature(lines[begin - 1])) --begin;
        functions.push_back({lines[begin], begin + 1, end - begin + 1});
    }
    return functions;
}

TEST(Functions, AreNoLongerThanAPage)
{
    std::size_t all = 0;
    for (const char* folder : {"app", "ui", "exhibits", "render"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions))
            for (const Function& function : functionsIn(test::sourceText(file))) {
                ++all;
                EXPECT_LE(function.lines, mostLines) << file << ':' << function.line << ": " << function.signature;
            }
    EXPECT_GT(all, 1000U);  // The layout is still the one that is looked for.
}

TEST(FunctionsControl, LongOnesAreSeen)
{
    std::string body;
    for (int i = 0; i < 70; ++i) body += "        call();\n";
    for (const std::string& start :
         {std::string("void f(int a,\n       int b)\n{\n"), std::string("    void g()\n    {\n")}) {
        const std::string close = start.front() == ' ' ? "    }\n" : "}\n";
        const std::vector<Function> found = functionsIn("\n" + start + body + close + "\nvoid h()\n{\n}\n");
        ASSERT_EQ(found.size(), 2U);
        EXPECT_GT(found[0].lines, 70U);
        EXPECT_EQ(found[1].lines, 3U);
    }
}

}  // namespace
}  // namespace vitrine
