#include "ui/kit/context_key.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>

namespace vitrine::ui {
namespace {

/// Returns the position of the widget's context menu: on the selected entry, or in the middle.
QPoint placeIn(const QWidget& widget)
{
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    if (!view || !view->currentIndex().isValid()) return widget.rect().center();
    const QPoint place = view->visualRect(view->currentIndex()).center();
    return view->viewport()->mapTo(view, place);
}

}  // namespace

ContextKey::ContextKey(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool ContextKey::open(QWidget& widget)
{
    const QPoint place = placeIn(widget);
    QContextMenuEvent event(QContextMenuEvent::Keyboard, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &event);
    return true;
}

bool ContextKey::eventFilter(QObject* object, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget) return false;
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        return key.key() == Qt::Key_F10 && key.modifiers() == Qt::ShiftModifier && open(*widget);
    }
    if (event->type() != QEvent::ContextMenu) return false;
    const auto& asked = *static_cast<QContextMenuEvent*>(event);
    const bool list = qobject_cast<QAbstractItemView*>(widget) != nullptr;
    return list && asked.reason() == QContextMenuEvent::Keyboard && asked.pos() != placeIn(*widget) && open(*widget);
}

}  // namespace vitrine::ui

#include "moc_context_key.cpp"
