#pragma once

#include "ui/window/search_dialog.h"

#include <QList>

#include <vector>

class QAction;

namespace vitrine::ui {

class MainWindow;

/// Returns the parameters and presets of all exhibits, the pages about them, the commands that are enabled now, and the
/// choices of menus, such as themes. Presets that were used lately are marked as recent.
[[nodiscard]] std::vector<SearchEntry> searchEntries(MainWindow&, const QList<QAction*>& commands);

}  // namespace vitrine::ui
