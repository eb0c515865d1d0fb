#pragma once

#include <QString>

namespace vitrine::ui {

/// Opens the file's folder in the desktop's file manager. The file is selected if the file manager supports that
/// (freedesktop.org, File Manager D-Bus Interface). Does not block.
void showInFolder(const QString& file);

}  // namespace vitrine::ui
