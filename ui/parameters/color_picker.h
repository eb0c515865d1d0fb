#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/kit/inline_dialog.h"

#include <QWidget>

namespace vitrine::ui {

/// Color field with saturation to the right and value upward, and a hue bar below. Arrow keys move in the field, with
/// Ctrl in the bar.
class ColorField final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit ColorField(const QColor& start, QWidget* parent);

    [[nodiscard]] QColor color() const;
    /// Return positions in the widget, in pixels, for values from 0 to 1.
    [[nodiscard]] QPointF placeOf(double saturation, double value) const;
    [[nodiscard]] QPointF placeOfHue(double hue) const;

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::ColorChooser; }
    [[nodiscard]] QString accessibleText() const override;

signals:
    void picked(const QColor&);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {240, 180}; }

private:
    [[nodiscard]] QRectF field() const;
    [[nodiscard]] QRectF bar() const;
    void take(const QPointF&);
    void set(double hue, double saturation, double value);

    // Kept beside the color, because gray has no hue and black no saturation.
    double hue_ = 0, saturation_ = 0, value_ = 0;
    bool inBar_ = false;
};

/// Dialog that chooses a color. Colors being tried are applied at once.
class ColorDialog final : public InlineDialog {
    Q_OBJECT

public:
    ColorDialog(const QString& heading, const QColor& start, QWidget* parent);

signals:
    void picked(const QColor&);
};

}  // namespace vitrine::ui
