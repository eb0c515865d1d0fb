#pragma once

#include "ui/explore/pad_corners.h"
#include "ui/model/history.h"

#include <QWidget>

namespace vitrine::ui {

/// A square with four settings at its corners and a handle between them: a press brings the handle there, Shift drags
/// finer, Esc during a drag takes it back; arrows move it (Shift finer, Ctrl coarser), Home to the first corner.
class MorphPad final : public QWidget {
    Q_OBJECT

public:
    /// The corners must outlive it.
    explicit MorphPad(const PadCorners&, QWidget* parent = nullptr);

    /// Where the handle is, 0 to 1 each, (0, 0) in the upper left corner.
    [[nodiscard]] QPointF place() const { return place_; }
    /// Shows the handle there. Hollow where the look on show is not the one of that place.
    void show(const QPointF& place, bool hollow);
    [[nodiscard]] bool hollow() const { return hollow_; }
    /// "62 % Old gold, 38 % Chrome": the corners that count, for people.
    [[nodiscard]] QString valueText() const;
    /// What stands at a corner, for people.
    [[nodiscard]] static QString nameOf(const PadCorners::Corner&);

signals:
    /// The visitor moved the handle. Moves of one gesture are one undo step.
    void moved(const QPointF& place, int gesture);
    /// Esc during a drag: all is as before this gesture.
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
    /// In which the handle moves, pixels.
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
