#include "ui/viewport/crosshair.h"

#include <QKeyEvent>
#include <QPainter>

namespace vitrine::ui {
namespace {

constexpr int crosshairSide = 25;  // Pixels; odd, so that there is a middle.
constexpr int openMiddle = 4;      // Pixels from the middle to where a line begins.

/// Returns whether the key walks, looks around, zooms or acts.
bool usesMiddle(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_W:
    case Qt::Key_A:
    case Qt::Key_S:
    case Qt::Key_D:
    case Qt::Key_E:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Plus:
    case Qt::Key_Minus: return true;
    default: return false;
    }
}

}  // namespace

Crosshair::Crosshair(QWidget& viewport) : QWidget(&viewport)
{
    setObjectName(QStringLiteral("crosshair"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(crosshairSide, crosshairSide);
    hide();
    viewport.installEventFilter(this);
}

bool Crosshair::eventFilter(QObject*, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
        if (isHidden() && usesMiddle(*static_cast<QKeyEvent*>(event))) {
            placeInMiddle();
            show();
        }
        break;
    case QEvent::Resize: placeInMiddle(); break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::FocusOut: hide(); break;
    default: break;
    }
    return false;
}

void Crosshair::placeInMiddle()
{
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 2);
}

void Crosshair::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const int middle = crosshairSide / 2;
    // A dark edge makes it visible in front of light parts of the picture.
    for (const auto& [color, width, from] : {std::tuple(QColor(18, 17, 16, 170), 3, openMiddle - 1),
                                             std::tuple(QColor(0xee, 0xea, 0xe2), 1, openMiddle)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
        const int to = middle - (width > 1 ? 0 : 1);
        painter.drawLine(middle - to, middle, middle - from, middle);
        painter.drawLine(middle + from, middle, middle + to, middle);
        painter.drawLine(middle, middle - to, middle, middle - from);
        painter.drawLine(middle, middle + from, middle, middle + to);
    }
}

}  // namespace vitrine::ui

#include "moc_crosshair.cpp"
