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
    // Adds differences, so that pressing a modifier during the drag changes the speed and not the value.
    position_ += (x - lastX_) / pixelsPerRange * factor(gain);
    lastX_ = x;
    value_ = scale_.value(position_, gain);
    // The position is not beyond the legal limits: a drag back takes effect at once.
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
