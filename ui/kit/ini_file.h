#pragma once

#include <QString>

namespace vitrine::ui {

/// The path to give to QSettings: this one where a regular file of at most 4 MiB is there, or nothing. In place of all
/// else (a pipe, on which reading would wait for good, a folder, a device) a path at which nothing can be, so that no
/// setting is found, and none is kept.
[[nodiscard]] QString iniPath(const QString& path);

}  // namespace vitrine::ui
