#pragma once

#include "exhibits/printing/print_preview.h"
#include "ui/kit/spoken.h"
#include "ui/print/newest_job.h"

#include <QImage>
#include <QWidget>

namespace vitrine::ui {

/// The printed raster, large enough to see its strips, with the lenses' edges drawn over it. The wheel zooms
/// about the pointer, dragging moves; + and -, the arrows and Home do the same from the keyboard.
class StripPreview final : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit StripPreview(QWidget* parent = nullptr);

    /// Null: nothing to show. The place that is looked at stays while the print's size does.
    void setPreview(std::shared_ptr<const printing::PrintPreview>);
    [[nodiscard]] double zoom() const { return zoom_; }  ///< Screen pixels per printed pixel.
    void setZoom(double);
    /// Of what is on the screen; null until it is made.
    [[nodiscard]] const QImage& image() const { return image_; }

    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString spokenText() const override;
    /// The zoom.
    [[nodiscard]] std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double zoom) override { setZoom(zoom); }

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
    /// "1 dot : 2 px".
    [[nodiscard]] QString scaleText() const;
    void moveBy(const QPointF& screen);
    void clampView();
    void fetch();
    void paintLenses(QPainter&) const;
    [[nodiscard]] QPointF toScreen(double x, double y) const;

    std::shared_ptr<const printing::PrintPreview> preview_;
    NewestJob job_;
    QImage image_;
    QRectF imageRegion_;  ///< Of the raster, in its pixels.
    QPointF middle_;      ///< The raster's place in the middle of the widget.
    double zoom_ = 2;
    QPointF grabbed_;
    bool dragging_ = false;
};

/// The picture as Qt draws it.
[[nodiscard]] QImage imageOf(const printing::CodedPicture&);

}  // namespace vitrine::ui
