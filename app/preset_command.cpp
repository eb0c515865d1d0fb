#include "app/kit/apply_preset.h"
#include "app/kit/command.h"
#include "app/kit/say.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/hall/hall_table.h"
#include "render/failure.h"
#include "render/files/strict_json.h"

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

/// Checks one file; prints its content and the corrections of reading it. Returns 0 if it can be loaded, the exit code
/// of a failed check if it is invalid, and that of a failed read if it cannot be read.
int check(const std::string& file, const NamedValues& tables)
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
        std::printf("%s: good (%s \"%s\"%s)\n", file.c_str(),
                    header.isExhibition ? "exhibition" : header.exhibit.c_str(), header.name.c_str(),
                    tagsText(header.tags).c_str());
        for (const std::string& note : notes) std::printf("  %s\n", note.c_str());
        return 0;
    } catch (const Failure& failure) {
        say(failure);
        return static_cast<int>(kind);
    }
}

int checkAll(const std::vector<std::string>& files)
{
    const HallTable hall;
    const auto exhibits = allExhibits();
    NamedValues tables{{"hall", hall.initial()}};
    for (const auto& exhibit : exhibits)
        tables.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
    int worst = 0;
    for (const std::string& file : files) worst = std::max(worst, check(file, tables));
    return worst;
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
    checking->callback([&chosen, files] { chosen = [files] { return checkAll(*files); }; });
}

}  // namespace vitrine::app
