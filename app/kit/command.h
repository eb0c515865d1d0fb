#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Function that `main` runs after reading the command line. Returns the exit code.
using Action = std::function<int()>;

/// Adds the command `open`, and its options to the program itself, which opens the window if no command is given. Takes
/// the arguments of `main`, because Qt reads its own options from them.
void addOpenCommand(CLI::App&, Action& chosen, int& argc, char** argv);
/// Refuses options of the window that were given before another command. Throws Failure (ErrorKind::usage).
void refuseWindowOptions(const CLI::App&);
/// Each function adds its command to the parser. When that command is given, parsing sets `chosen`.
void addListCommand(CLI::App&, Action& chosen);
void addTourCommand(CLI::App&, Action& chosen);
void addPresetCommand(CLI::App&, Action& chosen);
void addLessonCommand(CLI::App&, Action& chosen);
void addDoctorCommand(CLI::App&, Action& chosen);
void addCompareCommand(CLI::App&, Action& chosen);
void addCompareStudiesCommand(CLI::App&, Action& chosen);
/// `run` runs a command line, given without the program's name, and returns its exit code.
void addMergeCommand(CLI::App&, Action& chosen, const std::function<int(const std::vector<std::string>&)>& run);
void addServeCommand(CLI::App&, Action& chosen);
void addSceneCommand(CLI::App&, Action& chosen);
void addShaderCommand(CLI::App&, Action& chosen);

}  // namespace vitrine::app
