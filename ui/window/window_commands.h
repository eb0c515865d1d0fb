#pragma once

#include <QList>

#include <functional>
#include <memory>

class QAction;

namespace vitrine::ui {

class MainWindow;

/// Commands of the window that its parts refer to. Whoever makes the window makes them, so that the window does not
/// depend on what they do.
struct WindowCommands {
    virtual ~WindowCommands() = default;

    QList<QAction*> all;
    QAction* panels = nullptr;
    QAction* fullScreen = nullptr;
    QAction* pause = nullptr;
    QAction* savePreset = nullptr;
    QAction* savePresetAs = nullptr;
    QList<QAction*> presetMenu;
};

/// Makes the commands of a window whose parts exist. Never returns null.
using MakesCommands = std::function<std::unique_ptr<WindowCommands>(MainWindow&)>;

}  // namespace vitrine::ui
