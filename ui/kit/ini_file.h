#pragma once

#include <QString>

namespace vitrine::ui {

/// Returns the path to give to QSettings: `path` itself if it is a regular file of at most 4 MiB, or does not exist.
/// Otherwise (a pipe, on which reading would block, a folder, a device) returns a path that cannot exist, so that no
/// setting is read or written.
[[nodiscard]] QString iniPath(const QString& path);

}  // namespace vitrine::ui
