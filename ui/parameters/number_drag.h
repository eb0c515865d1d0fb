#pragma once

#include "ui/parameters/slider_scale.h"

#include <Qt>

namespace vitrine::ui {

[[nodiscard]] Gain gainOf(Qt::KeyboardModifiers);

/// State of a drag that changes a number, by its field or its label.
class NumberDrag {
public:
    static constexpr double pixelsPerRange = 200;  ///< Pixels from end to end of the comfortable range.
    static constexpr int threshold = 3;            ///< Pixels after which a press becomes a drag.

    explicit NumberDrag(const ParameterInfo& parameter) : scale_(parameter) {}

    void press(double value, double x);
    /// Moves the pointer to `x`. Returns whether the press is a drag; `value` is then the new number.
    bool move(double x, Gain);
    [[nodiscard]] bool pressed() const { return pressed_; }
    [[nodiscard]] bool dragging() const { return dragging_; }
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] double startValue() const { return startValue_; }
    /// Ends the drag: the button was released or Esc was pressed. Returns whether it was a drag.
    bool release();

private:
    SliderScale scale_;
    double startX_ = 0, lastX_ = 0, position_ = 0;
    double startValue_ = 0, value_ = 0;
    bool pressed_ = false, dragging_ = false;
};

}  // namespace vitrine::ui
