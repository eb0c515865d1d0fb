#pragma once

#include <QApplication>
#include <QImage>
#include <QList>
#include <QTest>
#include <QWidget>

namespace vitrine::test {

/// Widgets that Tab visits within `root`, and errors, a line each.
struct KeyboardWalk {
    QList<QWidget*> stops;
    QStringList complaints;
};

[[nodiscard]] inline QString nameOf(const QWidget& widget)
{
    return QStringLiteral("%1 \"%2\"").arg(widget.metaObject()->className(), widget.accessibleName());
}

[[nodiscard]] inline bool isStop(const QWidget& widget)
{
    return (widget.focusPolicy() & Qt::TabFocus) && widget.isVisible() && widget.isEnabled() && !widget.focusProxy() &&
           !widget.inherits("QScrollArea") &&
           (widget.inherits("QTabBar") || !widget.objectName().startsWith(QLatin1String("qt_")));
}

/// Returns whether the second rectangle comes before the first in reading order, from left to right and from top to
/// bottom.
[[nodiscard]] inline bool goesBack(const QRect& from, const QRect& to)
{
    const QRect line(to.x(), from.y(), 1, from.height()), column(from.x(), to.y(), from.width(), 1);
    const bool sameLine = std::min(from.bottom(), to.bottom()) - std::max(from.top(), to.top()) >=
                          std::min(from.height(), to.height()) / 2;
    const bool sameColumn = from.left() <= to.right() && to.left() <= from.right();
    return (sameLine && to.right() < from.left()) || (sameColumn && to.bottom() < from.top());
}

/// Returns whether the widget and its surroundings look different with the focus.
[[nodiscard]] inline bool showsFocus(QWidget& widget)
{
    QWidget* window = widget.window();
    const QRect there(widget.mapTo(window, QPoint(-2, -2)), widget.size() + QSize(4, 4));
    const QImage with = window->grab(there).toImage();
    widget.clearFocus();
    const QImage without = window->grab(there).toImage();
    widget.setFocus(Qt::TabFocusReason);
    return with != without;
}

/// Walks through `root` with the Tab key, from its first stop until it leaves or returns.
[[nodiscard]] inline KeyboardWalk walkByTab(QWidget& root)
{
    KeyboardWalk walk;
    QList<QWidget*> wanted;
    for (QWidget* each : root.findChildren<QWidget*>())
        if (isStop(*each) && each->window() == root.window()) wanted << each;
    // A dialog begins where it sets the focus.
    QWidget* first = root.isWindow() && wanted.contains(root.focusWidget()) ? root.focusWidget() : nullptr;
    for (QWidget* next = root.nextInFocusChain(); next != &root && !first; next = next->nextInFocusChain())
        if (wanted.contains(next)) first = next;
    if (!first) return walk;
    first->setFocus(Qt::TabFocusReason);
    QWidget* before = nullptr;
    for (int i = 0; i < 600; ++i) {
        QWidget* now = QApplication::focusWidget();
        if (now && now == before && now->inherits("QTextBrowser")) {  // From link to link within a page.
            QTest::keyClick(now, Qt::Key_Tab);
            continue;
        }
        if (!now || !root.isAncestorOf(now) || walk.stops.contains(now)) break;
        walk.stops << now;
        const auto place = [&](QWidget* widget) { return QRect(widget->mapTo(&root, QPoint(0, 0)), widget->size()); };
        if (before && goesBack(place(before), place(now)))
            walk.complaints << QStringLiteral("Tab goes back from %1 to %2").arg(nameOf(*before), nameOf(*now));
        if (!showsFocus(*now)) walk.complaints << nameOf(*now) + QStringLiteral(" does not show the focus");
        before = now;
        QTest::keyClick(now, Qt::Key_Tab);
    }
    for (QWidget* each : wanted)
        if (isStop(*each) && !walk.stops.contains(each) && !qobject_cast<QWidget*>(each)->inherits("QRadioButton"))
            walk.complaints << nameOf(*each) + QStringLiteral(" is not reached");
    return walk;
}

}  // namespace vitrine::test
