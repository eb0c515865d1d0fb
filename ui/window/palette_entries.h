#pragma once

#include <QList>

class QAction;
class QObject;

namespace vitrine::ui {

class MainWindow;

/// What the palette finds: these commands, then what menus have beside them (themes, languages), presets of the exhibit
/// on show, and parameters of all exhibits. Entries that are no commands are children of `owner`.
[[nodiscard]] QList<QAction*> paletteEntries(MainWindow&, const QList<QAction*>& commands, QObject& owner);

}  // namespace vitrine::ui
