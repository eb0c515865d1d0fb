#include "ui/parameters/slider_scale.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

/// Returns the largest of 1, 2, 5 times a power of ten that is not above `x`.
double roundStep(double x)
{
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    const double digit = x / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/// Returns the multiple of `step` nearest to `x`, computed so that 0.3 does not become 0.30000000000000004.
double toMultiple(double x, double step)
{
    const double perStep = 1 / step;
    return step < 1 ? std::round(x * perStep) / std::round(perStep) : std::round(x / step) * step;
}

}  // namespace

double factor(Gain gain)
{
    return gain == Gain::fine ? 0.1 : gain == Gain::coarse ? 10 : 1;
}

SliderScale::SliderScale(const ParameterInfo& parameter)
    : range_(parameter.range), whole_(parameter.kind == Kind::count),
      logarithmic_(parameter.range.scale == Scale::logarithmic && parameter.range.softLow > 0),
      shownPerStored_(info(parameter.unit).shownPerStored), step_(1)
{
    const double span = (range_.softHigh - range_.softLow) * shownPerStored_;
    if (!whole_ && span > 0) step_ = roundStep(span / 50);
}

double SliderScale::finite(double value) const
{
    return std::isfinite(value) ? value : value > 0 ? range_.softHigh : range_.softLow;
}

double SliderScale::position(double value) const
{
    value = finite(value);
    if (!(range_.softHigh > range_.softLow)) return 0;
    if (!logarithmic_) return (value - range_.softLow) / (range_.softHigh - range_.softLow);
    if (value <= 0) return 0;
    return std::log(value / range_.softLow) / std::log(range_.softHigh / range_.softLow);
}

double SliderScale::value(double position, Gain gain) const
{
    // The ends are returned exactly, without rounding.
    if (position == 0) return legal(range_.softLow);
    if (position == 1) return legal(range_.softHigh);
    const double raw = logarithmic_ ? range_.softLow * std::pow(range_.softHigh / range_.softLow, position)
                                    : range_.softLow + (range_.softHigh - range_.softLow) * position;
    return rounded(raw, gain);
}

double SliderScale::stepped(double value, double steps, Gain gain) const
{
    value = finite(value);
    if (whole_) return legal(value + steps * std::max(1.0, factor(gain)));
    if (logarithmic_ && value > 0) return rounded(value * std::pow(10.0, steps * factor(gain) / 20), gain);
    const double step = step_ * factor(gain);
    return legal(toMultiple(value * shownPerStored_ + steps * step, step * 0.1) / shownPerStored_);
}

double SliderScale::legal(double value) const
{
    const double inside = std::clamp(value, range_.low, range_.high);
    return whole_ ? std::round(inside) : inside;
}

double SliderScale::rounded(double value, Gain gain) const
{
    if (whole_ || value == 0) return legal(value);
    const double shownValue = value * shownPerStored_;
    const double fine = gain == Gain::fine ? 0.1 : 1;
    const double magnitude = std::pow(10.0, std::floor(std::log10(std::abs(shownValue))));
    const double quantum = logarithmic_ ? magnitude / 100 * fine : step_ / 10 * fine;
    return legal(toMultiple(shownValue, quantum) / shownPerStored_);
}

}  // namespace vitrine::ui
