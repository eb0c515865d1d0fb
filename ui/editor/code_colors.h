#pragma once

#include "ui/editor/code_view.h"
#include "ui/kit/theme.h"

#include <QFont>

class QWidget;

namespace vitrine::ui {

/// Returns the colors of code in a theme. All text has a contrast of at least 4.5:1 to its ground, and of 7:1 in the
/// themes with high contrast (WCAG 2.2, 1.4.3 and 1.4.6).
[[nodiscard]] CodeColors codeColors(const Theme&);

/// Returns the desktop's font of fixed width, as large as the font of this widget.
[[nodiscard]] QFont codeFont(const QWidget&);

}  // namespace vitrine::ui
