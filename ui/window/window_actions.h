#pragma once

#include "ui/window/window_commands.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace vitrine::ui {

class CompareActions;
class MainWindow;
class PresetController;

/// All commands of the window, with their shortcuts. Menus, search and shortcut sheet are made from them.
struct WindowActions final : WindowCommands {
    explicit WindowActions(MainWindow&);

private:
    /// Action that is enabled only while it has something to do.
    struct Conditional {
        QAction* action;
        std::function<QString()> whyNot;  ///< Tooltip while it is disabled; empty: it is enabled.
        QString tip;                      ///< Tooltip while it is enabled.
    };

    void enableOnly(QAction*, std::function<bool()> possible, const QString& why);
    /// Disables the action while `whyNot` returns a text.
    void enableUnless(QAction*, std::function<QString()> whyNot);
    /// Enables or disables the conditional actions.
    void refresh() const;
    void watch(MainWindow&) const;

    class Maker;
    void addFileMenu(Maker&, MainWindow&);
    void addSaving(Maker&, MainWindow&);
    void addEditMenu(Maker&, MainWindow&);
    void addPresetMenu(Maker&, PresetController&);
    void addViewMenu(Maker&, MainWindow&);
    void addScreenAndClock(Maker&, MainWindow&);
    void addCompareMenu(Maker&, const CompareActions&);
    void addExhibitMenu(Maker&, MainWindow&);
    void addBookmarks(Maker&, MainWindow&);
    void addHelpMenu(Maker&, MainWindow&);
    void addWithoutMenu(Maker&, MainWindow&);

    std::vector<Conditional> conditional_;
    /// Declared last, so that it is destroyed first: later signals of the window's parts are not received.
    QObject watching_;
};

/// Makes all commands. For the window's constructor.
[[nodiscard]] std::unique_ptr<WindowCommands> makeWindowActions(MainWindow&);

}  // namespace vitrine::ui
