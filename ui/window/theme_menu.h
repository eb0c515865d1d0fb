#pragma once

class QMenu;
class QWidget;

namespace vitrine::ui {

class Preferences;

/// Returns the menu "Theme": as the desktop, light, dark, high contrast. The preferences must outlive it.
[[nodiscard]] QMenu* themeMenu(QWidget* parent, Preferences&);

}  // namespace vitrine::ui
