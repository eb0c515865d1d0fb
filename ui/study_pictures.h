#pragma once

#include "render/image/image.h"

#include <QImage>
#include <QWidget>

namespace vitrine::ui {

/// sRGB codes of a picture of linear light, for the screen.
[[nodiscard]] QImage screenImage(const render::Image&);

/// A setting's picture against its reference, with a wipe that follows the pointer, and where they differ beside it.
class StudyPictures final : public QWidget {
    Q_OBJECT

public:
    explicit StudyPictures(QWidget* parent = nullptr);

    /// Null images show nothing yet.
    void show(const QImage& picture, const QImage& reference, const QImage& heat);
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);  ///< 0: all reference, 1: all setting.

protected:
    void paintEvent(QPaintEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {420, 140}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 80}; }

private:
    [[nodiscard]] QRectF placeOf(int index) const;  ///< 0: picture, 1: heat map.

    QImage picture_, reference_, heat_;
    double wipe_ = 0.5;
};

}  // namespace vitrine::ui
