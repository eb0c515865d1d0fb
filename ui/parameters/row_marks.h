#pragma once

class QPainter;
class QPointF;

namespace vitrine::ui {

/// A padlock about this point, as large as a small letter: what it stands beside is locked against varying.
void paintPadlock(QPainter&, const QPointF& middle);

}  // namespace vitrine::ui
