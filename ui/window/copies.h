#pragma once

#include <QString>

namespace vitrine::ui {

class Workbench;

/// Puts what the picture shows on the clipboard.
void copyPicture(Workbench&);
/// Puts a line on the clipboard that draws the finished picture from a terminal.
void copyCommandLine(Workbench&);
/// That line.
[[nodiscard]] QString commandLineOf(Workbench&);

}  // namespace vitrine::ui
