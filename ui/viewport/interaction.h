#pragma once

#include "exhibits/museum/museum.h"

#include <QObject>
#include <QPointF>

#include <optional>

class QWidget;

namespace vitrine::ui {

class ExhibitClock;
class PresentScene;
class Visitor;

/// Interaction with the objects in the picture: the visitor points at them, visits them by a click, and presses their
/// buttons.
class Interaction final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. `viewport` is the widget that shows the picture.
    Interaction(const QWidget& viewport, const PresentScene&, Visitor&, ExhibitClock&);

    /// Returns the object under a point of the viewport.
    [[nodiscard]] std::optional<Pointed> pointedAt(const QPointF&) const;
    /// Returns the object in the middle of the picture.
    [[nodiscard]] std::optional<Pointed> ahead() const;
    /// Button that a walking visitor looks at.
    [[nodiscard]] const std::optional<LookedAt>& buttonAhead() const { return buttonAhead_; }
    /// Looks for that button again. Call when the camera changed.
    void lookAhead();
    /// Returns a full sentence that says why `press` would press nothing; empty if there is a button to press.
    [[nodiscard]] Message whyNotPress() const;

public slots:
    /// Visits or presses the object at this point of the viewport.
    void click(const QPointF& at);
    /// Presses the button that the visitor looks at, or that of the orbited exhibit.
    void press();
    /// Presses the button that the visitor looks at, or visits the object in the middle of the picture.
    void act();

signals:
    /// Emitted when the visitor pressed this exhibit's button.
    void pressed(std::size_t exhibit);
    /// Emitted when the visitor clicked at this point on the orbited exhibit, which has a tree.
    void shapeClicked(std::size_t exhibit, const QPointF& at);
    /// Emitted by `act` if nothing is in the middle of the picture.
    void nothingAhead();

private:
    [[nodiscard]] bool orbitsButton() const;
    /// Returns why the button of an exhibit is disabled at present; empty if it can be pressed.
    [[nodiscard]] Message whyDisabled(std::size_t exhibit) const;
    [[nodiscard]] QPointF middle() const;
    void pressButton(std::size_t exhibit);

    const QWidget& viewport_;
    const PresentScene& scene_;
    Visitor& visitor_;
    ExhibitClock& clock_;
    std::optional<LookedAt> buttonAhead_;
};

}  // namespace vitrine::ui
