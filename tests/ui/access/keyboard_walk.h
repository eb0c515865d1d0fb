#pragma once

#include <QApplication>
#include <QImage>
#include <QList>
#include <QTest>
#include <QWidget>

namespace vitrine::test {

/// What the Tab key goes through within `root`, and what is wrong with it, a line each.
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

/// Whether the eye that reads from left to right and from top to bottom has to go back from one to the other.
[[nodiscard]] inline bool goesBack(const QRect& from, const QRect& to)
{
    const QRect line(to.x(), from.y(), 1, from.height()), column(from.x(), to.y(), from.width(), 1);
    const bool sameLine = std::min(from.bottom(), to.bottom()) - std::max(from.top(), to.top()) >=
                          std::min(from.height(), to.height()) / 2;
    const bool sameColumn = from.left() <= to.right() && to.left() <= from.right();
    return (sameLine && to.right() < from.left()) || (sameColumn && to.bottom() < from.top());
}

/// Whether a picture of the widget and what is close around it is another one with the focus than without.
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

/// Goes through `root` by the Tab key alone, from its first stop until it leaves it or comes back.
[[nodiscard]] inline KeyboardWalk walkByTab(QWidget& root)
{
    KeyboardWalk walk;
    QList<QWidget*> wanted;
    for (QWidget* each : root.findChildren<QWidget*>())
        if (isStop(*each) && each->window() == root.window()) wanted << each;
    // A dialog is entered where it puts the focus.
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
