#include "ui/viewport/viewport_input.h"

#include "ui/kit/language.h"
#include "ui/viewport/overlay.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <string_view>

namespace vitrine::ui {
namespace {

constexpr double radiansPerPixel = 0.0035;      // Walking: half a turn in 900 pixels.
constexpr double orbitRadiansPerPixel = 0.008;  // Orbiting: half a turn in 400 pixels.
constexpr double radiansPerSecond = 1.2;        // Turn by keys, walking and orbiting.
constexpr int hoverDelay = 30;  // Milliseconds of rest after which the object under the pointer is looked up.

bool isPlain(const QKeyEvent& event)
{
    return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

}  // namespace

ViewportInput::ViewportInput(QWidget& viewport, CameraControl& control, PointedAt pointedAt)
    : viewport_(viewport), control_(control), pointedAt_(std::move(pointedAt)),
      name_(new Overlay(Overlay::Place::pointer, &viewport))
{
    hoverTimer_.setSingleShot(true);
    hoverTimer_.setInterval(hoverDelay);
    connect(&hoverTimer_, &QTimer::timeout, this, &ViewportInput::hover);
    viewport.installEventFilter(this);
}

bool ViewportInput::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: return overrideShortcut(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyPress: return pressKey(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyRelease: return releaseKey(*static_cast<QKeyEvent*>(event));
    case QEvent::MouseButtonPress: return pressPointer(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove: return movePointer(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease: return releasePointer(*static_cast<QMouseEvent*>(event));
    // The first click of a double click has already started a visit. The second one is ignored.
    case QEvent::MouseButtonDblClick: return true;
    case QEvent::Wheel: return turnWheel(*static_cast<QWheelEvent*>(event));
    case QEvent::FocusOut:
        keys_ = {};
        letGo();
        return false;
    case QEvent::Leave: forgetHover(); return false;
    default: return QObject::eventFilter(watched, event);
    }
}

bool ViewportInput::overrideShortcut(QKeyEvent& event)
{
    // Plain walking letters go to the picture while it has the focus, before shortcuts.
    const bool letter =
        event.key() < 128 && std::string_view("WASDE").find(static_cast<char>(event.key())) != std::string_view::npos;
    if (!letter || !isPlain(event)) return false;
    event.accept();
    return true;
}

bool ViewportInput::setKey(int key, bool down)
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

bool ViewportInput::setTurnKey(int key, bool down)
{
    const double rate = down ? radiansPerSecond : 0;
    switch (key) {
    case Qt::Key_Up: keys_.pitch = rate; return true;
    case Qt::Key_Down: keys_.pitch = -rate; return true;
    case Qt::Key_Left: keys_.yaw = -rate; return true;
    case Qt::Key_Right: keys_.yaw = rate; return true;
    default: return false;
    }
}

WalkKeys ViewportInput::keys() const
{
    WalkKeys all = keys_;
    all.run = keys_.run || sticks_.run;
    all.ahead = sticks_.ahead;
    all.aside = sticks_.aside;
    all.yaw += sticks_.yaw;
    all.pitch += sticks_.pitch;
    all.nearer = sticks_.nearer;
    return all;
}

bool ViewportInput::moves() const
{
    return sticks_.moves() || (keys().moves() && viewport_.hasFocus());
}

void ViewportInput::setSticks(const WalkKeys& sticks)
{
    sticks_ = sticks;
    if (!sticks.moves()) return;
    // Without a pointer, the middle of the picture is pointed at.
    if (button_ == Qt::NoButton) hoverPoint_ = viewport_.rect().center();
    emit walking();
}

bool ViewportInput::pressKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Escape) {
        emit walkOnAsked();
        return true;
    }
    if (event.modifiers() == Qt::ControlModifier && setTurnKey(event.key(), true)) {
        if (!hoverPoint_) hoverPoint_ = viewport_.rect().center();
        if (!event.isAutoRepeat()) emit walking();
        return true;
    }
    if (!isPlain(event)) return false;
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!event.isAutoRepeat()) emit actAsked();
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(1); return true;
    case Qt::Key_Minus: zoom(-1); return true;
    default: break;
    }
    if (event.key() == Qt::Key_Backspace) {
        emit goBackAsked();
        return true;
    }
    if (event.key() == Qt::Key_E) {
        if (!event.isAutoRepeat()) emit pressAsked();
        return true;
    }
    if (event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9) {
        if (!event.isAutoRepeat()) emit bookmarkAsked(event.key() - Qt::Key_0);
        return true;
    }
    if (!setKey(event.key(), true)) return false;
    if (!event.isAutoRepeat()) emit walking();
    return true;
}

bool ViewportInput::releaseKey(const QKeyEvent& event)
{
    if (event.isAutoRepeat()) return false;
    const bool turned = setTurnKey(event.key(), false);
    return setKey(event.key(), false) || turned;
}

bool ViewportInput::pressPointer(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton && event.button() != Qt::RightButton) return true;
    forgetHover();
    button_ = event.button();
    pressPoint_ = lastPoint_ = event.position();
    dragged_ = false;
    return true;
}

bool ViewportInput::movePointer(const QMouseEvent& event)
{
    if (button_ != Qt::NoButton) {
        drag(event);
    } else {
        hoverPoint_ = event.position();
        if (!hoverTimer_.isActive()) hoverTimer_.start();
    }
    return true;
}

void ViewportInput::drag(const QMouseEvent& event)
{
    const QPointF moved = event.position() - lastPoint_;
    if (!dragged_) {
        if ((event.position() - pressPoint_).manhattanLength() < QApplication::startDragDistance() / 2.0) return;
        dragged_ = true;
        // The right button locks and hides the pointer, so that the head can turn without end.
        if (button_ == Qt::RightButton) viewport_.setCursor(Qt::BlankCursor);
    }
    if (moved.isNull()) return;
    const double rate =
        (control_.mode() == CameraControl::Mode::orbit ? orbitRadiansPerPixel : radiansPerPixel) * handling_.look;
    control_.turn(moved.x() * rate, (handling_.inverted ? moved.y() : -moved.y()) * rate);
    lastPoint_ = event.position();
    if (button_ == Qt::RightButton) {
        QCursor::setPos(viewport_.mapToGlobal(pressPoint_).toPoint());
        // The pointer cannot be moved on Wayland: continue from where it is.
        if ((viewport_.mapFromGlobal(QPointF(QCursor::pos())) - pressPoint_).manhattanLength() < 2)
            lastPoint_ = pressPoint_;
    }
    emit turned();
}

bool ViewportInput::releasePointer(const QMouseEvent& event)
{
    if (event.button() != button_) return true;
    const bool isClick = button_ == Qt::LeftButton && !dragged_;
    letGo();
    if (isClick) emit clicked(event.position());
    return true;
}

bool ViewportInput::turnWheel(const QWheelEvent& event)
{
    if (control_.mode() != CameraControl::Mode::orbit) return false;
    zoom(event.angleDelta().y() / 120.0 * handling_.wheel);
    return true;
}

void ViewportInput::zoom(double steps)
{
    if (control_.mode() != CameraControl::Mode::orbit) return;
    control_.zoom(steps);
    emit turned();
}

void ViewportInput::letGo()
{
    button_ = Qt::NoButton;
    viewport_.unsetCursor();
}

void ViewportInput::lookAgain()
{
    if (hoverPoint_) hoverTimer_.start();
}

void ViewportInput::setNaming(bool on)
{
    naming_ = on;
    if (!on) name_->say({});
    lookAgain();
}

void ViewportInput::hover()
{
    if (!hoverPoint_ || button_ != Qt::NoButton) return;
    const std::optional<Pointed> found = pointedAt_(*hoverPoint_);
    if (found)
        viewport_.setCursor(Qt::PointingHandCursor);
    else
        viewport_.unsetCursor();
    name_->say(found && naming_ ? translatedText(found->name) : QString());
    name_->placeAt(hoverPoint_->toPoint());
}

void ViewportInput::forgetHover()
{
    hoverTimer_.stop();
    hoverPoint_.reset();
    name_->say({});
    viewport_.unsetCursor();
}

}  // namespace vitrine::ui

#include "moc_viewport_input.cpp"
