#pragma once

#include "render/image/image.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace vitrine::ui {

/// A setting's picture, its reference, and how far they differ per pixel; of one size.
struct PictureTriple {
    render::Image picture, reference;  ///< Linear light; empty: nothing to show.
    render::Image errors;              ///< One channel; empty: no pixel differs.
    double full = 1;                   ///< The error that the heat map shows brightest.
};

/// The three side by side, or picture and reference behind a wipe, zoomed and moved together: the wheel zooms at the
/// pointer, dragging moves, + - 0 1 and arrows do the same; beyond 100 % every pixel is a square.
class PicturePanes final : public QWidget {
    Q_OBJECT

public:
    explicit PicturePanes(QWidget* parent = nullptr);

    /// The zoom stays where the pictures are as large as those before.
    void setPictures(PictureTriple);
    void setWiped(bool);
    [[nodiscard]] bool wiped() const { return wiped_; }
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);  ///< 0: all reference, 1: all setting.

    /// Pixels of the screen for one of the picture.
    [[nodiscard]] double scale() const { return scale_; }
    /// The pixel of the picture in the middle of every pane.
    [[nodiscard]] QPointF middle() const { return middle_; }
    void zoomBy(double factor);  ///< About the middle.
    void fit();                  ///< All of it, as large as there is room; stays so when the window grows.
    void setActualSize();

    /// The pixel below the pointer in any pane, else the one in the middle; nothing outside of the picture.
    [[nodiscard]] std::optional<QPoint> pixel() const;
    /// Its values in both, and the error.
    [[nodiscard]] QString reading() const;
    /// The places of the panes: picture (or both behind the wipe), reference, difference.
    [[nodiscard]] std::vector<QRectF> panes() const;

signals:
    void viewChanged();   ///< Zoom or place.
    void pixelChanged();  ///< What `reading` says may be another.

protected:
    void paintEvent(QPaintEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void leaveEvent(QEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {960, 540}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 180}; }

private:
    [[nodiscard]] QSizeF pictureSize() const;
    [[nodiscard]] double fittingScale() const;
    [[nodiscard]] QRectF paneAt(const QPointF&) const;
    [[nodiscard]] QRectF placeIn(const QRectF& pane) const;
    [[nodiscard]] QPointF pixelAt(const QPointF& at, const QRectF& pane) const;
    void zoomAt(const QPointF& at, const QRectF& pane, double factor);
    void moveBy(const QPointF& pixels);
    void settle();
    void paintPane(QPainter&, const QRectF& pane, const QImage&, const QString& title) const;
    void paintWipe(QPainter&, const QRectF& pane) const;
    void paintMark(QPainter&, const QRectF& pane) const;
    [[nodiscard]] bool isOnWipe(const QPointF&) const;
    [[nodiscard]] double edgeOf(const QRectF& pane) const;

    PictureTriple triple_;
    QImage picture_, reference_, heat_;
    bool wiped_ = false;
    double wipe_ = 0.5;
    double scale_ = 1;
    bool fits_ = true;
    QPointF middle_;
    std::optional<QPointF> pointer_;
    std::optional<QPointF> dragged_;  // Where the drag is.
    bool dragsWipe_ = false;
};

}  // namespace vitrine::ui
