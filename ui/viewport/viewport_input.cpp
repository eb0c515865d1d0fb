// The visitor's hands: keys, pointer and wheel of the viewport.
#include "ui/viewport/overlay.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double radiansPerPixel = 0.0035;      // Looking around: half a turn in 900 pixels.
constexpr double orbitRadiansPerPixel = 0.008;  // Around an exhibit: half a turn in 400 pixels.

}  // namespace

bool Viewport::setKey(int key, bool down)
{
    switch (key) {
    case Qt::Key_W:
    case Qt::Key_Up: keys_.forward = down; return true;
    case Qt::Key_S:
    case Qt::Key_Down: keys_.back = down; return true;
    case Qt::Key_A:
    case Qt::Key_Left: keys_.left = down; return true;
    case Qt::Key_D:
    case Qt::Key_Right: keys_.right = down; return true;
    case Qt::Key_Shift: keys_.run = down; return true;
    default: return false;
    }
}

bool Viewport::event(QEvent* event)
{
    // Plain letters belong to the visitor while the picture has the focus, whatever shortcuts say.
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
        if (plain && std::string_view("WASDE").find(static_cast<char>(key->key())) != std::string_view::npos &&
            key->key() < 128) {
            event->accept();
            return true;
        }
    }
    return QOpenGLWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (event->key() == Qt::Key_Escape) {
        walkOn();
        return;
    }
    if (plain && event->key() == Qt::Key_Backspace) {
        goBack();
        return;
    }
    if (plain && event->key() == Qt::Key_E) {
        if (!event->isAutoRepeat()) press();
        return;
    }
    if (plain && setKey(event->key(), true)) {
        if (!event->isAutoRepeat() && !timer_.isActive()) timer_.start(0);
        return;
    }
    QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || !setKey(event->key(), false)) QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event)
{
    keys_ = {};
    releasePointer();
    QOpenGLWidget::focusOutEvent(event);
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::RightButton) return;
    forgetHover();
    button_ = event->button();
    pressPoint_ = lastPoint_ = event->position();
    dragged_ = false;
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (button_ == Qt::NoButton) {
        hoverPoint_ = event->position();
        if (!hoverTimer_.isActive()) hoverTimer_.start();
        return;
    }
    const QPointF moved = event->position() - lastPoint_;
    if (!dragged_) {
        if ((event->position() - pressPoint_).manhattanLength() < QApplication::startDragDistance() / 2.0) return;
        dragged_ = true;
        // The right button locks the pointer: it is hidden and turns the head without end.
        if (button_ == Qt::RightButton) setCursor(Qt::BlankCursor);
    }
    if (moved.isNull()) return;
    const double rate = control_.mode() == CameraControl::Mode::orbit ? orbitRadiansPerPixel : radiansPerPixel;
    control_.turn(moved.x() * rate, -moved.y() * rate);
    lastPoint_ = event->position();
    if (button_ == Qt::RightButton) {
        QCursor::setPos(mapToGlobal(pressPoint_).toPoint());
        // Where the pointer cannot be moved (Wayland), go on from where it is.
        if ((mapFromGlobal(QPointF(QCursor::pos())) - pressPoint_).manhattanLength() < 2) lastPoint_ = pressPoint_;
    }
    cameraChanged();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != button_) return;
    const bool clicked = button_ == Qt::LeftButton && !dragged_;
    releasePointer();
    if (clicked) click(event->position());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event)
{
    // The first click of the two already set off; a second one somewhere else is no new wish.
    event->accept();
}

void Viewport::releasePointer()
{
    button_ = Qt::NoButton;
    unsetCursor();
}

void Viewport::click(const QPointF& at)
{
    if (width() <= 0 || height() <= 0) return;
    const std::optional<Pointed> found = pointedAt(at);
    if (!found) return;
    const bool orbited = control_.mode() == CameraControl::Mode::orbit && found->exhibit == subject_;
    if (found->button && (found->inReach || orbited)) {
        pressButton(found->exhibit);
        return;
    }
    remember();
    subject_ = found->exhibit;
    control_.visit(found->view);
    cameraChanged();
    emit visited(found->exhibit);
}

std::optional<Pointed> Viewport::pointedAt(const QPointF& at)
{
    if (width() <= 0 || height() <= 0) return std::nullopt;
    return museum_.pick(prepared(), request(time_), {2 * at.x() / width() - 1, 1 - 2 * at.y() / height()});
}

void Viewport::hover()
{
    if (!hoverPoint_ || button_ != Qt::NoButton) return;
    const std::optional<Pointed> found = pointedAt(*hoverPoint_);
    if (found)
        setCursor(Qt::PointingHandCursor);
    else
        unsetCursor();
    name_->say(found ? QString::fromStdString(found->name) : QString());
    name_->placeAt(hoverPoint_->toPoint());
}

void Viewport::forgetHover()
{
    hoverTimer_.stop();
    hoverPoint_.reset();
    name_->say({});
    unsetCursor();
}

void Viewport::leaveEvent(QEvent* event)
{
    forgetHover();
    QOpenGLWidget::leaveEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (control_.mode() != CameraControl::Mode::orbit) {
        event->ignore();
        return;
    }
    control_.zoom(event->angleDelta().y() / 120.0);
    cameraChanged();
    event->accept();
}

}  // namespace vitrine::ui
