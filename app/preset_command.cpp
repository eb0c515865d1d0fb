#include "app/kit/apply_preset.h"
#include "app/kit/command.h"
#include "app/kit/findings.h"
#include "app/kit/say.h"
#include "app/kit/subject_tables.h"

#include "exhibits/framework/files/preset_schema.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

/// Returns ", tags: night, water"; empty if there are none.
std::string tagsText(const PresetTags& tags)
{
    std::string text;
    for (const std::string& tag : tags) text += (text.empty() ? ", tags: " : ", ") + tag;
    return text;
}

/// Reports a file that can be loaded, with the corrections of reading it: in the report, or printed (null).
void reportGood(const std::string& file, const PresetHeader& header, const std::vector<std::string>& notes,
                FindingsReport* report)
{
    if (report) {
        std::vector<CheckFinding> findings;
        for (const std::string& note : notes) findings.push_back({.isError = false, .sentence = note});
        render::Json& entry = report->add(file, true, findings);
        entry["kind"] = header.isExhibition ? "exhibition" : "preset";
        entry["exhibit"] = header.exhibit;
        entry["name"] = header.name;
        entry["tags"] = header.tags;
        return;
    }
    std::printf("%s: good (%s \"%s\"%s)\n", file.c_str(), header.isExhibition ? "exhibition" : header.exhibit.c_str(),
                header.name.c_str(), tagsText(header.tags).c_str());
    for (const std::string& note : notes) std::printf("  %s\n", note.c_str());
}

/// Checks one file, and reports its content and the corrections of reading it. Returns 0 if it can be loaded, the exit
/// code of a failed check if it is invalid, and that of a failed read if it cannot be read.
int check(const std::string& file, const NamedValues& tables, FindingsReport* report)
{
    ErrorKind kind = ErrorKind::file;
    try {
        std::string text = presetTextOf(file);
        kind = ErrorKind::check;
        const render::JsonDocument document = render::parseJson(std::move(text), file, presetLimits);
        const PresetHeader header = presetHeader(document);
        std::vector<std::string> notes;
        if (header.isExhibition) {
            notes = parseExhibition(document.text(), file, tables).notes;
        } else {
            const auto table =
                std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.first == header.exhibit; });
            if (table == tables.end())
                throw document.failure("exhibit",
                                       "there is no exhibit \"" + header.exhibit + "\"; `vitrine list` names them");
            notes = parsePreset(document.text(), file, header.exhibit, table->second.table()).notes;
        }
        reportGood(file, header, notes, report);
        return 0;
    } catch (const Failure& failure) {
        if (report)
            report->add(file, false, {findingOf(failure, file)});
        else
            say(failure);
        return static_cast<int>(kind);
    }
}

int checkAll(const std::vector<std::string>& files, bool asJson)
{
    const SubjectTables tables;
    return checkEach(files, "preset check", asJson, [&](const std::string& file, FindingsReport* report) {
        return check(file, tables.values, report);
    });
}

/// Prints the schema of the presets of an exhibit, or that of settings of the whole museum.
int printSchema(const std::string& exhibit)
{
    const SubjectTables tables;
    if (exhibit.empty()) {
        std::fputs(render::writeJson(exhibitionSchema(tables.values)).c_str(), stdout);
        return 0;
    }
    std::vector<std::string> names;
    for (const auto& [name, values] : tables.values) {
        names.push_back(name);
        if (name != exhibit) continue;
        std::fputs(render::writeJson(presetSchema(name, values)).c_str(), stdout);
        return 0;
    }
    throw Failure(ErrorKind::usage, "There is no exhibit \"" + exhibit + "\"" + didYouMean(exhibit, names) +
                                        " `vitrine list` names them.");
}

}  // namespace

void addPresetCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("preset", "Work with preset files");
    command->require_subcommand(1);
    CLI::App* checking =
        command->add_subcommand("check", "Check whether preset files can be loaded, and list what loading changes");
    auto files = std::make_shared<std::vector<std::string>>();
    checking->add_option("files", *files, "Preset or exhibition files, or pictures that carry a preset")->required();
    auto asJson = std::make_shared<bool>(false);
    checking->add_flag("--json", *asJson, "Print the findings as JSON");
    checking->callback([&chosen, files, asJson] { chosen = [files, asJson] { return checkAll(*files, *asJson); }; });
    CLI::App* describing = command->add_subcommand(
        "schema", "Print the JSON Schema of preset files, with which editors complete and check them");
    auto exhibit = std::make_shared<std::string>();
    describing->add_option("exhibit", *exhibit,
                           "Exhibit, or hall; without it, the schema of settings of the whole museum");
    describing->callback([&chosen, exhibit] { chosen = [exhibit] { return printSchema(*exhibit); }; });
}

}  // namespace vitrine::app
