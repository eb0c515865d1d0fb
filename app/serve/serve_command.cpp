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

#include <chrono>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

std::string serveFooter()
{
    return "JSON-RPC 2.0, one object a line, params by name; all connections share one look. Methods:\n" +
           Service::methodsText() +
           "  events    notifications of progress and of changes by other connections; {off: true}: no more\n"
           "  cancel    {id}: stops that request of this connection at its next step; without it, all of them\n"
           "Params that a command has too are its options, with underscores for dashes. SIGTERM ends the server.";
}

int serve(const std::string& path, double idleSeconds)
{
    const StopSignal stop;
    const Listener listener(path);
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    Service service(museum, renderer, context.info());
    Server server(listener, service, std::chrono::duration<double>(idleSeconds));
    std::printf("vitrine: serving at %s\n", path.c_str());
    std::fflush(stdout);
    server.run();
    return 0;
}

}  // namespace

void addServeCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "serve", "Answer tools and notebooks of the same user over a local socket, in JSON-RPC; no network");
    auto path = std::make_shared<std::string>();
    command
        ->add_option("--socket", *path,
                     "Path of the socket to listen on. Only its owner can connect; it is removed when the service ends")
        ->required();
    auto idle = std::make_shared<double>(60);
    addNumber(*command, "--idle-seconds", *idle, {0, 1e9, Unit::second},
              "Seconds without a request after which a connection is closed for a new one if the limit of connections "
              "is reached")
        ->capture_default_str();
    command->footer(serveFooter);
    command->callback([&chosen, path, idle] { chosen = [path, idle] { return serve(*path, *idle); }; });
}

}  // namespace vitrine::app
