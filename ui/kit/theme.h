#pragma once

#include <QColor>

class QApplication;

namespace vitrine::ui {

/// Colors of the program: neutral, in a dark or a light variant.
struct Theme {
    bool dark = true;
    QColor window, base, text, dim, accent, error, good;
    /// Edge of fields and buttons. Its contrast to window and base is 3:1, as WCAG 2.2 (1.4.11) requires.
    QColor outline;
    /// All text has a contrast of at least 7:1 (WCAG 2.2, 1.4.6), and nothing important is faint.
    bool highContrast = false;

    bool operator==(const Theme&) const = default;
};

[[nodiscard]] Theme darkTheme();
[[nodiscard]] Theme lightTheme();
/// Theme with high contrast, on a dark or a light background.
[[nodiscard]] Theme highContrastTheme(bool dark);

/// Light theme on white, for charts in documents.
[[nodiscard]] Theme paperTheme();

/// Returns the theme in use, as set by `applyTheme` or a `ThemeScope`.
[[nodiscard]] const Theme& theme();

/// Makes `theme()` return another theme while this object lives. Widgets keep their palette.
class ThemeScope {
public:
    explicit ThemeScope(const Theme&);
    ~ThemeScope();
    ThemeScope(const ThemeScope&) = delete;
    ThemeScope& operator=(const ThemeScope&) = delete;

private:
    Theme before_;
};

/// Returns the contrast ratio of two opaque colors by WCAG 2.2: from 1 (equal) to 21 (black and white).
[[nodiscard]] double contrastOf(const QColor&, const QColor&);

/// Applies the theme's palette and the program's style to the whole application.
void applyTheme(QApplication&, const Theme&);

/// Returns whether the desktop's palette is dark. Call before `applyTheme`, which replaces the palette.
[[nodiscard]] bool desktopPrefersDark(const QApplication&);

}  // namespace vitrine::ui
