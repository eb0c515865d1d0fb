#pragma once

#include "app/kit/command.h"

namespace vitrine::app {

/// Adds a command for each job, with an option for each of its parameters. Groups of commands must be there.
void addJobCommands(CLI::App&, Action& chosen);

}  // namespace vitrine::app
