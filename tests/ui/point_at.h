#pragma once

#include <QCursor>
#include <QTest>
#include <QWidget>

namespace vitrine::test {

/// Lets the pointer rest there. The real one goes there, too: wherever else it stood, the next event of its own would
/// tell the widget that the pointer has left.
inline void pointAt(QWidget& widget, const QPoint& place)
{
    QCursor::setPos(widget.mapToGlobal(place));
    QTest::mouseMove(&widget, place);
}

}  // namespace vitrine::test
