#include "exhibits/framework/files/lesson_markup.h"

#include "exhibits/framework/files/tex_formula.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace {

using namespace vitrine;

std::string mathOf(const std::string& tex, bool isDisplayed = false)
{
    const TexFormula made = mathMlOfTex(tex, isDisplayed);
    EXPECT_TRUE(made.problem.empty()) << tex << ": " << made.problem;
    return made.mathMl;
}

TEST(TexFormula, BecomesMathMl)
{
    EXPECT_EQ(mathOf("x^2"), "<math><msup><mi>x</mi><mn>2</mn></msup></math>");
    EXPECT_EQ(mathOf("t_{i+1}"), "<math><msub><mi>t</mi><mrow><mi>i</mi><mo>+</mo><mn>1</mn></mrow></msub></math>");
    EXPECT_EQ(mathOf("x_i^2"), "<math><msubsup><mi>x</mi><mi>i</mi><mn>2</mn></msubsup></math>");
    EXPECT_EQ(mathOf("\\frac{a}{b}"), "<math><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac></math>");
    EXPECT_EQ(mathOf("\\sqrt x"), "<math><msqrt><mi>x</mi></msqrt></math>");
    EXPECT_EQ(mathOf("1.5 < \\pi"), "<math><mn>1.5</mn><mo>&lt;</mo><mi>π</mi></math>");
    EXPECT_EQ(mathOf("\\text{if } -x"), "<math><mtext>if </mtext><mo>−</mo><mi>x</mi></math>");
    EXPECT_EQ(mathOf("\\sin\\left(x\\right)"),
              "<math><mi mathvariant=\"normal\">sin</mi><mo stretchy=\"false\">(</mo><mi>x</mi>"
              "<mo stretchy=\"false\">)</mo></math>");
}

TEST(TexFormula, KeepsBracketsAtTheSizeOfTheText)
{
    // MathML stretches each of these signs by itself.
    const std::vector<std::pair<std::string, std::string>> brackets{
        {"(", "("},       {")", ")"},       {"[", "["},        {"]", "]"},        {"|", "|"},
        {"\\{", "{"},     {"\\}", "}"},     {"\\lfloor", "⌊"}, {"\\rfloor", "⌋"}, {"\\lvert", "|"},
        {"\\rvert", "|"}, {"\\lVert", "‖"}, {"\\rVert", "‖"}};
    for (const auto& [tex, sign] : brackets)
        EXPECT_EQ(mathOf(tex), "<math><mo stretchy=\"false\">" + sign + "</mo></math>") << tex;
    EXPECT_EQ(mathOf("\\le"), "<math><mo>≤</mo></math>");
}

TEST(TexFormula, PutsLimitsBelowAndAboveOnALineOfItsOwn)
{
    EXPECT_EQ(mathOf("\\sum_i^n", true),
              "<math display=\"block\"><munderover><mo>∑</mo><mi>i</mi><mi>n</mi></munderover></math>");
    EXPECT_EQ(mathOf("\\sum_i^n"), "<math><msubsup><mo>∑</mo><mi>i</mi><mi>n</mi></msubsup></math>");
}

TEST(TexFormula, SaysWhereItCannotBeRead)
{
    const auto place = [](std::string_view tex, std::string_view part, std::size_t at) {
        const TexFormula made = mathMlOfTex(tex, false);
        EXPECT_TRUE(made.mathMl.empty()) << tex;
        EXPECT_NE(made.problem.english().find(part), std::string::npos) << tex << ": " << made.problem;
        EXPECT_EQ(made.at, at) << tex;
    };
    place("", "empty", 0);
    place("a + \\foo", "\\foo", 4);
    place("x^", "after ^", 2);
    place("x^2^3", "two of ^", 3);
    place("{a", "not closed", 0);
    place("a}", "without its", 1);
    place("\\frac{a}", "after \\frac", 8);
    place("a ~ b", "the sign ~", 2);
    place("\\text a", "text of this command", 0);
    place(std::string(100, '{'), "nested", 16);
}

TEST(TexFormula, EndsForEveryBeginningOfAFormula)
{
    const std::string whole = "\\sum_{i=0}^{n} \\frac{a_i^2}{\\sqrt{b}} \\le \\text{sum} \\, \\mathbf{v}' \\%";
    EXPECT_FALSE(mathOf(whole).empty());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const TexFormula made = mathMlOfTex(std::string_view(whole).substr(0, size), true);
        EXPECT_NE(made.problem.empty(), made.mathMl.empty()) << size;
        EXPECT_LE(made.at, size);
    }
}

/// A lesson's text as HTML, with its errors.
struct Converted {
    std::string html;
    std::vector<LessonMarkupProblem> problems;
};

Converted converted(const std::string& text, const std::filesystem::path& folder = {})
{
    Converted result;
    result.html = lessonHtml(text,
                             {[](std::string_view name) { return "{" + std::string(name) + "}"; },
                              [](const std::string& file, const std::string& alternative) {
                                  return "<img " + file + "|" + alternative + ">";
                              },
                              folder},
                             &result.problems);
    return result;
}

TEST(LessonMarkup, HasParagraphsListsEmphasisCodeAndParameters)
{
    EXPECT_EQ(converted("One **two**.\n\nSet [row:gap] & go.").html,
              "<p>One <strong>two</strong>.</p>\n<p>Set {gap} &amp; go.</p>\n");
    EXPECT_EQ(converted("- a\n- `b < c`\n").html, "<ul>\n<li>a</li>\n<li><code>b &lt; c</code></li>\n</ul>\n");
    EXPECT_EQ(converted("2. a\n").html, "<ol start=\"2\">\n<li>a</li>\n</ol>\n");
    EXPECT_EQ(converted("```glsl\nfloat a = 1 < 2;\n```").html, "<pre>float a = 1 &lt; 2;\n</pre>\n");
    EXPECT_EQ(converted("$x^2$").html, "<p><math><msup><mi>x</mi><mn>2</mn></msup></math></p>\n");
    EXPECT_EQ(converted("<b onclick=\"x()\">&amp;").html, "<p>&lt;b onclick=&quot;x()&quot;&gt;&amp;</p>\n");
}

TEST(LessonMarkup, LinksToPagesOfTheWebOnly)
{
    EXPECT_EQ(converted("[a](https://a.org/?b=\"&c)").html, "<p><a href=\"https://a.org/?b=&quot;&amp;c\">a</a></p>\n");
    for (const char* url : {"file:///etc/passwd", "javascript:alert(1)", "notes.txt", "row:gap", "ftp://a.org",
                            "HTTPS:evil", "//a.org"}) {
        const Converted bad = converted(std::string("See [a](") + url + ").");
        ASSERT_EQ(bad.problems.size(), 1U) << url;
        EXPECT_EQ(bad.problems[0].at, 8U) << url;
        EXPECT_EQ(bad.html.find("href"), std::string::npos) << bad.html;
    }
}

TEST(LessonMarkup, ShowsPicturesOfItsFolderOnly)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "a.png", "png");
    test::writeBytes(folder / "a.gif", "gif");
    std::filesystem::create_directories(folder / "inner");
    test::writeBytes(folder / "inner/b.png", "png");
    const std::filesystem::path inside = std::filesystem::path(folder / "a.png").parent_path();
    EXPECT_EQ(converted("![A *cone*](a.png)", inside).html, "<p><img a.png|A cone></p>\n");
    for (const std::string name :
         {"b.png", "a.gif", "inner/b.png", "../a.png", "/etc/a.png", "https://a.org/a.png", "inner"}) {
        const Converted bad = converted("![A](" + name + ")", inside);
        ASSERT_EQ(bad.problems.size(), 1U) << name;
        EXPECT_EQ(bad.html.find("<img"), std::string::npos) << bad.html;
        EXPECT_EQ(bad.problems[0].at, 5U);
    }
}

TEST(LessonMarkup, SaysWhereAFormulaIsWrong)
{
    const Converted bad = converted("A.\n\nSo $a + \\foo$.");
    ASSERT_EQ(bad.problems.size(), 1U);
    EXPECT_EQ(bad.problems[0].at, 12U);
    EXPECT_NE(bad.html.find("<code>a + \\foo</code>"), std::string::npos) << bad.html;
}

TEST(LessonShaders, AreLinesOrAFunction)
{
    const std::vector<std::string> exhibits{"sdf_morph"};
    const ShaderPart torus = shaderPart("lib/sdf.glsl sdfTorus", exhibits);
    EXPECT_TRUE(torus.problem.empty()) << torus.problem;
    EXPECT_TRUE(torus.text.starts_with("float sdfTorus(vec3 p")) << torus.text;
    EXPECT_TRUE(torus.text.ends_with("\n}\n")) << torus.text;
    const ShaderPart lines = shaderPart("sdf_morph/field.glsl 10-12", exhibits);
    EXPECT_TRUE(lines.text.starts_with("float fieldDistance(vec3 p)\n{\n")) << lines.text;
    for (const auto& [words, part] : std::vector<std::pair<std::string, std::string>>{
             {"furr/a.glsl 1-2", "there is no exhibit \"furr\""},
             {"sdf_morph/fild.glsl 1-2",
              "there is no shader \"sdf_morph/fild.glsl\"; did you mean sdf_morph/field.glsl?"},
             {"../secret 1-2", "there is no exhibit"},
             {"lib/../../README.md 1-2", "there is no shader"},
             {"lib/../lib/sdf.glsl sdfTorus", "there is no shader"},
             {"lib 1-2", "there is no shader \"lib\""},
             {"sdf_morph/ 1-2", "there is no shader"},
             {"lib/sdf.glsl", "no lines and no function"},
             {"lib/sdf.glsl nothing", "no lines and no function"},
             {"lib/sdf.glsl 0-3", "no lines"},
             {"lib/sdf.glsl 5-3", "no lines"},
             {"lib/sdf.glsl 1-99999", "no lines"},
             {"lib/sdf.glsl 1-40", "these are 40 lines"}}) {
        const ShaderPart bad = shaderPart(words, exhibits);
        EXPECT_TRUE(bad.text.empty()) << words;
        EXPECT_NE(bad.problem.english().find(part), std::string::npos) << words << ": " << bad.problem;
    }
}

}  // namespace
