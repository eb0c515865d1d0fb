#include "app/kit/command.h"
#include "app/kit/number_option.h"
#include "app/kit/useless_option.h"
#include "app/serve/window_service.h"
#include "render/failure.h"
#include "ui/window/run_window.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

namespace vitrine::app {
namespace {

struct OpenOptions {
    std::vector<std::string> files;
    std::string serve;
    bool kiosk = false;
    ui::KioskOptions exhibition;
};

int openWindow(int& argc, char** argv, const OpenOptions& options)
{
    if (options.kiosk && !options.serve.empty())
        throw Failure(ErrorKind::usage, "--serve and --kiosk exclude each other; give one of them.");
    ui::WindowOptions window{.files = options.files};
    if (!options.serve.empty()) {
        // Made before the window, so that a path that cannot be used ends the command.
        // The window's thread destroys it before the window.
        window.opened = [service = std::make_shared<WindowService>(options.serve)](ui::MainWindow& opened) mutable {
            service->serve(opened);
            return std::exchange(service, nullptr);
        };
    }
    if (options.kiosk) {
        window.kiosk = options.exhibition;
        std::printf("vitrine: exhibition; Ctrl+Alt+Shift+Q ends it\n");
        std::fflush(stdout);
    }
    const int result = ui::runWindow(argc, argv, window);
    return result == ui::noDisplay ? static_cast<int>(ErrorKind::openGl) : result;
}

/// Adds the options of the window to a command.
void addWindowOptions(CLI::App& command, OpenOptions& options)
{
    command.add_option(
        "--serve", options.serve,
        "Path of a socket at which tools and notebooks can read and change the values of the open window, "
        "as with the command serve");
    command.add_flag("--kiosk", options.kiosk,
                     "Show the window for an exhibition: the picture alone fills the screen, without menus, panels and "
                     "shortcuts. Ctrl+Alt+Shift+Q ends it");
    addNumber(command, "--kiosk-minutes", options.exhibition.minutes, {0.1, 1440},
              "Minutes without input after which the exhibition begins anew: at the entrance, with the values of the "
              "start")
        ->capture_default_str();
    command
        .add_option("--kiosk-parameters", options.exhibition.parameters,
                    "Parameters that visitors may change, separated by commas: exhibit.parameter,...")
        ->delimiter(',')
        ->allow_extra_args(false);
}

}  // namespace

void addOpenCommand(CLI::App& parser, Action& chosen, int& argc, char** argv)
{
    CLI::App* command = parser.add_subcommand("open", "Open the window with files: presets, prints, scenes, models");
    auto options = std::make_shared<OpenOptions>();
    command->add_option("files", options->files, "Files to open, as when they are dropped onto the window");
    addWindowOptions(parser, *options);
    addWindowOptions(*command, *options);
    chosen = [&argc, argv, options] { return openWindow(argc, argv, *options); };
    command->callback([&chosen, &argc, argv, options] {
        for (const std::string& file : options->files)
            if (std::error_code error; !std::filesystem::exists(file, error))
                throw Failure(ErrorKind::usage, "Cannot open " + file + ": there is no such file; check the name.");
        chosen = [&argc, argv, options] { return openWindow(argc, argv, *options); };
    });
}

void refuseWindowOptions(const CLI::App& parser)
{
    for (const CLI::App* command : std::vector<const CLI::App*>{&parser, parser.get_subcommand("open")})
        for (const char* option : {"--kiosk-minutes", "--kiosk-parameters"})
            refuseWithout(*command, option,
                          parser.get_option("--kiosk")->count() +
                                  parser.get_subcommand("open")->get_option("--kiosk")->count() >
                              0,
                          "--kiosk");
    if (parser.get_subcommands().empty() || parser.got_subcommand("open")) return;
    for (const char* option : {"--serve", "--kiosk"})
        if (parser.get_option(option)->count() > 0)
            throw Failure(ErrorKind::usage, std::string(option) + " is an option of the window, and " +
                                                parser.get_subcommands().front()->get_name() +
                                                " opens none; leave it out.");
}

}  // namespace vitrine::app
