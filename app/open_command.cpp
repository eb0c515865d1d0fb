#include "app/kit/command.h"
#include "render/failure.h"
#include "ui/window/run_window.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace vitrine::app {

int openWindow(int& argc, char** argv, const std::vector<std::string>& files)
{
    const int result = ui::runWindow(argc, argv, files);
    return result == ui::noDisplay ? static_cast<int>(ErrorKind::openGl) : result;
}

void addOpenCommand(CLI::App& parser, Action& chosen, int& argc, char** argv)
{
    CLI::App* command = parser.add_subcommand("open", "Open the window with files: presets, prints, scenes, models");
    auto files = std::make_shared<std::vector<std::string>>();
    command->add_option("files", *files, "Files to open, as when they are dropped onto the window");
    command->callback([&chosen, &argc, argv, files] {
        for (const std::string& file : *files)
            if (std::error_code error; !std::filesystem::exists(file, error))
                throw Failure(ErrorKind::usage, "Cannot open " + file + ": there is no such file; check the name.");
        chosen = [&argc, argv, files] { return openWindow(argc, argv, *files); };
    });
}

}  // namespace vitrine::app
