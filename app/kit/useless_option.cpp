#include "app/kit/useless_option.h"

#include "app/kit/picture_options.h"
#include "render/failure.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

bool isGiven(const CLI::App& command, const std::string& name)
{
    const CLI::Option* option = command.get_option_no_throw(name);
    return option && option->count() > 0;
}

}  // namespace

void refuseWithout(const CLI::App& command, const std::string& option, bool acts, const std::string& other)
{
    if (!acts && isGiven(command, option))
        throw Failure(ErrorKind::usage,
                      option + " has no effect without " + other + "; leave it out, or give that too.");
}

void refuseOn(const CLI::App& command, const std::string& option, bool idle, const std::string& what)
{
    if (idle && isGiven(command, option))
        throw Failure(ErrorKind::usage, option + " has no effect on " + what + "; leave it out.");
}

void refuseUselessSceneOptions(const CLI::App& command, const PictureOptions& o)
{
    refuseWithout(command, "--settings-only", !o.preset.empty(), "--preset");
    for (const char* option : {"--rotate", "--scale"})
        refuseOn(command, option, o.subject == "hall", "the hall as a whole");
    refuseOn(command, "--model", o.alone, "an exhibit that is shown --alone");
}

}  // namespace vitrine::app
