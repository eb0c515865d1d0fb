#pragma once

#include "ui/explore/pad_corners.h"
#include "ui/model/history.h"

#include <QWidget>

namespace vitrine::ui {

/// Square with four settings at its corners and a handle between them. A press moves the handle there, Shift drags
/// finer, Esc undoes a drag. Arrow keys move the handle (Shift finer, Ctrl coarser), Home moves it to the first corner.
class MorphPad final : public QWidget {
    Q_OBJECT

public:
    /// The corners must outlive the pad.
    explicit MorphPad(const PadCorners&, QWidget* parent = nullptr);

    /// Returns the position of the handle, each coordinate 0 to 1, (0, 0) in the upper left corner.
    [[nodiscard]] QPointF place() const { return place_; }
    /// Shows the handle at a position. `hollow`: the present values are not those of this position.
    void show(const QPointF& place, bool hollow);
    [[nodiscard]] bool hollow() const { return hollow_; }
    /// Returns the names of the corners with a weight: "62 % Old gold, 38 % Chrome".
    [[nodiscard]] QString valueText() const;
    /// Returns the name of a corner's settings.
    [[nodiscard]] static QString nameOf(const PadCorners::Corner&);

signals:
    /// Emitted when the visitor moved the handle. Moves of one gesture are one undo step.
    void moved(const QPointF& place, int gesture);
    /// Emitted on Esc during a drag: the gesture must be undone.
    void takenBack(int gesture);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {260, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 150}; }

private:
    /// Returns the area of the handle in pixels.
    [[nodiscard]] QRectF field() const;
    [[nodiscard]] QPointF pixelOf(const QPointF& place) const;
    void move(const QPointF& place);
    void paintCorner(QPainter&, std::size_t corner, double weight) const;
    void tellChange();

    const PadCorners& corners_;
    QPointF place_{0, 0}, placeAtPress_, grip_;
    Gesture gesture_ = 0;
    bool hollow_ = false, hollowAtPress_ = false;
    bool dragging_ = false;
};

}  // namespace vitrine::ui
