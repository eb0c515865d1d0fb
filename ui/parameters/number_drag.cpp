#include "ui/parameters/number_drag.h"

#include <cmath>

namespace vitrine::ui {

Gain gainOf(Qt::KeyboardModifiers modifiers)
{
    if (modifiers & Qt::ShiftModifier) return Gain::fine;
    if (modifiers & Qt::ControlModifier) return Gain::coarse;
    return Gain::normal;
}

void NumberDrag::press(double value, double x)
{
    startX_ = lastX_ = x;
    startValue_ = value_ = value;
    position_ = scale_.position(value);
    pressed_ = true;
    dragging_ = false;
}

bool NumberDrag::move(double x, Gain gain)
{
    if (!pressed_) return false;
    if (!dragging_) {
        if (std::abs(x - startX_) < threshold) return false;
        dragging_ = true;
        lastX_ = x;
        return true;
    }
    // By differences, so that a modifier pressed halfway changes the speed and not the number.
    position_ += (x - lastX_) / pixelsPerRange * factor(gain);
    lastX_ = x;
    value_ = scale_.value(position_, gain);
    // Beyond a legal limit the pointer does not have to come all the way back.
    const double reached = scale_.position(value_);
    if (std::abs(reached - position_) > 0.05) position_ = reached;
    return true;
}

bool NumberDrag::release()
{
    pressed_ = false;
    const bool was = dragging_;
    dragging_ = false;
    return was;
}

}  // namespace vitrine::ui
