#pragma once

#include "ui/window/kiosk.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

class MainWindow;

/// How the window is opened.
struct WindowOptions {
    std::vector<std::string> files = {};     ///< Opened as if they were dropped onto it.
    std::optional<KioskOptions> kiosk = {};  ///< Shows the window for an exhibition.
    /// Called when the window is shown; empty: nothing is. What it returns is destroyed before the window.
    std::function<std::shared_ptr<void>(MainWindow&)> opened = {};
};

/// Returns whether there is a display for a window (DISPLAY or WAYLAND_DISPLAY, or a platform named in
/// QT_QPA_PLATFORM). Call before QApplication, which would abort.
[[nodiscard]] bool hasDisplay();

/// Exit code of `runWindow` if `hasDisplay` is false, after one sentence on standard error. `app` then decides what to
/// do.
inline constexpr int noDisplay = 64;

/// Opens the window and runs it until it is closed. Returns the exit code: 3 without OpenGL 4.5, with one
/// sentence on standard error. Throws Failure if the museum cannot be built.
[[nodiscard]] int runWindow(int& argc, char** argv, const WindowOptions& = {});

}  // namespace vitrine::ui
