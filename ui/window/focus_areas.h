#pragma once

namespace vitrine::ui {

class MainWindow;

/// Gives the focus to the next area of the window (1), or the one before (-1): the picture, the bars above and below
/// it, visible docks, the clock. An area that had the focus before focuses the same widget again.
void focusNextArea(MainWindow&, int step);

}  // namespace vitrine::ui
