#pragma once

#include "exhibits/printing/print_preview.h"
#include "ui/kit/spoken.h"
#include "ui/print/newest_job.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <array>

namespace vitrine::ui {

/// The card as the left and the right eye see it, 65 mm apart at the viewing distance. Dragging to the side
/// turns it, dragging up and down tilts it; the arrows do the same by degrees, Home looks straight on.
class EyesPreview final : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit EyesPreview(QWidget* parent = nullptr);

    /// Null: nothing to show. `distance` in millimeters, infinity for eyes far away, which see the same.
    void setPreview(std::shared_ptr<const printing::PrintPreview>, double distance);
    /// From where the card is looked at, between the eyes, in radians; to the right, and from above.
    void look(double angle, double angleAlong);
    [[nodiscard]] double angle() const { return angle_; }
    [[nodiscard]] double angleAlong() const { return angleAlong_; }
    /// What the left (0) and the right (1) eye see; null until it is made.
    [[nodiscard]] const QImage& seen(std::size_t eye) const { return images_.at(eye); }
    /// Of the last pictures made.
    [[nodiscard]] double shownAngle() const { return shownAngle_; }

    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString spokenText() const override;
    /// From where it is looked at, in degrees to the right.
    [[nodiscard]] std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double degrees) override;

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
    /// "2.0° right, 0.0°, from 40 cm".
    [[nodiscard]] QString standpoint() const;

    std::shared_ptr<const printing::PrintPreview> preview_;
    NewestJob job_;
    QTimer settle_;  ///< From the coarse pictures of a drag to fine ones.
    std::array<QImage, 2> images_;
    double distance_ = 400;
    double angle_ = 0, angleAlong_ = 0, shownAngle_ = 0;
    QPointF grabbed_;
    bool dragging_ = false;
};

}  // namespace vitrine::ui
