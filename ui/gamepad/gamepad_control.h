#pragma once

#include "ui/gamepad/pads.h"

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace vitrine::ui {

class Viewport;

/// Control by gamepad: sticks walk and look, buttons act like keys, in the window and in its dialogs. SDL is opened
/// only once a device like a gamepad is plugged in. Without a connected gamepad it is then polled once a second.
class GamepadControl final : public QObject {
    Q_OBJECT

public:
    static constexpr double lookSpeed = 2.4;  ///< Radians per second to the side with the stick at its edge.
    static constexpr double tiltSpeed = 1.5;  ///< The same upward and downward.
    static constexpr double zoomSpeed = 8;    ///< Zoom steps per second with a trigger pulled, around an exhibit.

    using Open = std::function<std::unique_ptr<Pads>()>;

    /// Both must outlive this object. The search for gamepads begins two seconds later, when the window has its first
    /// picture.
    GamepadControl(Viewport&, QObject* parent, Open open = openPads);
    ~GamepadControl() override;

    /// Opens SDL now and keeps it open, even if nothing is plugged in.
    void open();
    [[nodiscard]] bool opened() const { return pads_ != nullptr; }
    [[nodiscard]] bool connected() const { return before_.connected; }
    /// Milliseconds between two reads of the gamepads; 0: none is read.
    [[nodiscard]] int interval() const { return timer_.isActive() ? timer_.interval() : 0; }

signals:
    /// Asks for the next exhibit (1), or the one before (-1).
    void exhibitAsked(int step);
    void pauseAsked();
    /// Asks for the next parameter of the panel (1), or the one before (-1).
    void parameterRequested(int step);
    /// Asks to change the focused parameter by a step up or down. `again`: the button is still held, which continues
    /// the gesture.
    void changeAsked(int step, bool again);
    void failed(const QString& message);

private:
    void look();
    void start();
    void tick();
    void walk(const PadState&, bool here);
    void press(PadButton, bool here, bool again);
    void pressHere(PadButton, bool again);
    void pressElsewhere(PadButton);
    void repeat(const PadState&, bool here);

    Viewport& viewport_;
    Open open_;
    std::unique_ptr<Pads> pads_;
    PadState before_;
    QTimer timer_;
    QFileSystemWatcher devices_;
    QElapsedTimer clock_;
    qint64 repeatAt_ = 0;  // Time of `clock_` in milliseconds at which a held button of the directional pad repeats.
    bool kept_ = false;
    bool walking_ = false;
};

}  // namespace vitrine::ui
