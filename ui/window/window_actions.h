#pragma once

#include <QList>

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
    class Maker;
    void addFileMenu(Maker&, MainWindow&);
    void addEditMenu(Maker&, MainWindow&);
    void addPresetMenu(Maker&, PresetShelf&);
    void addViewMenu(Maker&, MainWindow&);
    void addScreenAndClock(Maker&, MainWindow&);
    void addCompareMenu(Maker&, const CompareActions&);
    void addExhibitMenu(Maker&, MainWindow&);
    void addBookmarkMenu(Maker&, MainWindow&);
    void addLessonMenu(Maker&, const LessonDesk&);
    void addHelpMenu(Maker&, MainWindow&);
};

}  // namespace vitrine::ui
