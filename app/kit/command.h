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

/// Opens the window with these files. Returns the exit code.
int openWindow(int& argc, char** argv, const std::vector<std::string>& files);
/// Adds the command `open`. Takes the arguments of `main`, because Qt reads its own options from them.
void addOpenCommand(CLI::App&, Action& chosen, int& argc, char** argv);
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
