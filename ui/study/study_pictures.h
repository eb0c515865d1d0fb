#pragma once

#include "render/image/image.h"
#include "ui/kit/accessible_content.h"

#include <QImage>
#include <QWidget>

class QPainter;

namespace vitrine::ui {

/// Returns the text in place of the heat map of two equal pictures.
[[nodiscard]] QString noPixelDiffers();

/// Converts a picture of linear light to sRGB for the screen.
[[nodiscard]] QImage screenImage(const render::Image&);

/// Picture of a setting and its reference with a wipe that follows the pointer, and the heat map of their difference.
class StudyPictures final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit StudyPictures(QWidget* parent = nullptr);

    /// Shows pictures. A null heat map stands for equal pictures. `full` is the error that the heat map shows
    /// brightest.
    void show(const QImage& picture, const QImage& reference, const QImage& heat, const QString& full = {});
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);  ///< 0: all reference, 1: all setting.

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString accessibleText() const override;
    /// Returns the position of the wipe in percent.
    [[nodiscard]] std::optional<AccessibleNumber> accessibleNumber() const override;
    void setAccessibleNumber(double percent) override { setWipe(percent / 100); }

signals:
    void enlargeAsked();  ///< Emitted on a double click or Enter.

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
