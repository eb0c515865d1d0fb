#pragma once

#include <QStringList>

class QMenu;

namespace vitrine::ui {

class FileOpener;

/// The files that were opened last, the newest first, kept with the window's layout.
inline constexpr int mostRecentFiles = 10;
[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);
/// Lists them anew whenever it opens.
[[nodiscard]] QMenu* recentMenu(QWidget* parent, FileOpener&);

}  // namespace vitrine::ui
