#include "app/command.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/preset.h"
#include "exhibits/hall/hall_table.h"
#include "render/failure.h"
#include "render/files/strict_json.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

/// Checks one file; prints what it is and what reading it changes. Returns whether it can be loaded.
bool check(const std::string& file, const NamedValues& tables)
{
    try {
        const render::JsonDocument document = render::readJson(file, presetLimits);
        const PresetHeader header = presetHeader(document);
        std::vector<std::string> notes;
        if (header.isExhibition) {
            notes = parseExhibition(document.text(), file, tables).notes;
        } else {
            const auto table = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.first == header.exhibit; });
            if (table == tables.end()) throw document.failure("exhibit", "there is no exhibit \"" + header.exhibit + "\"; `vitrine list` names them");
            notes = parsePreset(document.text(), file, header.exhibit, table->second.table()).notes;
        }
        std::printf("%s: good (%s \"%s\")\n", file.c_str(), header.isExhibition ? "exhibition" : header.exhibit.c_str(), header.name.c_str());
        for (const std::string& note : notes) std::printf("  %s\n", note.c_str());
        return true;
    } catch (const Failure& failure) {
        std::fprintf(stderr, "vitrine: %s\n", failure.what());
        return false;
    }
}

int checkAll(const std::vector<std::string>& files)
{
    const HallTable hall;
    const auto exhibits = allExhibits();
    NamedValues tables{{"hall", hall.initial()}};
    for (const auto& exhibit : exhibits) tables.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
    int bad = 0;
    for (const std::string& file : files) bad += check(file, tables) ? 0 : 1;
    return bad == 0 ? 0 : static_cast<int>(Blame::file);
}

}  // namespace

void addPresetCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("preset", "Work with preset files");
    command->require_subcommand(1);
    CLI::App* checking = command->add_subcommand("check", "Say whether preset files can be loaded, and what loading changes");
    auto files = std::make_shared<std::vector<std::string>>();
    checking->add_option("files", *files, "Preset or exhibition files")->required();
    checking->callback([&chosen, files] { chosen = [files] { return checkAll(*files); }; });
}

}  // namespace vitrine::app
