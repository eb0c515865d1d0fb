#include "ui/controllers/takeover.h"

#include "ui/parameters/slider_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {

bool isMovable(const ParameterInfo& info)
{
    switch (info.kind) {
    case Kind::real:
    case Kind::count: return info.range.softHigh > info.range.softLow;
    case Kind::toggle:
    case Kind::choice: return true;
    default: return false;
    }
}

Value valueAt(const ParameterInfo& info, double position)
{
    position = std::clamp(position, 0.0, 1.0);
    if (info.kind == Kind::toggle) return position >= 0.5 ? 1.0 : 0.0;
    if (info.kind != Kind::choice) return SliderScale(info).value(position);
    const auto count = static_cast<double>(info.choices.size());
    return std::min(std::floor(position * count), count - 1);
}

double positionOf(const ParameterInfo& info, const Value& value)
{
    const double number = std::get<double>(value);
    if (info.kind == Kind::toggle) return number != 0 ? 0.75 : 0.25;
    if (info.kind == Kind::choice)
        return (number + 0.5) / static_cast<double>(std::max<std::size_t>(info.choices.size(), 1));
    // Values beyond the slider's ends can be typed. An end of the way touches them.
    return std::clamp(SliderScale(info).position(number), 0.0, 1.0);
}

std::optional<Value> Takeover::move(const ParameterInfo& info, const Value& present, double position)
{
    const std::optional<double> before = std::exchange(last_, position);
    const Value value = nearestLegal(info, valueAt(info, position)).value_or(present);
    if (!set_ || *set_ != present) {
        const double there = positionOf(info, present);
        const bool touches = value == present || std::abs(position - there) <= touch;
        const bool passes = before && (*before - there) * (position - there) <= 0;
        set_.reset();
        if (!touches && !passes) return {};
    }
    set_ = value;
    return value;
}

std::optional<double> Takeover::waitingAt(const Value& present) const
{
    return set_ && *set_ == present ? std::nullopt : last_;
}

}  // namespace vitrine::ui
