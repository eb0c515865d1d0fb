#include "ui/parameters/row_marks.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace vitrine::ui {

void paintPadlock(QPainter& painter, const QPointF& middle)
{
    painter.setPen(QPen(theme().dim, 1.3));
    painter.drawArc(QRectF(middle.x() - 2.5, middle.y() - 6, 5, 7), 0, 180 * 16);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().dim);
    painter.drawRoundedRect(QRectF(middle.x() - 4, middle.y() - 2.5, 8, 6), 1, 1);
}

}  // namespace vitrine::ui
