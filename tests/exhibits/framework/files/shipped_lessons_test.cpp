#include "exhibits/framework/files/lesson.h"

#include "exhibits/exhibits.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/museum/museum.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/text/translation.h"

#include "tests/exhibits/translated_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

/// All lessons that come with the program, in all languages.
class ShippedLessons : public testing::Test {
protected:
    ShippedLessons()
    {
        std::erase_if(exhibits_, [](const auto& exhibit) { return !exhibit->isComplete(); });
        EXPECT_GE(exhibits_.size(), 9U);
        tables_.emplace_back("hall", hall_.initial());
        for (const auto& exhibit : exhibits_)
            tables_.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
    }
    [[nodiscard]] Lesson read(const Exhibit& exhibit) const
    {
        return readLesson(shippedLesson(exhibit.name()), tables_);
    }

    /// Returns the lesson's file as it is.
    static std::string bytes(const std::string& folder, const Exhibit& exhibit)
    {
        return render::readFile(render::asset(folder + '/' + std::string(exhibit.name()) + ".md"), lessonBytes);
    }

    const hall::HallTable hall_;
    std::vector<std::unique_ptr<Exhibit>> exhibits_ = allExhibits();
    NamedValues tables_;
};

TEST_F(ShippedLessons, ThereIsOneForEveryCompleteExhibitAndNothingInItIsChanged)
{
    for (const auto& exhibit : exhibits_) {
        const Lesson lesson = read(*exhibit);
        EXPECT_EQ(lesson.exhibit, exhibit->name());
        EXPECT_TRUE(lesson.notes.empty()) << exhibit->name() << ": " << lesson.notes.front();
        EXPECT_GE(lesson.steps.size(), 5U) << exhibit->name();
        EXPECT_LE(lesson.steps.size(), 8U) << exhibit->name();
        EXPECT_TRUE(lesson.steps.front().bestView || lesson.steps.front().camera) << exhibit->name();
        EXPECT_FALSE(lesson.intro.empty()) << exhibit->name();
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shippedLesson("hall").parent_path()))
        files += entry.path().extension() == ".md" && entry.path().filename() != "README.md" ? 1 : 0;
    EXPECT_EQ(files, exhibits_.size()) << "a lesson that belongs to no exhibit";
}

TEST_F(ShippedLessons, EveryStepShowsSomethingElseAndNamesARowOrANumber)
{
    for (const auto& exhibit : exhibits_) {
        const Lesson lesson = read(*exhibit);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const LessonStep& step = lesson.steps[i];
            EXPECT_TRUE(step.text.find("[row:") != std::string::npos || step.read)
                << exhibit->name() << ", line " << step.line;
            if (i == 0) continue;
            const LessonStep& before = lesson.steps[i - 1];
            EXPECT_FALSE(step.values == before.values && step.hall == before.hall && step.camera == before.camera)
                << exhibit->name() << ", line " << step.line << ": the same as the step before";
        }
    }
}

TEST_F(ShippedLessons, EveryStepHasSomethingToDoAndAQuestionWithAnAnswer)
{
    for (const auto& exhibit : exhibits_) {
        for (const LessonStep& step : read(*exhibit).steps) {
            SCOPED_TRACE(std::string(exhibit->name()) + ", line " + std::to_string(step.line));
            EXPECT_GE(step.task.size(), 20U);
            EXPECT_TRUE(step.question.ends_with('?')) << step.question;
            EXPECT_GE(step.answer.size(), 40U);
        }
    }
}

/// The syllabus is for teachers: it names each lesson, leads to it and to its page, and says how long it takes.
TEST_F(ShippedLessons, AreAllInTheSyllabus)
{
    for (const std::string folder : {"", "de/"}) {
        const std::string page = render::readFile(render::asset("pages/" + folder + "syllabus.html"), 1U << 20U);
        for (const auto& exhibit : exhibits_) {
            const std::string name(exhibit->name());
            const Lesson lesson = readLesson(render::asset("lessons/" + folder + name + ".md"), tables_);
            const std::size_t at = page.find("<b>" + lesson.title + "</b>");
            ASSERT_NE(at, std::string::npos) << folder << name << ": " << lesson.title;
            const std::string row = page.substr(at, page.find("</tr>", at) - at);
            EXPECT_NE(row.find("href=\"lesson:" + name + '"'), std::string::npos) << row;
            EXPECT_NE(row.find("href=\"" + name + ".html\""), std::string::npos) << row;
            EXPECT_TRUE(std::regex_search(row, std::regex("<td>[0-9]+</td>"))) << row;
        }
    }
}

/// A counter that only the GPU knows, such as of visible samples, says little about the work.
TEST_F(ShippedLessons, CountersThatAreReadCountTheWorkThatIsPlanned)
{
    const Museum museum(allExhibits());
    std::map<std::string, std::vector<std::int64_t>> counts;  // Counts of each exhibit, step by step.
    for (const auto& [index, exhibit] : museum.exhibits()) {
        if (!exhibit.isComplete()) continue;
        const std::string name(exhibit.name());
        const Lesson lesson = readLesson(shippedLesson(name), tables_);
        for (const LessonStep& step : lesson.steps) {
            if (!step.read || step.read->of != LessonNumber::Of::counter) continue;
            SceneState state = museum.initialSceneState();
            state.values[index] = step.values;
            for (const auto& [row, value] : step.hall) state.hall().setParameter(row, value);
            FrameRequest frame;
            frame.camera = step.camera ? *step.camera : museum.bestView(index, step.values);
            frame.raster.size = {64, 36};
            const render::FramePlan plan = museum.plan(museum.prepare(state, frame), frame);
            std::int64_t count = 0;
            for (const render::Pass& pass : plan.passes())
                if (const auto found = pass.counts.find(step.read->name); found != pass.counts.end())
                    count += found->second;
            EXPECT_GT(count, 0) << name << ", line " << step.line << ": " << step.read->name;
            counts[name].push_back(count);
        }
    }
    // "Now an eighth of the steps", and the taps of 3 and 5 tap.
    ASSERT_EQ(counts["crepuscular_rays"].size(), 2U);
    EXPECT_EQ(counts["crepuscular_rays"][0], 8 * counts["crepuscular_rays"][1]);
    ASSERT_EQ(counts["pixel_art"].size(), 3U);
    EXPECT_EQ(5 * counts["pixel_art"][0], 3 * counts["pixel_art"][1]);
    EXPECT_GT(counts["pixel_art"][2], counts["pixel_art"][1]);
    EXPECT_EQ(counts.count("fur"), 0U);
}

/// Returns the blocks between ``` and ```, including these marks, in order.
std::vector<std::string> blocksOf(const std::string& lesson)
{
    std::vector<std::string> blocks;
    for (std::size_t at = lesson.find("```"); at != std::string::npos; at = lesson.find("```", at)) {
        const std::size_t end = std::min(lesson.find("```", at + 3), lesson.size() - 3) + 3;
        blocks.push_back(lesson.substr(at, end - at));
        at = end;
    }
    return blocks;
}

/// Returns the names of parameters in a text, sorted and unique.
std::set<std::string> parametersIn(const std::string& text)
{
    static const std::regex mark(R"(\[row:([^\]]*)\])");
    return {std::sregex_token_iterator(text.begin(), text.end(), mark, 1), std::sregex_token_iterator()};
}

TEST_F(ShippedLessons, AreTheSameStepsInEveryLanguage)
{
    for (const std::string& language : test::languagesUnder("lessons")) {
        const std::string folder = "lessons/" + language;
        for (const auto& exhibit : exhibits_) {
            SCOPED_TRACE(folder + '/' + std::string(exhibit->name()));
            const std::string english = bytes("lessons", *exhibit), other = bytes(folder, *exhibit);
            EXPECT_EQ(blocksOf(other), blocksOf(english));
            const Lesson model = readLesson(render::asset("lessons/" + std::string(exhibit->name()) + ".md"), tables_);
            const Lesson lesson =
                readLesson(render::asset(folder + '/' + std::string(exhibit->name()) + ".md"), tables_);
            EXPECT_TRUE(lesson.notes.empty());
            EXPECT_NE(lesson.title, model.title);
            EXPECT_NE(lesson.intro, model.intro);
            ASSERT_EQ(lesson.steps.size(), model.steps.size());
            for (std::size_t i = 0; i < model.steps.size(); ++i) {
                const LessonStep &step = lesson.steps[i], &of = model.steps[i];
                EXPECT_NE(step.title, of.title);
                EXPECT_NE(step.text, of.text);
                EXPECT_EQ(parametersIn(step.text), parametersIn(of.text)) << step.title;
                EXPECT_EQ(test::numbersIn(step.text), test::numbersIn(of.text)) << step.title;
                for (const auto text : {&LessonStep::task, &LessonStep::question, &LessonStep::answer}) {
                    EXPECT_NE(step.*text, of.*text);
                    EXPECT_EQ(parametersIn(step.*text), parametersIn(of.*text)) << of.*text;
                    EXPECT_EQ(test::numbersIn(step.*text), test::numbersIn(of.*text)) << of.*text;
                }
            }
        }
    }
}

TEST_F(ShippedLessons, AreTakenInTheLanguageInUseElseInEnglish)
{
    const std::filesystem::path english = shippedLesson("fur");
    EXPECT_EQ(english, render::asset("lessons/fur.md"));
    setLanguage("de", nullptr);
    const std::filesystem::path german = shippedLesson("fur");
    setLanguage("xx", nullptr);
    const std::filesystem::path unknown = shippedLesson("fur");
    setLanguage("en", nullptr);
    EXPECT_EQ(german, render::asset("lessons/de/fur.md"));
    EXPECT_EQ(unknown, english);
}

TEST_F(ShippedLessons, BelongToAnExhibitAndAreUtf8InEveryLanguage)
{
    for (const std::string& language : test::languagesUnder("lessons")) {
        const std::string folder = "lessons/" + language;
        EXPECT_EQ(test::filesIn(folder, ".md").size(), exhibits_.size()) << folder;
        for (const auto& exhibit : exhibits_)
            EXPECT_EQ(test::faultOfText(bytes(folder, *exhibit)), "") << folder << '/' << exhibit->name();
    }
}

}  // namespace
