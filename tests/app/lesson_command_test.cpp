#include "tests/app/child_process.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace {

using namespace vitrine;
using test::Ended;

std::string lessonFile(const std::string& block)
{
    return "# Steps\n```json\n{\"format\": \"vitrine-lesson\", \"version\": 1, \"exhibit\": \"sdf_morph\"}\n```\n"
           "## One\nText.\n```json\n" +
           block + "\n```\n";
}

TEST(LessonCommand, SaysWhatIsGoodAndWhatIsNot)
{
    const test::TemporaryFolder folder;
    const std::string good = folder / "good.md", bad = folder / "bad.md", far = folder / "far.md";
    test::writeBytes(good, lessonFile(R"({"values": {"morph": 0.5}})"));
    test::writeBytes(bad, lessonFile(R"({"values": {"morhp": 0.5}})"));
    test::writeBytes(far, lessonFile(R"({"values": {"morph": 7}})"));

    const Ended fine = test::vitrine({"lesson", "check", good});
    EXPECT_EQ(fine.code, 0) << fine.err;
    EXPECT_EQ(fine.out, good + ": good (sdf_morph \"Steps\", 1 steps)\n");

    const Ended wrong = test::vitrine({"lesson", "check", good, bad});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.err.find(bad + ", line 8, values.morhp: there is no parameter \"morhp\""), std::string::npos)
        << wrong.err;

    const Ended changed = test::vitrine({"lesson", "check", far});
    EXPECT_EQ(changed.code, 1);
    EXPECT_NE(changed.out.find("  morph 7 -> 1 (allowed 0 to 1)"), std::string::npos) << changed.out;

    EXPECT_EQ(test::vitrine({"lesson", "check", folder / "none.md"}).code, 5);
    EXPECT_EQ(test::vitrine({"lesson", "check"}).code, 2);
    EXPECT_EQ(test::vitrine({"lesson"}).code, 2);
}

TEST(LessonCommand, PrintsTasksQuestionsAndAnswers)
{
    const test::TemporaryFolder folder;
    const std::string file = folder / "own.md";
    std::string text = lessonFile("{}");
    text.insert(text.find("```json\n{}"), "### Try\nDrag.\n### Question\nWhy?\n### Answer\nSo.\n");
    test::writeBytes(file, text);
    const Ended own = test::vitrine({"lesson", "show", file});
    EXPECT_EQ(own.code, 0) << own.err;
    EXPECT_EQ(own.out, "# Steps\n\n## 1. One\n\nText.\n\n**Try:** Drag.\n\n**Question:** Why?\n\n**Answer:** So.\n");
    const Ended german = test::vitrine({"--language", "de", "lesson", "show", "fur"});
    EXPECT_EQ(german.code, 0) << german.err;
    EXPECT_TRUE(german.out.starts_with("# Haare, die es nirgends gibt\n")) << german.out;
    for (const char* word : {"**Aufgabe:** ", "**Frage:** ", "**Antwort:** "})
        EXPECT_NE(german.out.find(word), std::string::npos) << word;
    EXPECT_EQ(test::vitrine({"lesson", "show", folder / "none.md"}).code, 5);
    const Ended misspelled = test::vitrine({"lesson", "show", "furr"});
    EXPECT_EQ(misspelled.code, 2);
    EXPECT_NE(misspelled.err.find("did you mean fur?"), std::string::npos) << misspelled.err;
}

TEST(LessonCommand, ListsTheLessonOfEveryExhibit)
{
    const Ended ended = test::vitrine({"lesson", "list"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 10) << ended.out;
    EXPECT_NE(ended.out.find("sdf_morph "), std::string::npos);
}

TEST(LessonCommand, ListsLessonsInTheLanguageThatIsAskedFor)
{
    const Ended ended = test::vitrine({"--language", "de", "lesson", "list"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 10) << ended.out;
    EXPECT_NE(ended.out.find("Haare, die es nirgends gibt"), std::string::npos) << ended.out;
    EXPECT_EQ(ended.out.find("Hair that is nowhere"), std::string::npos) << ended.out;
}

}  // namespace
