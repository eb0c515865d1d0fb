#include "app/kit/command.h"
#include "app/kit/picture_options.h"
#include "app/kit/say.h"
#include "app/kit/table_json.h"
#include "app/kit/useless_option.h"
#include "exhibits/exhibits.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

using render::Json;

int manual(const std::string& name)
{
    const HallTable hall;
    if (name == "hall") {
        std::fputs(derive::manualTable(hall).c_str(), stdout);
        return 0;
    }
    std::vector<std::string> names{"hall"};
    for (const auto& exhibit : allExhibits()) {
        names.emplace_back(exhibit->name());
        if (exhibit->name() != name) continue;
        std::fputs(derive::manualTable(exhibit->parameters()).c_str(), stdout);
        return 0;
    }
    throw Failure(ErrorKind::usage, "list --manual: there is no exhibit \"" + name + "\"" + didYouMean(name, names) +
                                        " `vitrine list` names them.");
}

/// Returns the parameter tables after these assignments, because files may add parameters.
Json tablesWith(const std::vector<std::string>& sets)
{
    const Museum museum{allExhibits()};
    SceneState sceneState = museum.initialSceneState();
    std::vector<std::string> notes;
    applySets(museum, sceneState, hallIndex, sets, notes);
    for (const std::string& note : notes) say(note);
    return exhibitsJson(museum, sceneState);
}

int list(bool asJson, const std::vector<std::string>& sets)
{
    const Json all = tablesWith(sets);
    if (asJson) {
        std::fputs(render::writeJson(all).c_str(), stdout);
        return 0;
    }
    for (const Json& exhibit : all)
        std::printf("%-16s %s (%zu parameters)\n", exhibit["name"].get<std::string>().c_str(),
                    exhibit["summary"].get<std::string>().c_str(), exhibit["parameters"].size());
    return 0;
}

int listJobs(bool asJson)
{
    Json schemas = Json::array();
    for (const auto& job : jobs::allJobs()) {
        if (asJson)
            schemas.push_back(jobs::schemaOf(*job));
        else
            std::printf("%-16s %s (%zu parameters)\n", std::string(job->name()).c_str(),
                        std::string(job->summary()).c_str(), job->parameters().rows().size());
    }
    if (asJson) std::fputs(render::writeJson(schemas).c_str(), stdout);
    return 0;
}

}  // namespace

void addListCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("list", "List the exhibits and their parameters");
    auto asJson = std::make_shared<bool>(false);
    command->add_flag("--json", *asJson, "Print all properties of every parameter as JSON; numbers are in SI units");
    auto sets = std::make_shared<std::vector<std::string>>();
    command
        ->add_option(
            "--set", *sets,
            "Value of a file parameter, as exhibit.name=FILE; the list then has the parameters that the file adds")
        ->take_all()
        ->allow_extra_args(true);
    auto name = std::make_shared<std::string>();
    command->add_option("--manual", *name, "Name of an exhibit whose parameters are printed as a table in Markdown");
    auto ofJobs = std::make_shared<bool>(false);
    command->add_flag("--jobs", *ofJobs,
                      "List the jobs instead of the exhibits; with --json, a JSON Schema of each job's parameters");
    command->callback([&chosen, asJson, sets, name, ofJobs, command] {
        chosen = [asJson, sets, name, ofJobs, command] {
            for (const char* option : {"--manual", "--set"}) refuseOn(*command, option, *ofJobs, "the list of --jobs");
            if (*ofJobs) return listJobs(*asJson);
            for (const char* option : {"--json", "--set"})
                refuseOn(*command, option, !name->empty(), "the table of --manual");
            return name->empty() ? list(*asJson, *sets) : manual(*name);
        };
    });
}

}  // namespace vitrine::app
