#pragma once

#include <functional>

class QBoxLayout;
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
/// The same, but at most this percentage of the screen's width.
void growWidth(QWidget& widget, int fixed, int mostOfScreen);
void growSize(QWidget& widget, int fixedWidth, int fixedHeight);
void growMinimumWidth(QWidget& widget, int least);
void growMinimumSize(QWidget& widget, int leastWidth, int leastHeight);

/// Returns whether the type is so large that rows of controls need several lines.
[[nodiscard]] bool isLargeType(const QWidget&);
/// Stacks the items of a row of this widget while its type is large.
void stackWhenLarge(QBoxLayout& row, QWidget&);

}  // namespace vitrine::ui
