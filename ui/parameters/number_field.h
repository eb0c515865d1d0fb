#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/model/history.h"
#include "ui/parameters/number_drag.h"

#include <QLineEdit>

#include <functional>

namespace vitrine::ui {

/// Field for a number with its unit. Dragging changes it; a click or a key starts typing, with arithmetic and units.
/// Arrow keys step; Shift is finer, Ctrl coarser. Enter accepts; Esc restores the value before the edit.
class NumberField final : public QLineEdit, public AccessibleContent {
    Q_OBJECT

public:
    static constexpr int usualWidth = 70;  ///< Width in pixels at the usual font size.

    NumberField(const ParameterInfo& parameter, QWidget* parent);

    void showValue(double value);
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] bool editing() const { return editing_; }

    /// Drag of the number by the parameter's label; pixels.
    void dragFrom(double x);
    void dragTo(double x, Qt::KeyboardModifiers);
    void dragEnd();

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::SpinBox; }
    [[nodiscard]] std::optional<AccessibleNumber> accessibleNumber() const override;
    void setAccessibleNumber(double) override;

signals:
    void edited(double value, int gesture);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void changeEvent(QEvent*) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

private:
    void beginEdit();
    /// Accepts the typed text. Returns false and marks the field if it is no number.
    bool commit();
    void endEdit();
    void refresh();
    void edit(double value, Gesture);

    const ParameterInfo& row_;
    NumberDrag drag_;
    SliderScale scale_;
    double value_ = 0;
    Gesture gesture_ = 0;
    bool editing_ = false;
    bool wrong_ = false;
};

}  // namespace vitrine::ui
