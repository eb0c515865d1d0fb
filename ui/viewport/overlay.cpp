#include "ui/viewport/overlay.h"

#include <QPainter>

#include <algorithm>

namespace vitrine::ui {

Overlay::Overlay(Place place, QWidget* viewport) : QLabel(viewport), place_(place)
{
    setTextFormat(Qt::PlainText);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setContentsMargins(12, 6, 12, 6);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, QColor(0xee, 0xea, 0xe2));
    setPalette(colors);
    hide();
}

void Overlay::say(const QString& words)
{
    if (words == text()) return;
    setText(words);
    setVisible(!words.isEmpty());
    place();
}

void Overlay::place()
{
    if (text().isEmpty()) return;
    const QSize room = parentWidget()->size();
    const int widest = std::max(80, std::min(720, room.width() - 32));
    const QMargins around = contentsMargins();
    const int inOneLine = fontMetrics().size(0, text()).width() + around.left() + around.right();
    setWordWrap(place_ == Place::topLeft || inOneLine > widest);
    if (wordWrap()) {
        resize(widest, heightForWidth(widest));
    } else {
        adjustSize();
    }
    switch (place_) {
    case Place::topLeft: move(16, 16); break;
    case Place::top: move((room.width() - width()) / 2, 16); break;
    case Place::center: move((room.width() - width()) / 2, room.height() * 5 / 8); break;
    case Place::bottom: move((room.width() - width()) / 2, room.height() - height() - 24); break;
    case Place::pointer:
        // Below and right of the pointer, or on the other side if there is no room.
        move(pointer_.x() + 16 + width() <= room.width() ? pointer_.x() + 16 : std::max(0, pointer_.x() - 8 - width()),
             pointer_.y() + 20 + height() <= room.height() ? pointer_.y() + 20
                                                           : std::max(0, pointer_.y() - 8 - height()));
        break;
    }
}

void Overlay::placeAt(const QPoint& pointer)
{
    pointer_ = pointer;
    place();
}

void Overlay::paintEvent(QPaintEvent* event)
{
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(18, 17, 16, 190));
        painter.drawRoundedRect(rect(), 4, 4);
    }
    QLabel::paintEvent(event);
}

}  // namespace vitrine::ui

#include "moc_overlay.cpp"
