#pragma once

#include "exhibits/printing/print_preview.h"
#include "ui/kit/accessible_content.h"
#include "ui/print/newest_job.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <array>

namespace vitrine::ui {

/// Preview of the card for the left and the right eye, 65 mm apart at the viewing distance. Dragging sideways turns it,
/// dragging up and down tilts it. Arrow keys do the same by degrees, Home looks straight on.
class EyesPreview final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit EyesPreview(QWidget* parent = nullptr);

    /// Sets the print to show; null: none. `distance` in millimeters; infinity: the eyes stand at 40 cm.
    void setPreview(std::shared_ptr<const printing::PrintPreview>, double distance);
    /// Sets the direction of view from between the eyes, in radians: to the right, and from above.
    void look(double angle, double angleAlong);
    [[nodiscard]] double angle() const { return angle_; }
    [[nodiscard]] double angleAlong() const { return angleAlong_; }
    /// Returns the picture of the left (0) or right (1) eye; null until it is made.
    [[nodiscard]] const QImage& seen(std::size_t eye) const { return images_.at(eye); }
    /// Returns the angle of the last pictures.
    [[nodiscard]] double shownAngle() const { return shownAngle_; }

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString accessibleText() const override;
    /// Returns the direction of view in degrees to the right.
    [[nodiscard]] std::optional<AccessibleNumber> accessibleNumber() const override;
    void setAccessibleNumber(double degrees) override;

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override { update(); }
    void focusOutEvent(QFocusEvent*) override { update(); }

private:
    void fetch(bool coarse);
    [[nodiscard]] QRectF half(int eye) const;
    /// Returns the text of the direction of view: "2.0° right, 0.0°, from 40 cm".
    [[nodiscard]] QString standpoint() const;

    std::shared_ptr<const printing::PrintPreview> preview_;
    NewestJob job_;
    QTimer settle_;  ///< Delays the fine pictures during a drag.
    std::array<QImage, 2> images_;
    double distance_ = 400;
    double angle_ = 0, angleAlong_ = 0, shownAngle_ = 0;
    QPointF grabbed_;
    bool dragging_ = false;
};

}  // namespace vitrine::ui
