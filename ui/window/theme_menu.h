#pragma once

class QMenu;
class QWidget;

namespace vitrine::ui {

class Preferences;

/// "Theme": as the desktop, light, dark, high contrast; the preferences must outlive it.
[[nodiscard]] QMenu* themeMenu(QWidget* parent, Preferences&);

}  // namespace vitrine::ui
