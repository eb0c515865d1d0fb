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

/// How the pointer and the wheel turn the camera, as factors of what is usual.
struct Handling {
    double look = 1, wheel = 1;
    bool inverted = false;  ///< Dragging down looks up.
};

/// The visitor's hands over the viewport: keys that are held down, the pointer that turns the head, the wheel, clicks,
/// and the name of what the pointer rests on.
class ViewportInput final : public QObject {
    Q_OBJECT

public:
    using PointedAt = std::function<std::optional<Pointed>(const QPointF&)>;

    /// Takes the events of `viewport` and turns `control`; both must outlive it. `pointedAt` says what lies under a
    /// point of the viewport.
    ViewportInput(QWidget& viewport, CameraControl& control, PointedAt pointedAt);

    /// Keys and sticks together.
    [[nodiscard]] WalkKeys keys() const;
    /// What a gamepad's sticks say until they say something else, wherever the focus is.
    void setSticks(const WalkKeys&);
    [[nodiscard]] const WalkKeys& sticks() const { return sticks_; }
    void setHandling(const Handling& handling) { handling_ = handling; }
    /// Something else may lie under a pointer that rests.
    void lookAgain();
    /// Whether the name of what is under the pointer is shown; it is at first.
    void setNaming(bool);

signals:
    /// A key for walking was pressed.
    void walking();
    /// The camera was turned or zoomed.
    void turned();
    void clicked(const QPointF& at);
    void walkOnAsked();
    void goBackAsked();
    void pressAsked();
    /// What is in the middle of the picture is to be visited or pressed.
    void actAsked();
    /// A number from 1 to 9.
    void bookmarkAsked(int number);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    // Each returns whether the event was for the visitor: then nobody else gets it.
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
    std::optional<QPointF> hoverPoint_;  // Where the pointer is while it is over the picture and no button is down.
    QPointF pressPoint_, lastPoint_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool dragged_ = false;
    bool naming_ = true;
};

}  // namespace vitrine::ui
