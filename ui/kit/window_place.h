#pragma once

class QByteArray;
class QWidget;

namespace vitrine::ui {

/// Restores what `QWidget::saveGeometry` kept of a window, and fits it into the screen that it is on now: a place that
/// was kept on a larger screen would leave its edges and its close button out of reach. `before`: number of
/// windows that are open already; the window is offset from them.
void restorePlace(QWidget& window, const QByteArray& kept, int before = 0);

}  // namespace vitrine::ui
