#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/model/history.h"
#include "ui/parameters/slider_scale.h"

#include <QSlider>

#include <limits>

namespace vitrine::ui {

/// Thin horizontal slider over a parameter's comfortable range. A press moves the handle there; Shift drags finer;
/// arrow keys step.
class ValueSlider final : public QSlider, public AccessibleContent {
    Q_OBJECT

public:
    ValueSlider(const ParameterInfo& parameter, QWidget* parent);

    /// Shows a value. Not painted again if it is shown already, as when the slider's own edit comes back.
    void showValue(double value);

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Slider; }
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
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {40, 20}; }

private:
    static constexpr int ticks = 10000;  ///< Size of QSlider's integer range.

    [[nodiscard]] double positionAt(double x) const;
    [[nodiscard]] double xAt(double position) const;
    void edit(double value, Gesture);

    const ParameterInfo& row_;
    SliderScale scale_;
    double value_ = std::numeric_limits<double>::quiet_NaN();  // NaN until a value is shown.
    double valueAtPress_ = 0;
    double lastX_ = 0;
    double position_ = 0;
    Gesture gesture_ = 0;
    bool dragging_ = false;
};

}  // namespace vitrine::ui
