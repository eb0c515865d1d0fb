#pragma once

#include <QStringList>

class QMenu;

namespace vitrine::ui {

class FileOpener;

/// The files that were opened last, the newest first, kept with the window's layout; as many as the preferences say.
[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
/// Forgets all but the newest so many.
void keepRecentFiles(int most);
/// Lists them anew whenever it opens, and clears the list.
[[nodiscard]] QMenu* recentMenu(QWidget* parent, FileOpener&);

}  // namespace vitrine::ui
