#pragma once

#include <QList>

class QAction;
class QObject;

namespace vitrine::ui {

class MainWindow;

/// Returns the entries of the command palette: the commands, choices of menus (themes, languages), presets of the shown
/// exhibit, and parameters of all exhibits. Entries that are no commands are children of `owner`.
[[nodiscard]] QList<QAction*> paletteEntries(MainWindow&, const QList<QAction*>& commands, QObject& owner);

}  // namespace vitrine::ui
