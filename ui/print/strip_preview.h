#pragma once

#include "exhibits/printing/print_preview.h"
#include "ui/kit/accessible_content.h"
#include "ui/print/newest_job.h"

#include <QImage>
#include <QWidget>

namespace vitrine::ui {

/// Preview of the printed raster, enlarged so that its strips are visible, with the edges of the lenses over it. The
/// wheel zooms about the pointer, dragging moves. The keys +, -, arrows and Home do the same.
class StripPreview final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit StripPreview(QWidget* parent = nullptr);

    /// Sets the print to show; null: none. The view stays if the print's size does.
    void setPreview(std::shared_ptr<const printing::PrintPreview>);
    [[nodiscard]] double zoom() const { return zoom_; }  ///< Screen pixels per printed pixel.
    void setZoom(double);
    /// Returns the visible part of the raster; null until it is made.
    [[nodiscard]] const QImage& image() const { return image_; }

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString accessibleText() const override;
    /// Returns the zoom.
    [[nodiscard]] std::optional<AccessibleNumber> accessibleNumber() const override;
    void setAccessibleNumber(double zoom) override { setZoom(zoom); }

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override { update(); }
    void focusOutEvent(QFocusEvent*) override { update(); }

private:
    void zoomAbout(const QPointF& place, double factor);
    /// Returns the text of the scale: "1 dot : 2 px".
    [[nodiscard]] QString scaleText() const;
    void moveBy(const QPointF& screen);
    void clampView();
    void fetch();
    void paintLenses(QPainter&) const;
    [[nodiscard]] QPointF toScreen(double x, double y) const;

    std::shared_ptr<const printing::PrintPreview> preview_;
    NewestJob job_;
    QImage image_;
    QRectF imageRegion_;  ///< Region of the raster that `image_` shows, in its pixels.
    QPointF middle_;      ///< Position in the raster at the center of the widget, in pixels.
    double zoom_ = 2;
    QPointF grabbed_;
    bool dragging_ = false;
};

/// Converts the picture to Qt's format.
[[nodiscard]] QImage imageOf(const printing::CodedPicture&);

}  // namespace vitrine::ui
