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
    bool highContrast = false;  ///< All text is 7:1 at least (WCAG 2.2, 1.4.6), and nothing that matters is faint.

    bool operator==(const Theme&) const = default;
};

[[nodiscard]] Theme darkTheme();
[[nodiscard]] Theme lightTheme();
/// For those who tell colors apart badly, on a dark or a light ground.
[[nodiscard]] Theme highContrastTheme(bool dark);

/// The theme in use, set by `applyTheme`.
[[nodiscard]] const Theme& theme();

/// How far two opaque colors are apart in luminance, by WCAG 2.2: from 1 for equal ones to 21 for black and white.
[[nodiscard]] double contrastOf(const QColor&, const QColor&);

/// Fusion style with the theme's palette, for the whole application.
void applyTheme(QApplication&, const Theme&);

/// Whether the desktop's own palette is dark; ask before `applyTheme` replaces it.
[[nodiscard]] bool desktopPrefersDark(const QApplication&);

}  // namespace vitrine::ui
