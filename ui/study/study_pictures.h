#pragma once

#include "render/image/image.h"
#include "ui/kit/spoken.h"

#include <QImage>
#include <QWidget>

class QPainter;

namespace vitrine::ui {

/// What stands in place of a heat map of two pictures that are equal.
[[nodiscard]] QString noPixelDiffers();

/// sRGB codes of a picture of linear light, for the screen.
[[nodiscard]] QImage screenImage(const render::Image&);

/// A setting's picture against its reference, with a wipe that follows the pointer, and where they differ beside it.
class StudyPictures final : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit StudyPictures(QWidget* parent = nullptr);

    /// A null heat map: no pixel differs, which is said in its place. `full` is the error that the heat map shows
    /// brightest.
    void show(const QImage& picture, const QImage& reference, const QImage& heat, const QString& full = {});
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);  ///< 0: all reference, 1: all setting.

    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString spokenText() const override;
    /// Where the line is, in percent.
    [[nodiscard]] std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double percent) override { setWipe(percent / 100); }

signals:
    void enlargeAsked();  ///< By a double click, or Enter.

protected:
    void paintEvent(QPaintEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {520, 200}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 110}; }

private:
    void paintPictures(QPainter&, const QRectF& at);
    [[nodiscard]] QRectF placeOf(int index) const;  ///< 0: picture, 1: heat map.

    QImage picture_, reference_, heat_;
    QString full_;
    double wipe_ = 0.5;
};

}  // namespace vitrine::ui
