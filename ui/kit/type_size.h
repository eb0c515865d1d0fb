#pragma once

#include <functional>

class QFontMetrics;
class QWidget;

namespace vitrine::ui {

/// Pixels for what has so many beside type of the usual size: more beside larger type, never fewer.
[[nodiscard]] int grown(int pixels, const QFontMetrics&);
/// The same beside this widget's type.
[[nodiscard]] int grown(int pixels, const QWidget&);

/// Calls `work` now and whenever the widget's type gets another size. It must not be called after the widget's end.
void followType(QWidget& widget, std::function<void()> work);

/// These sizes are pixels beside type of the usual size, and grow with the widget's type.
void growHeight(QWidget& widget, int fixed);
void growWidth(QWidget& widget, int fixed);
void growSize(QWidget& widget, int fixedWidth, int fixedHeight);
void growMinimumWidth(QWidget& widget, int least);
void growMinimumSize(QWidget& widget, int leastWidth, int leastHeight);

}  // namespace vitrine::ui
