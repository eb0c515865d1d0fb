#pragma once

class QMenu;

namespace vitrine::ui {

class MainWindow;

/// "Your objects": those of the visitor's own that the hall names, each to be visited or removed.
[[nodiscard]] QMenu* ownObjectsMenu(MainWindow&);

}  // namespace vitrine::ui
