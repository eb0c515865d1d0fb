#include "app/kit/command.h"
#include "app/kit/findings.h"

#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/failure.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

/// Adds a file to the report. Shapes that are left out of a scene are notes.
void reportScene(const std::string& file, const scenes::ReadScene& read, FindingsReport& report)
{
    std::vector<CheckFinding> all;
    const auto add = [&](const std::vector<scenes::Finding>& findings, bool areErrors) {
        for (const scenes::Finding& finding : findings)
            all.push_back({areErrors, finding.sentence, finding.file, finding.line, finding.column, finding.key});
    };
    add(read.findings, true);
    if (read.scene) add(read.scene->leftOut, false);
    render::Json& entry = report.add(file, read.scene != nullptr, all);
    if (!read.scene) return;
    entry["name"] = read.scene->name;
    entry["nodes"] = read.scene->nodes.size();
    entry["parameters"] = read.scene->parameters().size();
}

/// Prints a finding in the form that editors read: "file:line:column: key: sentence". The sentence is in the locale's
/// language.
void printFinding(scenes::Finding finding)
{
    finding.sentence = ui::translatedInLocale(finding.sentence);
    std::printf("%s\n", finding.text().english().c_str());
}

/// Checks one file and prints the findings. Returns 0, or the exit code of a failed check or a failed read.
int checkScene(const std::string& file, FindingsReport* report)
{
    const scenes::ReadScene read = scenes::readSceneFile(file);
    if (report) {
        reportScene(file, read, *report);
    } else if (read.scene) {
        std::printf("%s: good (\"%s\", %zu nodes, %zu parameters)\n", file.c_str(), read.scene->name.c_str(),
                    read.scene->nodes.size(), read.scene->parameters().size());
        for (const scenes::Finding& shape : read.scene->leftOut)
            std::printf("%s This shape is left out.\n", shape.text().english().c_str());
    } else {
        for (const scenes::Finding& finding : read.findings) printFinding(finding);
    }
    if (read.scene) return 0;
    return static_cast<int>(read.fileRead ? ErrorKind::check : ErrorKind::file);
}

int checkScenes(const std::vector<std::string>& files, bool asJson)
{
    return checkEach(files, "scene check", asJson, checkScene);
}

void addCheck(CLI::App& command, Action& chosen)
{
    CLI::App* checking =
        command.add_subcommand("check", "Check scene files, and list their errors as file:line:column: key: ...");
    auto files = std::make_shared<std::vector<std::string>>();
    auto asJson = std::make_shared<bool>(false);
    checking->add_option("files", *files, "Scene files (JSON) of this program, or of the reference")->required();
    checking->add_flag("--json", *asJson, "Print the findings as JSON");
    checking->callback([&chosen, files, asJson] { chosen = [files, asJson] { return checkScenes(*files, *asJson); }; });
}

}  // namespace

void addSceneCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("scene", "Work with scene files of shapes");
    command->require_subcommand(1);
    addCheck(*command, chosen);
}

}  // namespace vitrine::app
