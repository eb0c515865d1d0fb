#pragma once

#include <QCursor>
#include <QTest>
#include <QWidget>

namespace vitrine::test {

/// Moves the pointer to this place. The real pointer is moved, too, because its next event at another place would
/// report that it has left the widget.
inline void pointAt(QWidget& widget, const QPoint& place)
{
    QCursor::setPos(widget.mapToGlobal(place));
    QTest::mouseMove(&widget, place);
}

}  // namespace vitrine::test
