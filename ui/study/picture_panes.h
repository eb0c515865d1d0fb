#pragma once

#include "render/image/image.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace vitrine::ui {

/// Picture of a setting, its reference, and their difference per pixel; all of one size.
struct PictureTriple {
    render::Image picture, reference;  ///< Linear light; empty: nothing to show.
    render::Image errors;              ///< One channel; empty: no pixel differs.
    double full = 1;                   ///< Error that the heat map shows brightest.
};

/// Panes of picture, reference and difference side by side, or the first two with a wipe. All are zoomed and moved
/// together: the wheel zooms at the pointer, dragging moves, and the keys + - 0 1 and arrows do the same. Beyond 100 %
/// every pixel is a square.
class PicturePanes final : public QWidget {
    Q_OBJECT

public:
    explicit PicturePanes(QWidget* parent = nullptr);

    /// Shows pictures. The zoom stays if they have the size of those before.
    void setPictures(PictureTriple);
    void setWiped(bool);
    [[nodiscard]] bool wiped() const { return wiped_; }
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);  ///< 0: all reference, 1: all setting.

    /// Returns the zoom in screen pixels per picture pixel.
    [[nodiscard]] double scale() const { return scale_; }
    /// Returns the position in the picture at the center of every pane, in pixels.
    [[nodiscard]] QPointF middle() const { return middle_; }
    void zoomBy(double factor);  ///< Zooms about the center.
    void fit();                  ///< Shows all of the picture, as large as possible, also after a resize.
    void setActualSize();

    /// Returns the pixel under the pointer in any pane, or else the central one; nullopt outside of the picture.
    [[nodiscard]] std::optional<QPoint> pixel() const;
    /// Returns the pixel's values in both pictures, and the error.
    [[nodiscard]] QString reading() const;
    /// Returns the rectangles of the panes: picture (or both with the wipe), reference, difference.
    [[nodiscard]] std::vector<QRectF> panes() const;

signals:
    void viewChanged();   ///< The zoom or position changed.
    void pixelChanged();  ///< The result of `reading` may have changed.

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
    std::optional<QPointF> dragged_;  // Last pointer position of a drag.
    bool dragsWipe_ = false;
};

}  // namespace vitrine::ui
