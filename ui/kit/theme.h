#pragma once

#include <QColor>

class QApplication;

namespace vitrine::ui {

/// The program's own colors: neutral, dark or light, as the desktop asks.
struct Theme {
    bool dark = true;
    QColor window, base, text, dim, accent, error, good;
    QColor outline;  ///< Of fields and buttons: 3:1 against window and base, as WCAG 2.2 (1.4.11) asks of what tells a
                     ///< control from its surroundings.
};

[[nodiscard]] Theme darkTheme();
[[nodiscard]] Theme lightTheme();

/// The theme in use, set by `applyTheme`.
[[nodiscard]] const Theme& theme();

/// Fusion style with the theme's palette, for the whole application.
void applyTheme(QApplication&, const Theme&);

/// Whether the desktop's own palette is dark; ask before `applyTheme` replaces it.
[[nodiscard]] bool desktopPrefersDark(const QApplication&);

}  // namespace vitrine::ui
