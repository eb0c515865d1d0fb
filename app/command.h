#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// What `main` runs once the command line is read; its result is the exit code.
using Action = std::function<int()>;

/// Opens the window with these files; the exit code.
int openWindow(int& argc, char** argv, const std::vector<std::string>& files);
/// Takes the arguments of `main`, of which Qt has its own.
void addOpenCommand(CLI::App&, Action& chosen, int& argc, char** argv);
/// Each adds its sub-commands to the parser; the one that was given sets `chosen`.
void addListCommand(CLI::App&, Action& chosen);
void addRenderCommand(CLI::App&, Action& chosen);
void addTourCommand(CLI::App&, Action& chosen);
void addRecordCommand(CLI::App&, Action& chosen);
void addPresetCommand(CLI::App&, Action& chosen);
void addLessonCommand(CLI::App&, Action& chosen);
void addDoctorCommand(CLI::App&, Action& chosen);
void addCompareCommand(CLI::App&, Action& chosen);
void addCompareSettingsCommand(CLI::App&, Action& chosen);
void addStudyCommand(CLI::App&, Action& chosen);
void addCompareStudiesCommand(CLI::App&, Action& chosen);
/// `run` runs a command line, given without the program's name, and returns its exit code.
void addMergeCommand(CLI::App&, Action& chosen, const std::function<int(const std::vector<std::string>&)>& run);
void addPrintCommand(CLI::App&, Action& chosen);
void addProofCommand(CLI::App&, Action& chosen);
void addServeCommand(CLI::App&, Action& chosen);
void addSceneCommand(CLI::App&, Action& chosen);
void addSpriteCommand(CLI::App&, Action& chosen);
/// To `scene`.
void addSceneMeshCommand(CLI::App&, Action& chosen);

}  // namespace vitrine::app
