#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QAction;

namespace vitrine::ui {

class CompareActions;
class LessonDesk;
class MainWindow;
class PresetShelf;

/// Every command of the window, each with its shortcut; the menus, the palette and the sheet are made of these.
struct WindowActions {
    explicit WindowActions(MainWindow&);

    QList<QAction*> all;
    QAction* panels = nullptr;
    QAction* fullScreen = nullptr;
    QAction* pause = nullptr;
    QAction* savePreset = nullptr;
    QAction* savePresetAs = nullptr;
    QList<QAction*> presetMenu;

private:
    /// An action that is enabled only while there is something for it to do.
    struct Conditional {
        QAction* action;
        std::function<bool()> possible;
        QString tip, why;  ///< Its tooltip while it is enabled, and while it is not.
    };

    void enableOnly(QAction*, std::function<bool()> possible, const QString& why);
    /// Enables the conditional actions by what is there now.
    void refresh() const;
    void watch(MainWindow&) const;

    class Maker;
    void addFileMenu(Maker&, MainWindow&);
    void addSaving(Maker&, MainWindow&);
    void addEditMenu(Maker&, MainWindow&);
    void addPresetMenu(Maker&, PresetShelf&);
    void addViewMenu(Maker&, MainWindow&);
    void addScreenAndClock(Maker&, MainWindow&);
    void addCompareMenu(Maker&, const CompareActions&);
    void addExhibitMenu(Maker&, MainWindow&);
    void addBookmarkMenu(Maker&, MainWindow&);
    void addLessonMenu(Maker&, const LessonDesk&);
    void addHelpMenu(Maker&, MainWindow&);

    std::vector<Conditional> conditional_;
    QObject watching_;  ///< Ends first: what the window's parts say while they go is not heard.
};

}  // namespace vitrine::ui
