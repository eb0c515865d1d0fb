#include "app/kit/command.h"
#include "app/kit/number_option.h"
#include "app/kit/progress.h"
#include "app/serve/listener.h"
#include "app/serve/server.h"
#include "app/serve/service.h"

#include "exhibits/exhibits.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

namespace vitrine::app {
namespace {

std::string serveFooter()
{
    return "JSON-RPC 2.0, one object a line, params by name; all connections share one look. Methods:\n" +
           Service::methodsText() +
           "Params that a command has too are its options, with underscores for dashes. SIGTERM ends the server.";
}

/// Stops the server when standard input ends, as it does when the program that started it ends. Call after StopSignal
/// was made.
void stopAtInputEnd()
{
    std::thread([] {
        char read = 0;
        while (::read(STDIN_FILENO, &read, 1) > 0) {
        }
        (void)::kill(::getpid(), SIGTERM);
    }).detach();
}

struct ServeOptions {
    std::string path;
    double idleSeconds = 60;
    bool untilInputEnds = false;
};

int serve(const ServeOptions& chosen)
{
    const StopSignal stop;
    if (chosen.untilInputEnds) stopAtInputEnd();
    const Listener listener(chosen.path);
    ServedGraphics graphics;
    (void)graphics.renderer();  // Without OpenGL, the command ends here.
    const Museum museum{allExhibits()};
    OwnState state(museum.readTables(museum.initialSceneState()).sceneState);
    Service service(museum, state, graphics);
    Server server(listener, service, std::chrono::duration<double>(chosen.idleSeconds),
                  {StopSignal::stopped, StopSignal::descriptor()});
    std::printf("vitrine: serving at %s\n", chosen.path.c_str());
    std::fflush(stdout);
    server.run();
    return 0;
}

}  // namespace

void addServeCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "serve", "Answer tools and notebooks of the same user over a local socket, in JSON-RPC; no network");
    auto options = std::make_shared<ServeOptions>();
    command
        ->add_option("--socket", options->path,
                     "Path of the socket to listen on. Only its owner can connect; it is removed when the service ends")
        ->required();
    addNumber(*command, "--idle-seconds", options->idleSeconds, {0, 1e9, Unit::second},
              "Seconds without a request after which a connection is closed for a new one if the limit of connections "
              "is reached")
        ->capture_default_str();
    command->footer(serveFooter);
    command->add_flag("--until-input-ends", options->untilInputEnds,
                      "Stop when standard input ends, which is when the program that started this one ends");
    command->callback([&chosen, options] { chosen = [options] { return serve(*options); }; });
}

}  // namespace vitrine::app
