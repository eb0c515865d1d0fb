#pragma once

#include <QStringList>

namespace vitrine::ui {

/// Returns the paths of the presets of all exhibits that were loaded or saved last, the newest first: as many as are
/// kept of recent files, and at most six. They are stored with the window's layout. Presets that no longer exist are
/// left out.
[[nodiscard]] QStringList recentPresets();
/// Puts a preset first.
void addRecentPreset(const QString& path);
/// Replaces the path of a preset that was renamed.
void renameRecentPreset(const QString& before, const QString& after);

}  // namespace vitrine::ui
