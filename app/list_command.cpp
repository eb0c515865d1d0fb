#include "app/kit/command.h"
#include "app/kit/findings.h"
#include "app/kit/picture_options.h"
#include "app/kit/say.h"
#include "app/kit/table_json.h"
#include "app/kit/useless_option.h"
#include "exhibits/exhibits.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/table/typed_number.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <span>

namespace vitrine::app {
namespace {

using render::Json;

int manual(const std::string& name)
{
    const hall::HallTable hall;
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

/// The museum with its parameter tables after some assignments, because files may add parameters.
struct ListedTables {
    Museum museum{allExhibits()};
    SceneState sceneState = museum.initialSceneState();

    explicit ListedTables(const std::vector<std::string>& sets, std::size_t subject = hallIndex)
    {
        std::vector<std::string> notes;
        applySets(museum, sceneState, subject, sets, notes);
        for (const std::string& note : notes) say(note);
    }
};

/// Returns the values that a parameter takes, for a column of a table: "0..360 deg", "area|hard".
std::string takenBy(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: {
        NumberRange range = rangeOf(parameter, parameter.unit);
        range.whole = parameter.kind == Kind::count;
        return typeName(range) + behindNumber(info(parameter.unit).storedSymbol);
    }
    case Kind::choice: return joined(parameter.choices, "|");
    case Kind::toggle: return "on|off";
    case Kind::color: return "color";
    case Kind::direction: return "x,y,z";
    case Kind::file: return "file";
    case Kind::text: return "text";
    }
    return {};
}

/// Prints exhibits as a document (assets/schemas/exhibits.schema.json).
void printExhibits(const Json& exhibits)
{
    Json document = newDocument("vitrine-exhibits");
    document["exhibits"] = exhibits;
    std::fputs(render::writeJson(document).c_str(), stdout);
}

/// Prints one line for each parameter of an exhibit: name, initial value, values that it takes, help.
int listOne(const std::string& name, bool asJson, const std::vector<std::string>& sets)
{
    const auto subject = Museum{allExhibits()}.find(name);
    if (!subject) {
        std::vector<std::string> names{"hall"};
        for (const auto& exhibit : allExhibits()) names.emplace_back(exhibit->name());
        throw Failure(ErrorKind::usage, "list: there is no exhibit \"" + name + "\"" + didYouMean(name, names) +
                                            " `vitrine list` names them.");
    }
    const ListedTables tables(sets, *subject);
    if (asJson) {
        printExhibits(Json::array({exhibitsJson(tables.museum, tables.sceneState).at(*subject)}));
        return 0;
    }
    const std::span<const ParameterInfo> rows = tables.sceneState.values[*subject].rows();
    std::array<int, 3> widths{};
    const auto cellsOf = [](const ParameterInfo& parameter) {
        return std::array<std::string, 3>{std::string(parameter.name), formatValue(parameter, parameter.initial),
                                          takenBy(parameter)};
    };
    for (const ParameterInfo& parameter : rows)
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths.at(i) = std::min(std::max(widths.at(i), static_cast<int>(cellsOf(parameter).at(i).size())), 24);
    std::string_view group;
    for (const ParameterInfo& parameter : rows) {
        if (parameter.group != group) std::printf("%s\n", std::string(group = parameter.group).c_str());
        const auto [what, initial, taken] = cellsOf(parameter);
        std::printf("  %-*s  %-*s  %-*s  %s\n", widths[0], what.c_str(), widths[1], initial.c_str(), widths[2],
                    taken.c_str(), std::string(parameter.help).c_str());
    }
    return 0;
}

int list(bool asJson, const std::vector<std::string>& sets)
{
    const ListedTables tables(sets);
    const Json all = exhibitsJson(tables.museum, tables.sceneState);
    if (asJson) {
        printExhibits(all);
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
    auto exhibit = std::make_shared<std::string>();
    command->add_option("exhibit", *exhibit,
                        "Name of an exhibit, or hall, whose parameters are listed: name, initial value, values that it "
                        "takes, help");
    auto name = std::make_shared<std::string>();
    command->add_option("--manual", *name, "Name of an exhibit whose parameters are printed as a table in Markdown");
    auto ofJobs = std::make_shared<bool>(false);
    command->add_flag("--jobs", *ofJobs,
                      "List the jobs instead of the exhibits; with --json, a JSON Schema of each job's parameters");
    command->callback([&chosen, asJson, sets, exhibit, name, ofJobs, command] {
        chosen = [asJson, sets, exhibit, name, ofJobs, command] {
            for (const char* option : {"exhibit", "--manual", "--set"})
                refuseOn(*command, option, *ofJobs, "the list of --jobs");
            if (*ofJobs) return listJobs(*asJson);
            for (const char* option : {"exhibit", "--json", "--set"})
                refuseOn(*command, option, !name->empty(), "the table of --manual");
            if (!exhibit->empty()) return listOne(*exhibit, *asJson, *sets);
            return name->empty() ? list(*asJson, *sets) : manual(*name);
        };
    });
}

}  // namespace vitrine::app
