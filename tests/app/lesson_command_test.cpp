#include "render/files/strict_json.h"
#include "tests/app/child_process.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

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

TEST(LessonCommand, SaysTheSameAsJson)
{
    const test::TemporaryFolder folder;
    const std::string good = folder / "good.md", bad = folder / "bad.md", far = folder / "far.md";
    test::writeBytes(good, lessonFile(R"({"values": {"morph": 0.5}})"));
    test::writeBytes(bad, lessonFile(R"({"values": {"morhp": 0.5}})"));
    test::writeBytes(far, lessonFile(R"({"values": {"morph": 7}})"));
    const Ended ended = test::vitrine({"lesson", "check", "--json", good, bad, far});
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.err, "");
    const render::Json document = render::Json::parse(ended.out);
    EXPECT_EQ(document["format"], "vitrine-findings");
    EXPECT_EQ(document["good"], false);
    const render::Json& files = document["files"];
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0]["good"], true);
    EXPECT_EQ(files[0]["title"], "Steps");
    EXPECT_EQ(files[0]["steps"], 1);
    EXPECT_EQ(files[1]["findings"][0]["line"], 8);
    EXPECT_EQ(files[1]["findings"][0]["key"], "values.morhp");
    EXPECT_EQ(files[2]["good"], false);
    EXPECT_EQ(files[2]["findings"][0]["sentence"], "morph 7 -> 1 (allowed 0 to 1)");
    EXPECT_EQ(test::vitrine({"lesson", "check", "--json", good}).code, 0);
    EXPECT_EQ(test::vitrine({"lesson", "check", "--json", folder / "none.md"}).code, 5);

    const Ended listed = test::vitrine({"lesson", "list", "--json"});
    EXPECT_EQ(listed.code, 0) << listed.err;
    const render::Json lessons = render::Json::parse(listed.out);
    EXPECT_EQ(lessons["format"], "vitrine-lessons");
    EXPECT_EQ(lessons["version"], 1);
    ASSERT_EQ(lessons["lessons"].size(), 10U);
    for (const render::Json& lesson : lessons["lessons"])
        EXPECT_TRUE(std::filesystem::exists(lesson["file"].get<std::string>())) << lesson;
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

/// Returns how often a part occurs in a text.
std::ptrdiff_t countOf(const std::string& text, const std::string& part)
{
    std::ptrdiff_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

TEST(LongLessonCommand, ExportsAHandoutAndSlidesWithAPictureForEachStep)
{
    const test::TemporaryFolder folder;
    const std::string file = folder / "own.md", out = folder / "handout";
    std::string text = lessonFile(R"({"values": {"morph": 0}, "camera": "best"})");
    text.insert(text.find("```json\n{\"val"), "### Try\nDrag [row:morph] & look.\n### Question\nWhy **so**?\n"
                                              "### Answer\nBecause 1 < 2.\n");
    text += "## Two\nMore.\n```json\n{\"values\": {\"morph\": 1}}\n```\n";
    test::writeBytes(file, text);
    const std::vector<std::string> command{"lesson", "export",    "sdf_morph", "--lesson", file, "--size",
                                           "48x27",  "--samples", "1",         "--out",    out};
    const Ended made = test::vitrine(command);
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string page = test::bytesOf(out + "/handout.html"), slides = test::bytesOf(out + "/slides.html");
    EXPECT_NE(page.find("Drag <strong>Morph</strong> &amp; look."), std::string::npos) << page;
    EXPECT_NE(page.find("Why <strong>so</strong>?"), std::string::npos) << page;
    EXPECT_EQ(countOf(page, "Because 1 &lt; 2."), 1);
    EXPECT_GT(page.find("Because 1"), page.find("2. Two")) << "the answers are at the end";
    EXPECT_EQ(countOf(page, "<img src=\"pictures/step-0"), 2);
    EXPECT_EQ(countOf(slides, "<section"), 4) << "title, step, question, step";
    const std::string one = test::bytesOf(out + "/pictures/step-01.png"),
                      two = test::bytesOf(out + "/pictures/step-02.png");
    EXPECT_NE(one, two) << "each step has its own settings";

    // Answers where they are asked for, and the same folder again.
    std::vector<std::string> without = command;
    without.insert(without.end(), {"--answers", "none"});
    ASSERT_EQ(test::vitrine(without).code, 0);
    EXPECT_EQ(countOf(test::bytesOf(out + "/handout.html"), "Because"), 0);

    EXPECT_EQ(test::vitrine({"lesson", "export", "hall", "--out", folder / "none"}).code, 2);
    const Ended missing =
        test::vitrine({"lesson", "export", "fur", "--lesson", folder / "none.md", "--out", folder / "x"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_NE(missing.err.find("none.md"), std::string::npos) << missing.err;
    // A folder with other things in it is not replaced.
    std::filesystem::create_directories(folder / "mine");
    test::writeBytes(folder / "mine/diary.txt", "mine");
    std::vector<std::string> over = command;
    over.back() = folder / "mine";
    EXPECT_NE(test::vitrine(over).code, 0);
    EXPECT_EQ(test::bytesOf(folder / "mine/diary.txt"), "mine");
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
