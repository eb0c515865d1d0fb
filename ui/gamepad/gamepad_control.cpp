#include "ui/gamepad/gamepad_control.h"

#include "ui/gamepad/stick.h"
#include "ui/kit/message_of.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QPointer>

#include <array>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int firstLook = 2000;   // Milliseconds after the start.
constexpr int searching = 1000;   // Milliseconds between two reads while none is connected,
constexpr int resting = 40;       // while one is connected and no button or stick is held,
constexpr int held = 16;          // and while one is held.
constexpr int repeatAfter = 400;  // Milliseconds until the first repetition, as of keys.
constexpr int repeatEvery = 80;
constexpr double runsFrom = 0.25;  // Trigger position from which the visitor runs, after its dead zone.
const QString devicesFolder = QStringLiteral("/dev/input");

constexpr std::array cross{PadButton::up, PadButton::down, PadButton::left, PadButton::right};

bool isOfCross(PadButton button)
{
    return button == PadButton::up || button == PadButton::down || button == PadButton::left ||
           button == PadButton::right;
}

/// Sends the press and release of a key to the widget that has the keyboard.
void type(int key)
{
    QWidget* to = QApplication::activePopupWidget();
    if (!to) to = QApplication::focusWidget();
    if (!to) to = QApplication::activeWindow();
    if (!to) return;
    const Qt::KeyboardModifiers modifiers = key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier;
    const QString text = key == Qt::Key_Space ? QStringLiteral(" ") : QString();
    const QPointer<QWidget> there = to;
    QKeyEvent down(QEvent::KeyPress, key, modifiers, text);
    QApplication::sendEvent(to, &down);
    if (!there) return;
    QKeyEvent up(QEvent::KeyRelease, key, modifiers, text);
    QApplication::sendEvent(to, &up);
}

}  // namespace

GamepadControl::GamepadControl(Viewport& viewport, QObject* parent, Open open)
    : QObject(parent), viewport_(viewport), open_(std::move(open))
{
    clock_.start();
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &GamepadControl::tick);
    connect(&devices_, &QFileSystemWatcher::directoryChanged, this, &GamepadControl::look);
    QTimer::singleShot(firstLook, this, [this] {
        if (QFileInfo::exists(devicesFolder)) devices_.addPath(devicesFolder);
        look();
    });
}

GamepadControl::~GamepadControl() = default;

void GamepadControl::look()
{
    if (!pads_ && padIsPlugged()) start();
}

void GamepadControl::open()
{
    kept_ = true;
    if (!pads_) start();
}

void GamepadControl::start()
{
    try {
        pads_ = open_();
    } catch (const std::exception& thrown) {
        emit failed(messageOf(thrown));
        return;
    }
    timer_.start(searching);
    tick();
}

void GamepadControl::tick()
{
    const PadState now = pads_->read();
    const bool here = viewport_.window()->isActiveWindow() && !QApplication::activePopupWidget();
    walk(now, here);
    if (!now.connected) {
        before_ = {};
        // Closes SDL when the gamepad is unplugged.
        if (!kept_ && !padIsPlugged()) {
            timer_.stop();
            pads_.reset();
        } else if (timer_.interval() != searching) {
            timer_.setInterval(searching);
        }
        return;
    }
    const PadState before = std::exchange(before_, now);
    bool any = walking_;
    for (std::size_t i = 0; i < padButtons; ++i) {
        any = any || now.buttons[i];
        if (!now.buttons[i] || before.buttons[i]) continue;
        const auto button = static_cast<PadButton>(i);
        if (isOfCross(button)) repeatAt_ = clock_.elapsed() + repeatAfter;
        press(button, here, false);
    }
    repeat(now, here);
    const int interval = any ? held : resting;
    if (timer_.interval() != interval) timer_.setInterval(interval);
}

void GamepadControl::walk(const PadState& pad, bool here)
{
    WalkKeys keys;
    if (pad.connected && here) {
        const Push way = pushOf(pad.leftX, pad.leftY);
        const Push look = pushOf(pad.rightX, pad.rightY);
        keys.ahead = -way.y;
        keys.aside = way.x;
        keys.yaw = look.x * lookSpeed;
        keys.pitch = -look.y * tiltSpeed;
        const double nearer = pullOf(pad.rightTrigger), farther = pullOf(pad.leftTrigger);
        keys.run = nearer > runsFrom || pad.held(PadButton::leftStick);
        if (viewport_.visitor().mode() == CameraControl::Mode::orbit) keys.nearer = (nearer - farther) * zoomSpeed;
    }
    const bool moves = keys.moves();
    if (moves || walking_) viewport_.input().setSticks(keys);
    walking_ = moves;
}

void GamepadControl::repeat(const PadState& pad, bool here)
{
    if (clock_.elapsed() < repeatAt_) return;
    for (const PadButton button : cross) {
        if (!pad.held(button)) continue;
        repeatAt_ = clock_.elapsed() + repeatEvery;
        press(button, here, true);
        return;
    }
}

void GamepadControl::press(PadButton button, bool here, bool again)
{
    if (here)
        pressHere(button, again);
    else if (QApplication::activeWindow() || QApplication::activePopupWidget())
        pressElsewhere(button);
}

void GamepadControl::pressHere(PadButton button, bool again)
{
    switch (button) {
    case PadButton::a: viewport_.interaction().act(); return;
    case PadButton::b: viewport_.visitor().walkOn(); return;
    case PadButton::x: viewport_.interaction().press(); return;
    case PadButton::y: viewport_.visitor().goBack(); return;
    case PadButton::leftShoulder: emit exhibitAsked(-1); return;
    case PadButton::rightShoulder: emit exhibitAsked(1); return;
    case PadButton::start: emit pauseAsked(); return;
    case PadButton::up: emit parameterRequested(-1); return;
    case PadButton::down: emit parameterRequested(1); return;
    case PadButton::left: emit changeAsked(-1, again); return;
    case PadButton::right: emit changeAsked(1, again); return;
    case PadButton::leftStick:
    case PadButton::rightStick: return;
    }
}

void GamepadControl::pressElsewhere(PadButton button)
{
    const bool menu = QApplication::activePopupWidget() != nullptr;
    switch (button) {
    case PadButton::a: type(menu ? Qt::Key_Return : Qt::Key_Space); return;
    case PadButton::b: type(Qt::Key_Escape); return;
    case PadButton::up: type(menu ? Qt::Key_Up : Qt::Key_Backtab); return;
    case PadButton::down: type(menu ? Qt::Key_Down : Qt::Key_Tab); return;
    case PadButton::left: type(Qt::Key_Left); return;
    case PadButton::right: type(Qt::Key_Right); return;
    default: return;
    }
}

}  // namespace vitrine::ui

#include "moc_gamepad_control.cpp"
