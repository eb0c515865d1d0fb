#pragma once

#include <string>
#include <vector>

namespace vitrine::ui {

/// Whether there is a display to open a window on (DISPLAY or WAYLAND_DISPLAY, or a platform named in
/// QT_QPA_PLATFORM). Asked before QApplication, which would abort.
[[nodiscard]] bool hasDisplay();

/// `runWindow` returns this after one sentence on standard error when `hasDisplay` is false: `app` then
/// decides what to do without one.
inline constexpr int noDisplay = 64;

/// Opens the workbench with `files` put where they belong and runs it until it is closed. Returns the exit code: 3
/// without OpenGL 4.5, with one sentence on standard error. Throws Failure when the museum cannot be built.
[[nodiscard]] int runWindow(int& argc, char** argv, const std::vector<std::string>& files = {});

}  // namespace vitrine::ui
