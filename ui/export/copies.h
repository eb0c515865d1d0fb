#pragma once

#include <QString>

namespace vitrine::ui {

class Workbench;

/// Copies the shown picture to the clipboard.
void copyPicture(Workbench&);
/// Copies a command line to the clipboard that draws the finished picture.
void copyCommandLine(Workbench&);
/// Returns this command line.
[[nodiscard]] QString commandLineOf(Workbench&);

}  // namespace vitrine::ui
