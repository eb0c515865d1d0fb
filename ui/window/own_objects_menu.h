#pragma once

class QMenu;

namespace vitrine::ui {

class MainWindow;

/// Returns the menu "Your objects" with the visitor's own objects in the hall, which can be visited or removed.
[[nodiscard]] QMenu* ownObjectsMenu(MainWindow&);

}  // namespace vitrine::ui
