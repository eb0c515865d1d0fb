#pragma once

class QMenu;

namespace vitrine::ui {

class MainWindow;

/// Gives the focus to the next part of the window (1), or the one before (-1): the picture, the lines over and below
/// it, the panels that can be seen, the clock, and the picture again. Where a part had the focus before, it comes back.
void focusNextArea(MainWindow&, int step);

/// The entries of a menu that do to the panel with the focus what the mouse does with its title and its edges: it goes
/// to another side of the window, and is made larger and smaller.
[[nodiscard]] QMenu* panelMenu(MainWindow&);

}  // namespace vitrine::ui
