#include "ui/kit/idle_undo.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace vitrine::ui {

IdleUndo::IdleUndo(QWidget* window) : QObject(window), window_(window)
{
    qApp->installEventFilter(this);
}

bool IdleUndo::belongs(const QObject* object) const
{
    // Follows parents instead of QWidget::isAncestorOf, because a floating panel is a window of its own.
    while (object && object != window_) object = object->parent();
    return object != nullptr;
}

bool IdleUndo::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* edit = qobject_cast<QLineEdit*>(object);
    if (!edit || !belongs(edit)) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool undo = key->matches(QKeySequence::Undo);
    const bool redo = key->matches(QKeySequence::Redo);
    if (!undo && !redo) return false;
    const bool typed = undo ? edit->isUndoAvailable() : edit->isRedoAvailable();
    if (typed && !edit->property(searches).toBool()) return false;
    event->ignore();
    return true;
}

}  // namespace vitrine::ui

#include "moc_idle_undo.cpp"
