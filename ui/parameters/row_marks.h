#pragma once

class QPainter;
class QPointF;

namespace vitrine::ui {

/// Paints a padlock around this point, as large as a lowercase letter. It marks what is locked against varying.
void paintPadlock(QPainter&, const QPointF& middle);

}  // namespace vitrine::ui
