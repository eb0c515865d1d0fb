#include "render/files/assets.h"
#include "render/files/read_file.h"

#include "tests/exhibits/translated_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace {

using namespace vitrine;

std::vector<std::string> linesOf(const std::string& page)
{
    std::vector<std::string> lines;
    const std::string text = render::readFile(render::asset("pages/" + page), 1U << 20U);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, to - from));
        from = to + 1;
    }
    return lines;
}

std::vector<std::string> allOf(const std::string& text, const char* pattern, int group)
{
    const std::regex searched(pattern);
    return {std::sregex_token_iterator(text.begin(), text.end(), searched, group), std::sregex_token_iterator()};
}

/// Returns headings, tables, figures and links in order, and the counts of marks within sentences, whose order is free.
std::vector<std::string> tagsOf(const std::string& written)
{
    static const std::regex described(" alt=\"[^\"]*\"");
    const std::string line = std::regex_replace(written, described, "");
    std::vector<std::string> tags = allOf(line, "</?(h1|h2|p|ul|li|table|tr|td|th|img|a|head|body)\\b[^>]*>", 0);
    std::vector<std::string> within = allOf(line, "</?(b|i|sub|sup|title)>", 0);
    std::sort(within.begin(), within.end());
    tags.insert(tags.end(), within.begin(), within.end());
    return tags;
}

/// Removes words and functions, which are words in this program, from a formula in MathML.
std::string withoutWords(const std::string& formula)
{
    static const std::regex words("<mtext>[^<]*</mtext>|<mi[^>]*>[A-Za-z]{2,}</mi>");
    return std::regex_replace(formula, words, "");
}

TEST(ShippedPages, AreTheSamePagesInEveryLanguage)
{
    const std::vector<std::string> english = test::filesIn("pages", ".html");
    for (const std::string& language : test::languagesUnder("pages"))
        EXPECT_EQ(test::filesIn("pages/" + language, ".html"), english) << language;
}

TEST(ShippedPages, HaveTheSameFiguresFormulasNumbersAndSourcesInEveryLanguage)
{
    static const std::regex figures("src=\"figures/");
    for (const std::string& language : test::languagesUnder("pages")) {
        for (const std::string& page : test::filesIn("pages", ".html")) {
            const std::vector<std::string> english = linesOf(page), other = linesOf(language + '/' + page);
            ASSERT_EQ(other.size(), english.size()) << language << '/' << page;
            std::size_t formulas = 0;
            for (std::size_t i = 0; i < english.size(); ++i) {
                SCOPED_TRACE(language + '/' + page + ", line " + std::to_string(i + 1));
                EXPECT_EQ(tagsOf(other[i]), tagsOf(std::regex_replace(english[i], figures, "src=\"../figures/")));
                EXPECT_EQ(test::numbersIn(other[i]), test::numbersIn(english[i]));
                if (english[i].find("class=\"formula\"") == std::string::npos) continue;
                EXPECT_EQ(withoutWords(other[i]), withoutWords(english[i]));
                ++formulas;
            }
            if (page != "syllabus.html") {
                EXPECT_GE(formulas, 1U) << page;
            }
        }
    }
}

/// Figures are described in the language of the page, for those who do not see them.
TEST(ShippedPages, DescribeEveryFigureInEveryLanguage)
{
    constexpr const char* described = "<img [^>]* alt=\"([^\"]{20,})\"/>";
    for (const std::string& language : test::languagesUnder("pages")) {
        for (const std::string& page : test::filesIn("pages", ".html")) {
            const std::vector<std::string> english = linesOf(page), other = linesOf(language + '/' + page);
            ASSERT_EQ(other.size(), english.size()) << language << '/' << page;
            for (std::size_t i = 0; i < english.size(); ++i) {
                SCOPED_TRACE(language + '/' + page + ", line " + std::to_string(i + 1));
                const std::vector<std::string> model = allOf(english[i], described, 1);
                const std::vector<std::string> texts = allOf(other[i], described, 1);
                EXPECT_EQ(model.size(), allOf(english[i], "<img\\b", 0).size()) << "a figure without alternative text";
                ASSERT_EQ(texts.size(), model.size()) << "a figure without alternative text";
                for (std::size_t k = 0; k < texts.size(); ++k) EXPECT_NE(texts[k], model[k]);
            }
        }
    }
}

TEST(ShippedPages, ShowEveryDiagram)
{
    const std::vector<std::string> diagrams = test::filesIn("pages/figures", ".svg");
    EXPECT_EQ(diagrams.size(), 5U);
    std::string all;
    for (const std::string& page : test::filesIn("pages", ".html"))
        for (const std::string& line : linesOf(page)) all += line;
    for (const std::string& diagram : diagrams)
        EXPECT_NE(all.find("src=\"figures/" + diagram + '"'), std::string::npos) << diagram;
}

TEST(ShippedPages, SaySomethingElseThanTheEnglishOnesInUtf8)
{
    for (const std::string& language : test::languagesUnder("pages")) {
        for (const std::string& page : test::filesIn("pages", ".html")) {
            const std::vector<std::string> english = linesOf(page), other = linesOf(language + '/' + page);
            std::string all;
            for (std::size_t i = 0; i < std::min(english.size(), other.size()); ++i) {
                all += other[i] + '\n';
                if (english[i].starts_with("<p>") || english[i].starts_with("<h")) {
                    EXPECT_NE(other[i], english[i]) << language << '/' << page << ", line " << i + 1;
                }
            }
            EXPECT_EQ(test::faultOfText(all), "") << language << '/' << page;
        }
    }
}

}  // namespace
