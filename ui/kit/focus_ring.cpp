#include "ui/kit/focus_ring.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QFocusEvent>
#include <QFocusFrame>

namespace vitrine::ui {

FocusRing::FocusRing(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

FocusRing::~FocusRing()
{
    delete frame_;
}

bool FocusRing::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::FocusIn && event->type() != QEvent::FocusOut) return false;
    auto* area = qobject_cast<QAbstractScrollArea*>(object);
    if (!area) return false;
    if (!frame_) frame_ = new QFocusFrame;
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    // An open menu has the focus only for a while.
    if (reason == Qt::PopupFocusReason) return false;
    const bool shown = event->type() == QEvent::FocusIn && reason != Qt::MouseFocusReason && !area->isWindow();
    if (shown) {
        frame_->setWidget(area);
        frame_->raise();
    } else if (frame_->widget() == area) {
        frame_->setWidget(nullptr);
    }
    return false;
}

}  // namespace vitrine::ui

#include "moc_focus_ring.cpp"
