#include "exhibits/framework/files/lesson.h"

#include "exhibits/hall/hall_table.h"

#include "tests/exhibits/framework/table/every_kind.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace {

using namespace vitrine;

const std::string lessonHead = "# Title\n\n```json\n{\"format\": \"vitrine-lesson\", \"version\": 1, \"exhibit\": "
                               "\"everything\"}\n```\n\nAn **introduction**.\n\n";

const NamedValues& lessonTables()
{
    static const hall::HallTable hall;
    static const NamedValues tables{{"hall", hall.initial()}, {"everything", test::everyKind.initial()}};
    return tables;
}

Lesson lessonOf(const std::string& text)
{
    return parseLesson(text, "a.md", lessonTables());
}

/// Returns a lesson with one step, whose heading is in line 9 and whose block begins in line 13.
std::string oneStep(const std::string& block, const std::string& text = "See this.")
{
    return lessonHead + "## First\n\n" + text + "\n```json\n" + block + "\n```\n";
}

TEST(Lesson, MayStartWithAByteOrderMark)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "a.md", "\xEF\xBB\xBF" + oneStep("{\"camera\": \"best\"}"));
    EXPECT_EQ(readLesson(folder / "a.md", lessonTables()).title, "Title");
}

TEST(Lesson, HasATitleAnIntroductionAndSteps)
{
    const Lesson lesson = lessonOf(oneStep(R"({"values": {"gap": 0.25}, "hall": {"exposure": 1.5}})") +
                                   "## Second\nMore.\n\nAnd more.\n```json\n{\"camera\": \"best\"}\n```\n");
    EXPECT_EQ(lesson.title, "Title");
    EXPECT_EQ(lesson.exhibit, "everything");
    EXPECT_EQ(lesson.intro, "An **introduction**.");
    ASSERT_EQ(lesson.steps.size(), 2U);
    const LessonStep &first = lesson.steps[0], &second = lesson.steps[1];
    EXPECT_EQ(first.title, "First");
    EXPECT_EQ(first.text, "See this.");
    EXPECT_EQ(first.line, 9);
    EXPECT_EQ(first.values[test::everyKind.gap], 0.25);
    const hall::HallTable hall;
    ASSERT_EQ(first.hall.size(), 1U);
    EXPECT_EQ(first.hall[0].first, hall.exposure.row);
    EXPECT_EQ(std::get<double>(first.hall[0].second), 1.5);
    EXPECT_FALSE(first.bestView || first.camera || first.read);
    EXPECT_EQ(second.text, "More.\n\nAnd more.");
    EXPECT_TRUE(second.bestView);
    EXPECT_TRUE(second.values == test::everyKind.initial()) << "a step does not depend on the one before";
    EXPECT_TRUE(lesson.notes.empty());
}

TEST(Lesson, NamesNumbersToRead)
{
    const auto read = [](const std::string& what) {
        return *lessonOf(oneStep(R"({"read": ")" + what + "\"}")).steps[0].read;
    };
    EXPECT_EQ(read("milliseconds").of, LessonNumber::Of::milliseconds);
    EXPECT_EQ(read("row:gap").of, LessonNumber::Of::row);
    EXPECT_EQ(read("row:hall.exposure").name, "hall.exposure");
    EXPECT_EQ(read("counter:marchSteps").name, "marchSteps");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"read": "row:gpa"})")), "line 13, read: there is no parameter \"gpa\"");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"read": 3})")), "line 13, read: write \"milliseconds\"");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"read": "counter:a b"})")), "line 13, read: write");
}

TEST(Lesson, SaysRowsByTheirLabels)
{
    const Lesson lesson = lessonOf(oneStep("{}", "Set [row:gap] and [row:hall.exposure]."));
    const std::string& text = lesson.steps[0].text;
    EXPECT_EQ(withLabels(text, "everything", lessonTables(), "<b>", "</b>"),
              "Set <b>" + label(test::everyKind.rows()[test::everyKind.gap.row]) + "</b> and <b>Exposure</b>.");
    EXPECT_EQ(withLabels("[row:", "everything", lessonTables(), "<", ">"), "[row:");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "Set [row:gpa].")), "a.md, line 9: in the text below this heading there "
                                                              "is no parameter \"gpa\"; `vitrine list --manual "
                                                              "everything`");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "Set [row:hall.gpa].")), "`vitrine list --manual hall`");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "Set [row:gap")), "line 9");
}

TEST(Lesson, KnowsThePicturesOfItsTexts)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "cone.png", "PNG");
    test::writeBytes(folder / "ball.jpg", "JPEG");
    std::string text =
        oneStep("{}", "See ![a cone](cone.png), ![again](cone.png).\n\n### Try\n![A ball](ball.jpg) rolls.");
    const Lesson lesson = parseLesson(text, folder / "a.md", lessonTables());
    EXPECT_EQ(lesson.pictures, (std::set<std::string>{"ball.jpg", "cone.png"}));
    EXPECT_TRUE(lessonOf(oneStep("{}")).pictures.empty());
}

TEST(Lesson, RefusalsCarryTheirPlace)
{
    const auto placeOf = [](const std::string& lesson) {
        try {
            static_cast<void>(lessonOf(lesson));
        } catch (const Failure& failure) {
            return failure.place();
        }
        return FilePlace{"none"};
    };
    const FilePlace block = placeOf(oneStep("{\"values\":\n{\"gap\": \"long\"}}"));
    EXPECT_EQ(block.file, "a.md");
    EXPECT_EQ(block.line, 14);
    EXPECT_EQ(block.key, "values.gap");
    const FilePlace formula = placeOf(oneStep("{}", "So:\n$a + \\foo$"));
    EXPECT_EQ(formula.file, "a.md");
    EXPECT_EQ(formula.line, 12);
    EXPECT_EQ(formula.column, 6);
    EXPECT_EQ(formula.key, "");
    EXPECT_EQ(placeOf("Text.").line, 1);
}

TEST(Lesson, RefusalsNameFileLineKeyAndWhatToDo)
{
    EXPECT_FAILURE(lessonOf(oneStep(R"({"values": {"gpa": 1}})")),
                   "a.md, line 13, values.gpa: there is no parameter \"gpa\"; `vitrine list --manual everything`");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"hall": {"exposre": 1}})")), "line 13, hall.exposre: there is no parameter");
    EXPECT_FAILURE(lessonOf(oneStep("{\"values\":\n{\"gap\": \"long\"}}")), "a.md, line 14, values.gap: this must "
                                                                            "be a number");
    EXPECT_FAILURE(lessonOf(oneStep("{\"values\":\n{\"gap\": 1,}}")), "line 14");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"valeus": {}})")), "line 13, valeus: this key is not known here");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"values": 3})")), "line 13, values: this must be an object");
    EXPECT_FAILURE(lessonOf(oneStep("[]")), "line 9: its block must be an object");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"camera": "nice"})")), "line 13, camera: this must be \"best\"");
    EXPECT_FAILURE(lessonOf(oneStep(R"({"camera": {"eye": 3}})")), "line 13, camera.eye");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "")), "line 9: this step has no text");
    EXPECT_FAILURE(lessonOf(oneStep("{}", std::string(mostLessonLetters + 1, 'x'))), "line 9: the text below");
    EXPECT_FAILURE(lessonOf(oneStep("{}") + "```json\n{}\n```"),
                   "line 15: there is a block under this heading already");
    EXPECT_FAILURE(lessonOf(lessonHead + "## First\nText."), "line 9: this step has no preset");
    EXPECT_FAILURE(lessonOf(lessonHead + "## First\nText.\n```yaml\n"), "line 11: this block is not closed");
    EXPECT_FAILURE(lessonOf(lessonHead + "## First\nText.\n```json\n{}"), "line 11: this block is not closed");
    EXPECT_FAILURE(lessonOf(lessonHead + "# Another\n"), "line 9: a lesson has one title");
    EXPECT_FAILURE(lessonOf(lessonHead), "line 1: there is no step in it");
    EXPECT_FAILURE(lessonOf("## First\n"), "line 1: a lesson begins with its title");
    EXPECT_FAILURE(lessonOf("Hello.\n# Title\n"), "line 1: a lesson begins with its title");
    EXPECT_FAILURE(lessonOf(""), "line 1: a lesson begins with its title");
    EXPECT_FAILURE(lessonOf("# Title\n## First\n"),
                   "line 1: the block that names the exhibit of the lesson is missing");
    std::string many = lessonHead;
    for (std::size_t i = 0; i <= mostLessonSteps; ++i) many += "## Step\nText.\n```json\n{}\n```\n";
    EXPECT_FAILURE(lessonOf(many), "a lesson has at most 24 steps");
}

TEST(Lesson, MayHoldListsCodeAndFormulas)
{
    const std::string text = "A $x^2$:\n\n- one\n  - inner\n\n```\n## no heading\n  ### none\n```\n\nEnd.";
    EXPECT_EQ(lessonOf(oneStep("{}", text)).steps[0].text, text);
    const std::string shader = lessonOf(oneStep("{}", "```glsl lib/sdf.glsl sdfTorus\n```\nAnd.")).steps[0].text;
    EXPECT_TRUE(shader.starts_with("```glsl lib/sdf.glsl sdfTorus\nfloat sdfTorus(")) << shader;
    EXPECT_TRUE(shader.ends_with("}\n```\nAnd.")) << shader;
}

TEST(Lesson, BadLinksPicturesFormulasAndShadersAreNamedWithLineAndColumn)
{
    EXPECT_FAILURE(lessonOf(oneStep("{}", "Text.\n\nSee [a](file:///etc/passwd).")),
                   "a.md, line 13, column 9: the link \"file:///etc/passwd\"");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "![A](none.png)")),
                   "a.md, line 11, column 6: there is no picture \"none.png\"");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "So:\n$a + \\foo$")), "a.md, line 12, column 6: the command \\foo");
    EXPECT_FAILURE(lessonOf(oneStep("{}", "Text.\n```glsl lib/sdf.glsl sdfTorus\n```\n```glsl furr/a.glsl 1-2\n```")),
                   "a.md, line 14, column 9: there is no exhibit \"furr\"");
}

/// Returns a lesson with one step, whose sections begin in line 11.
std::string sectioned(const std::string& sections)
{
    return lessonHead + "## First\nSee this.\n" + sections + "\n```json\n{}\n```\n";
}

TEST(Lesson, AStepHasATaskAndAQuestionWithAnAnswer)
{
    const Lesson lesson =
        lessonOf(sectioned("### Try\n\nSet [row:gap].\n### Question\nWhy?\n### Answer\nOne.\n\nTwo."));
    ASSERT_EQ(lesson.steps.size(), 1U);
    EXPECT_EQ(lesson.steps[0].text, "See this.");
    EXPECT_EQ(lesson.steps[0].task, "Set [row:gap].");
    EXPECT_EQ(lesson.steps[0].question, "Why?");
    EXPECT_EQ(lesson.steps[0].answer, "One.\n\nTwo.");
    EXPECT_EQ(lessonText(lesson, lessonTables()),
              "# Title\n\nAn **introduction**.\n\n## 1. First\n\nSee this.\n\n**Try:** Set **" +
                  label(test::everyKind.rows()[test::everyKind.gap.row]) +
                  "**.\n\n**Question:** Why?\n\n**Answer:** One.\n\nTwo.\n");
    const LessonStep bare = lessonOf(oneStep("{}")).steps[0];
    EXPECT_TRUE(bare.task.empty() && bare.question.empty() && bare.answer.empty());
    EXPECT_EQ(lessonOf(sectioned("### Answer\nOne.\n### Question\nWhy?")).steps[0].answer, "One.") << "in any order";
}

TEST(Lesson, RefusesSectionsThatAreUnknownDoubledEmptyOrAlone)
{
    EXPECT_FAILURE(lessonOf(sectioned("### Hint\nLook.")), "a.md, line 11: within a step there are the headings");
    EXPECT_FAILURE(lessonOf(sectioned("### question\nWhy?")), "line 11: within a step there are the headings");
    EXPECT_FAILURE(lessonOf(sectioned("### Try\nOne.\n### Try\nTwo.")), "line 13: this step has \"### Try\" already");
    EXPECT_FAILURE(lessonOf(sectioned("### Try\n")), "line 11: there is no text below this heading");
    EXPECT_FAILURE(lessonOf(sectioned("### Question\nWhy?")), "line 11: this question has no answer");
    EXPECT_FAILURE(lessonOf(sectioned("### Answer\nOne.")), "line 11: this answer has no question");
    EXPECT_FAILURE(lessonOf(sectioned("### Try\nSet [row:gpa].")),
                   "line 11: in the text below this heading there is no");
    EXPECT_FAILURE(lessonOf(lessonHead + "### Try\nSee.\n"), "line 9: \"### Try\" belongs to a step");
    EXPECT_FAILURE(lessonOf("### Try\nSee.\n"), "line 1: \"### Try\" belongs to a step");
    EXPECT_FAILURE(lessonOf("# Title\n### Question\nWhy?\n"), "line 2: \"### Question\" belongs to a step");
    const std::string task(mostTaskLetters, 'x'), answer(mostLessonLetters, 'x');
    EXPECT_EQ(lessonOf(sectioned("### Try\n" + task)).steps[0].task, task);
    EXPECT_FAILURE(lessonOf(sectioned("### Try\n" + task + 'x')), "line 11: the text below this heading has 401 bytes");
    EXPECT_EQ(lessonOf(sectioned("### Question\n" + task + "\n### Answer\n" + answer)).steps[0].answer, answer);
    EXPECT_FAILURE(lessonOf(sectioned("### Question\nWhy?\n### Answer\n" + answer + 'x')), "has 701 bytes");
    EXPECT_FAILURE(lessonOf(sectioned("### Question\n" + task + "x\n### Answer\nOne.")), "has 401 bytes");
}

TEST(Lesson, RefusesOtherFormatsVersionsAndExhibits)
{
    const auto headed = [](const std::string& head) {
        return "# Title\n```json\n" + head + "\n```\n## A\nText.\n```json\n{}\n```\n";
    };
    EXPECT_EQ(lessonOf(headed(R"({"format": "vitrine-lesson", "version": 1, "exhibit": "everything"})")).steps.size(),
              1U);
    EXPECT_FAILURE(lessonOf(headed(R"({"format": "vitrine-preset", "version": 1, "exhibit": "everything"})")),
                   "a.md, line 3, format: this is not a lesson");
    EXPECT_FAILURE(lessonOf(headed(R"({"format": "vitrine-lesson", "version": 2, "exhibit": "everything"})")),
                   "line 3, version: this lesson is of a newer Vitrine; update");
    for (const char* version : {"0", "\"1\"", "1.5", "null"})
        EXPECT_FAILURE(
            lessonOf(headed(std::string(R"({"format": "vitrine-lesson", "exhibit": "everything", "version": )") +
                            version + "}")),
            "version: this must be 1");
    for (const char* exhibit : {"nothing", "hall"})
        EXPECT_FAILURE(lessonOf(headed(std::string(R"({"format": "vitrine-lesson", "version": 1, "exhibit": ")") +
                                       exhibit + "\"}")),
                       "exhibit: there is no exhibit of that name; `vitrine list`");
}

TEST(Lesson, TellsWhatItHadToChange)
{
    const Lesson lesson = lessonOf(oneStep(R"({"values": {"gap": 1e9}})"));
    ASSERT_EQ(lesson.notes.size(), 1U);
    EXPECT_NE(lesson.notes[0].find("gap"), std::string::npos);
}

}  // namespace
