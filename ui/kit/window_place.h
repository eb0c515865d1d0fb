#pragma once

class QByteArray;
class QWidget;

namespace vitrine::ui {

/// Restores what `QWidget::saveGeometry` kept of a window, and fits it into the screen that it is on now: a place that
/// was kept on a larger screen would leave its edges and its close button out of reach.
void restorePlace(QWidget& window, const QByteArray& kept);

}  // namespace vitrine::ui
