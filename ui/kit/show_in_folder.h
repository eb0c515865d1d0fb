#pragma once

#include <QString>

namespace vitrine::ui {

/// Opens the desktop's file manager on the folder of this file, with the file selected where the file manager knows how
/// to (freedesktop.org, File Manager D-Bus Interface), else the folder alone. Does not block.
void showInFolder(const QString& file);

}  // namespace vitrine::ui
