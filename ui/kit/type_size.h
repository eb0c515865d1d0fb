#pragma once

#include <functional>

class QFontMetrics;
class QWidget;

namespace vitrine::ui {

/// Scales a size in pixels from the usual font size to this font. Never returns less than `pixels`.
[[nodiscard]] int grown(int pixels, const QFontMetrics&);
/// The same for the widget's font.
[[nodiscard]] int grown(int pixels, const QWidget&);

/// Calls `work` now and whenever the widget's font size changes. `work` is not called after the widget is destroyed.
void followType(QWidget& widget, std::function<void()> work);

/// Set sizes that grow with the widget's font. Arguments are pixels at the usual font size.
void growHeight(QWidget& widget, int fixed);
void growWidth(QWidget& widget, int fixed);
void growSize(QWidget& widget, int fixedWidth, int fixedHeight);
void growMinimumWidth(QWidget& widget, int least);
void growMinimumSize(QWidget& widget, int leastWidth, int leastHeight);

}  // namespace vitrine::ui
