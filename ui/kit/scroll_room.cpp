#include "ui/kit/scroll_room.h"

#include "ui/kit/type_size.h"

#include <QDialog>
#include <QEvent>
#include <QLayout>
#include <QScreen>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr QSize around(32, 96);  // Pixels that the desktop needs beside a dialog: borders, title bar, panels.

}  // namespace

ScrollRoom::ScrollRoom(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    content->installEventFilter(this);
}

QSize ScrollRoom::sizeHint() const
{
    const QSize room = screen()->availableSize() - around;
    QSize wanted = widget()->sizeHint();
    if (wanted.width() > room.width() && widget()->hasHeightForWidth())
        wanted.setHeight(widget()->heightForWidth(room.width()));
    if (wanted.height() > room.height()) wanted.rwidth() += verticalScrollBar()->sizeHint().width();
    return wanted.boundedTo(room);
}

QSize ScrollRoom::minimumSizeHint() const
{
    const QSize least(grown(240, *this), grown(120, *this));
    return least.boundedTo(sizeHint());
}

bool ScrollRoom::eventFilter(QObject* watched, QEvent* event)
{
    // The content may have grown.
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

QWidget* scrolledAboveBar(QWidget* content, QWidget* bar, QWidget* parent)
{
    auto* side = new QWidget(parent);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(new ScrollRoom(content, side), 1);
    auto* below = new QVBoxLayout;
    below->setContentsMargins(8, 0, 16, 16);
    below->addWidget(bar);
    layout->addLayout(below);
    return side;
}

void scrollWhenTight(QDialog& dialog)
{
    auto* content = new QWidget;
    content->setLayout(dialog.layout());
    auto* whole = new QVBoxLayout(&dialog);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(new ScrollRoom(content, &dialog));
}

}  // namespace vitrine::ui

#include "moc_scroll_room.cpp"
