#pragma once

#include <QStringList>

class QMenu;

namespace vitrine::ui {

class FileOpener;

/// Returns the files opened last, the newest first; as many as the preferences allow. They are stored with the window's
/// layout.
[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
/// Removes all but the newest `most` files.
void keepRecentFiles(int most);
/// Returns a menu of recent files, filled whenever it opens, with an entry that clears the list.
[[nodiscard]] QMenu* recentMenu(QWidget* parent, FileOpener&);

}  // namespace vitrine::ui
