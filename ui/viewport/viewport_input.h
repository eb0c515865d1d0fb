#pragma once

#include "exhibits/museum/museum.h"
#include "ui/viewport/camera_control.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <functional>
#include <optional>

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace vitrine::ui {

class Overlay;

/// Speed of looking around and zooming, as factors of the usual speed.
struct Handling {
    double look = 1, wheel = 1;
    bool inverted = false;  ///< Dragging down looks up.
};

/// Input of the viewport: walking keys, the pointer that turns the head, the wheel, clicks, and the name of the object
/// under the pointer.
class ViewportInput final : public QObject {
    Q_OBJECT

public:
    using PointedAt = std::function<std::optional<Pointed>(const QPointF&)>;

    /// Filters the events of `viewport` and turns `control`; both must outlive this object. `pointedAt` returns the
    /// object under a point of the viewport.
    ViewportInput(QWidget& viewport, CameraControl& control, PointedAt pointedAt);

    /// Combined state of keys and sticks.
    [[nodiscard]] WalkKeys keys() const;
    /// Sets the state of a gamepad's sticks, which holds until the next call, whatever has the focus.
    void setSticks(const WalkKeys&);
    [[nodiscard]] const WalkKeys& sticks() const { return sticks_; }
    /// Returns whether the visitor is moved: by sticks, or by keys while the viewport has the focus.
    [[nodiscard]] bool moves() const;
    void setHandling(const Handling& handling) { handling_ = handling; }
    /// Another object may be under a resting pointer: looks it up again.
    void lookAgain();
    /// Sets whether the name of the object under the pointer is shown. On at first.
    void setNaming(bool);

signals:
    /// Emitted when a walking key was pressed.
    void walking();
    /// Emitted when the camera was turned or zoomed.
    void turned();
    void clicked(const QPointF& at);
    void walkOnAsked();
    void goBackAsked();
    void pressAsked();
    /// Emitted to visit or press the object in the middle of the picture.
    void actAsked();
    /// Emitted when a number key, 1 to 9, was pressed.
    void bookmarkAsked(int number);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    // Event handlers: each returns whether it consumed the event.
    bool overrideShortcut(QKeyEvent&);
    bool pressKey(const QKeyEvent&);
    bool releaseKey(const QKeyEvent&);
    bool pressPointer(const QMouseEvent&);
    bool movePointer(const QMouseEvent&);
    bool releasePointer(const QMouseEvent&);
    bool turnWheel(const QWheelEvent&);
    bool setKey(int key, bool down);
    bool setTurnKey(int key, bool down);
    void zoom(double steps);
    void drag(const QMouseEvent&);
    void letGo();
    void hover();
    void forgetHover();

    QWidget& viewport_;
    CameraControl& control_;
    PointedAt pointedAt_;
    Overlay* name_;
    WalkKeys keys_, sticks_;
    Handling handling_;
    QTimer hoverTimer_;
    std::optional<QPointF> hoverPoint_;  // Position of the pointer while it is over the picture and no button is down.
    QPointF pressPoint_, lastPoint_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool dragged_ = false;
    bool naming_ = true;
};

}  // namespace vitrine::ui
