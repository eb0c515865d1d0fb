#include "ui/window/focus_areas.h"

#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_controller.h"
#include "ui/kit/message_strip.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QStatusBar>

#include <algorithm>

namespace vitrine::ui {
namespace {

bool takesFocus(const QWidget& widget)
{
    return (widget.focusPolicy() & Qt::TabFocus) && widget.isVisible() && widget.isEnabled() && !widget.focusProxy();
}

/// Returns the widget that gets the focus in an area: the one that had it last, or else the first Tab stop. Null: none.
QWidget* stopIn(QWidget& area)
{
    if (takesFocus(area)) return &area;
    if (const auto* dock = qobject_cast<QDockWidget*>(&area))  // The title bar comes after the dock's content.
        if (QWidget* stop = dock->widget() ? stopIn(*dock->widget()) : nullptr) return stop;
    QWidget* last = area.focusWidget();
    if (last && area.isAncestorOf(last) && takesFocus(*last)) return last;
    for (QWidget* next = area.nextInFocusChain(); next != &area; next = next->nextInFocusChain())
        if (area.isAncestorOf(next) && takesFocus(*next)) return next;
    return nullptr;
}

/// Returns the docks in reading order: from left to right, and from top to bottom.
QList<QWidget*> docksInOrder(const MainWindow& window)
{
    QList<QWidget*> docks;
    for (QDockWidget* dock : window.docks().all())
        if (dock->isVisible() && !dock->visibleRegion().isEmpty()) docks << dock;
    std::stable_sort(docks.begin(), docks.end(), [](const QWidget* a, const QWidget* b) {
        const QPoint p = a->mapToGlobal(QPoint(0, 0)), q = b->mapToGlobal(QPoint(0, 0));
        return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
    });
    return docks;
}

}  // namespace

void focusNextArea(MainWindow& window, int step)
{
    QList<QWidget*> areas{&window.viewport()};
    areas << &window.lessons().bar() << window.centralWidget()->findChild<MessageStrip*>()
          << &window.comparison().bar();
    areas << docksInOrder(window) << window.statusBar();
    areas.removeIf([](QWidget* area) { return !area || !area->isVisible() || !stopIn(*area); });
    if (areas.isEmpty()) return;
    const QWidget* now = QApplication::focusWidget();
    const auto at = std::find_if(areas.begin(), areas.end(), [now](const QWidget* area) {
        return now && (area == now || area->isAncestorOf(now));
    });
    const qsizetype count = areas.size();
    const qsizetype from = at == areas.end() ? (step > 0 ? -1 : 0) : at - areas.begin();
    QWidget* area = areas[(from + step + count) % count];
    area->window()->activateWindow();  // The dock may be floating.
    stopIn(*area)->setFocus(Qt::TabFocusReason);
}

}  // namespace vitrine::ui
