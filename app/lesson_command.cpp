#include "app/kit/command.h"
#include "app/kit/findings.h"
#include "app/kit/say.h"
#include "app/kit/subject_tables.h"

#include "exhibits/framework/files/lesson.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

/// Reports a lesson that can be read, with the values that reading changed: in the report, or printed (null).
void reportLesson(const std::string& file, const Lesson& lesson, FindingsReport* report)
{
    if (report) {
        std::vector<CheckFinding> findings;
        for (const std::string& note : lesson.notes) findings.push_back({.sentence = note});
        render::Json& entry = report->add(file, lesson.notes.empty(), findings);
        entry["exhibit"] = lesson.exhibit;
        entry["title"] = lesson.title;
        entry["steps"] = lesson.steps.size();
        return;
    }
    std::printf("%s: %s (%s \"%s\", %zu steps)\n", file.c_str(), lesson.notes.empty() ? "good" : "changed",
                lesson.exhibit.c_str(), lesson.title.c_str(), lesson.steps.size());
    for (const std::string& note : lesson.notes) std::printf("  %s\n", note.c_str());
}

/// Checks one file. Returns 0 if it is valid, the exit code of a failed check if it is not, and that of a failed read
/// if it cannot be read.
int checkLesson(const std::string& file, const NamedValues& tables, FindingsReport* report)
{
    ErrorKind kind = ErrorKind::file;
    try {
        const std::string text = render::readFile(file, lessonBytes);
        kind = ErrorKind::check;
        const Lesson lesson = parseLesson(text, file, tables);
        reportLesson(file, lesson, report);
        return lesson.notes.empty() ? 0 : static_cast<int>(ErrorKind::check);
    } catch (const Failure& failure) {
        if (report)
            report->add(file, false, {findingOf(failure, file)});
        else
            say(failure);
        return static_cast<int>(kind);
    }
}

int checkLessons(const std::vector<std::string>& files, bool asJson)
{
    const SubjectTables tables;
    return checkEach(files, "lesson check", asJson, [&](const std::string& file, FindingsReport* report) {
        return checkLesson(file, tables.values, report);
    });
}

/// Prints the lesson of each exhibit that has one: exhibit, number of steps, title; as JSON with its file, too
/// (assets/schemas/lessons.schema.json).
int listLessons(bool asJson)
{
    const SubjectTables tables;
    render::Json document = newDocument("vitrine-lessons");
    document["lessons"] = render::Json::array();
    for (const auto& exhibit : tables.exhibits) {
        const std::filesystem::path path = shippedLesson(exhibit->name());
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        const Lesson lesson = readLesson(path, tables.values);
        if (asJson)
            document["lessons"].push_back({{"exhibit", lesson.exhibit},
                                           {"title", lesson.title},
                                           {"steps", lesson.steps.size()},
                                           {"file", path.string()}});
        else
            std::printf("%-16s %2zu steps  %s\n", lesson.exhibit.c_str(), lesson.steps.size(), lesson.title.c_str());
    }
    if (asJson) std::fputs(render::writeJson(document).c_str(), stdout);
    return 0;
}

/// Prints the texts of a lesson: that of an exhibit, or one in a file.
int showLesson(const std::string& name)
{
    const SubjectTables tables;
    std::vector<std::string> names;
    for (const auto& exhibit : tables.exhibits) names.emplace_back(exhibit->name());
    const bool isExhibit = std::find(names.begin(), names.end(), name) != names.end();
    const std::filesystem::path path = name;
    if (std::error_code ignored; !isExhibit && !path.has_extension() && !std::filesystem::exists(path, ignored))
        throw Failure(ErrorKind::usage, "There is neither a lesson file nor an exhibit named " + name +
                                            didYouMean(name, names) + " `vitrine lesson list` names the lessons.");
    const Lesson lesson = readLesson(isExhibit ? shippedLesson(name) : path, tables.values);
    std::fputs(lessonText(lesson, tables.values).c_str(), stdout);
    return 0;
}

}  // namespace

void addLessonCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("lesson", "Work with lessons");
    command->require_subcommand(1);
    CLI::App* listing = command->add_subcommand("list", "List the lessons that come with the program");
    auto asJson = std::make_shared<bool>(false);
    listing->add_flag("--json", *asJson, "Print the lessons as JSON, with their files");
    listing->callback([&chosen, asJson] { chosen = [asJson] { return listLessons(*asJson); }; });
    CLI::App* showing = command->add_subcommand("show", "Print a lesson to read: steps, tasks, questions and answers");
    auto name = std::make_shared<std::string>();
    showing->add_option("lesson", *name, "Exhibit whose lesson is printed, or a lesson file")->required();
    showing->callback([&chosen, name] { chosen = [name] { return showLesson(*name); }; });
    CLI::App* checking = command->add_subcommand("check", "Check whether lessons can be read, and list their errors");
    auto files = std::make_shared<std::vector<std::string>>();
    checking->add_option("files", *files, "Lesson files (Markdown)")->required();
    checking->add_flag("--json", *asJson, "Print the findings as JSON");
    checking->callback(
        [&chosen, files, asJson] { chosen = [files, asJson] { return checkLessons(*files, *asJson); }; });
}

}  // namespace vitrine::app
