#include "ui/window/focus_areas.h"

#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_desk.h"
#include "ui/kit/message_strip.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_desk.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QPointer>
#include <QStatusBar>

#include <algorithm>
#include <functional>

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

/// Returns the dock that has the focus; null: none.
QDockWidget* dockWithFocus(const MainWindow& window)
{
    const QWidget* now = QApplication::focusWidget();
    for (QDockWidget* dock : window.docks().all())
        if (now && dock->isAncestorOf(now)) return dock;
    return nullptr;
}

constexpr int growth = 40;  // Pixels by which a panel grows and shrinks.

}  // namespace

QMenu* panelMenu(MainWindow& window)
{
    auto* menu = new QMenu(MainWindow::tr("&Move panel"), &window);
    const auto add = [&](const QString& text, const std::function<void(QDockWidget&)>& work) {
        menu->addAction(text, &window, [&window, work] {
            if (QDockWidget* dock = dockWithFocus(window)) work(*dock);
        });
    };
    const auto addSide = [&](const QString& text, Qt::DockWidgetArea side) {
        add(text, [&window, side](QDockWidget& dock) {
            // Moving the dock takes the focus from its content.
            const QPointer<QWidget> focus = QApplication::focusWidget();
            dock.setFloating(false);
            window.addDockWidget(side, &dock);
            if (focus) focus->setFocus(Qt::OtherFocusReason);
        });
    };
    const auto addSize = [&](const QString& text, Qt::Orientation along, int by) {
        add(text, [&window, along, by](QDockWidget& dock) {
            window.resizeDocks({&dock}, {(along == Qt::Horizontal ? dock.width() : dock.height()) + by}, along);
        });
    };
    addSide(MainWindow::tr("To the &left"), Qt::LeftDockWidgetArea);
    addSide(MainWindow::tr("To the &right"), Qt::RightDockWidgetArea);
    addSide(MainWindow::tr("To the &bottom"), Qt::BottomDockWidgetArea);
    menu->addSeparator();
    addSize(MainWindow::tr("&Wider"), Qt::Horizontal, growth);
    addSize(MainWindow::tr("&Narrower"), Qt::Horizontal, -growth);
    addSize(MainWindow::tr("&Taller"), Qt::Vertical, growth);
    addSize(MainWindow::tr("&Shorter"), Qt::Vertical, -growth);
    // The entries need a dock with the focus.
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &window] {
        for (QAction* each : menu->actions()) each->setEnabled(dockWithFocus(window) != nullptr);
    });
    return menu;
}

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
