#pragma once

#include <cstdint>

class QApplication;
class QMenu;
class QWidget;

namespace vitrine::ui {

enum class ThemeChoice : std::uint8_t { desktop, light, dark };

/// As it was chosen last, on this machine; at first the desktop's.
[[nodiscard]] ThemeChoice savedThemeChoice();
/// Applies the theme to the whole application at once and keeps the choice. What the desktop prefers is what it
/// preferred when this was first called.
void chooseTheme(QApplication&, ThemeChoice);

/// "Theme": as the desktop, light, dark.
[[nodiscard]] QMenu* themeMenu(QWidget* parent);

}  // namespace vitrine::ui
