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

/// A gamepad in the visitor's hands: sticks walk and look, buttons do what keys do, in the window and in its dialogs.
/// Nothing is opened before something like one is plugged in, and what none is connected to is asked once a second.
class GamepadControl final : public QObject {
    Q_OBJECT

public:
    static constexpr double lookSpeed = 2.4;  ///< Radians per second to the side, of a stick at its edge.
    static constexpr double tiltSpeed = 1.5;  ///< The same upward and downward.
    static constexpr double zoomSpeed = 8;    ///< Steps of the wheel per second, of a trigger, around an exhibit.

    using Open = std::function<std::unique_ptr<Pads>()>;

    /// Both must outlive it. Looks for gamepads from a moment on, when the window has its first picture.
    GamepadControl(Viewport&, QObject* parent, Open open = openPads);
    ~GamepadControl() override;

    /// Opens SDL now and keeps it, whether something is plugged in or not.
    void open();
    [[nodiscard]] bool opened() const { return pads_ != nullptr; }
    [[nodiscard]] bool connected() const { return before_.connected; }
    /// Milliseconds between two looks at the gamepads; 0: none is looked at.
    [[nodiscard]] int interval() const { return timer_.isActive() ? timer_.interval() : 0; }

signals:
    /// The next exhibit (1), or the one before (-1).
    void exhibitAsked(int step);
    void pauseAsked();
    /// The next row of the parameters, or the one before.
    void rowAsked(int step);
    /// More or less of the row that is chosen; `again`: the button is still held, which is one gesture.
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
    qint64 repeatAt_ = 0;  // Of the clock, milliseconds: when a button of the cross that is held counts again.
    bool kept_ = false;
    bool walking_ = false;
};

}  // namespace vitrine::ui
