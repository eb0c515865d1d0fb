#include "ui/kit/tab_order.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QGridLayout>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

namespace vitrine::ui {
namespace {

void collect(QWidget& widget, QList<QWidget*>& stops);

/// Returns the items of a layout in reading order.
QList<QLayoutItem*> itemsOf(QLayout& layout)
{
    QList<QLayoutItem*> items;
    for (int i = 0; i < layout.count(); ++i) items << layout.itemAt(i);
    auto* grid = qobject_cast<QGridLayout*>(&layout);
    if (!grid) return items;
    const auto placeOf = [grid](int i) {
        int row = 0, column = 0, rows = 0, columns = 0;
        grid->getItemPosition(i, &row, &column, &rows, &columns);
        return std::pair(row, column);
    };
    QList<int> order;
    for (int i = 0; i < grid->count(); ++i) order << i;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return placeOf(a) < placeOf(b); });
    for (int i = 0; i < order.size(); ++i) items[i] = grid->itemAt(order[i]);
    return items;
}

void collect(QLayout& layout, QList<QWidget*>& stops)
{
    for (QLayoutItem* item : itemsOf(layout)) {
        if (QLayout* inner = item->layout())
            collect(*inner, stops);
        else if (QWidget* widget = item->widget())
            collect(*widget, stops);
    }
}

void collect(QWidget& widget, QList<QWidget*>& stops)
{
    if (auto* area = qobject_cast<QScrollArea*>(&widget)) {
        if (QWidget* inside = area->widget()) collect(*inside, stops);
    } else if (auto* split = qobject_cast<QSplitter*>(&widget)) {
        for (int i = 0; i < split->count(); ++i) collect(*split->widget(i), stops);
    } else if (auto* tabs = qobject_cast<QTabWidget*>(&widget)) {
        stops << tabs->tabBar();
        for (int i = 0; i < tabs->count(); ++i) collect(*tabs->widget(i), stops);
    } else if (widget.focusPolicy() & Qt::TabFocus) {
        stops << &widget;
    } else if (widget.layout()) {
        collect(*widget.layout(), stops);
    }
}

/// Returns the widgets that take the focus, in reading order.
QList<QWidget*> ordered(QWidget& root)
{
    QList<QWidget*> stops;
    collect(root, stops);
    for (int i = 0; i + 1 < stops.size(); ++i) QWidget::setTabOrder(stops[i], stops[i + 1]);
    return stops;
}

}  // namespace

void tabAsLaidOut(QWidget& root)
{
    ordered(root);
}

TabOrder::TabOrder(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool TabOrder::eventFilter(QObject* object, QEvent* event)
{
    // On the first polish the dialog's content may be incomplete, so the order is set when it is shown.
    if (event->type() != QEvent::Show || event->spontaneous()) return false;
    auto* dialog = qobject_cast<QDialog*>(object);
    if (!dialog || dialog->inherits("QFileDialog") || dialog->inherits("QMessageBox")) return false;
    const QList<QWidget*> stops = ordered(*dialog);
    const auto first = std::ranges::find_if(
        stops, [dialog](const QWidget* stop) { return stop->isEnabled() && stop->isVisibleTo(dialog); });
    if (!dialog->focusWidget() && first != stops.end()) (*first)->setFocus(Qt::OtherFocusReason);
    return false;
}

}  // namespace vitrine::ui

#include "moc_tab_order.cpp"
