#pragma once

class QByteArray;
class QWidget;

namespace vitrine::ui {

/// Restores a window's geometry as saved by `QWidget::saveGeometry`, and fits it into the present screen: otherwise a
/// place saved on a larger screen could leave its close button out of reach. `before`: number of windows that are
/// already open; the window is offset from them.
void restorePlace(QWidget& window, const QByteArray& kept, int before = 0);

}  // namespace vitrine::ui
