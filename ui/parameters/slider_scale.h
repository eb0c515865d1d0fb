#pragma once

#include "exhibits/framework/table/parameters.h"

namespace vitrine::ui {

/// Speed of a change by hand: Shift a tenth, Ctrl tenfold.
enum class Gain { fine, normal, coarse };
[[nodiscard]] double factor(Gain);

/// Mapping between a number and its position on a slider. Position 0 is the low end of the comfortable range and 1 the
/// high end, linear or logarithmic as the parameter says. Dragging a field may go beyond, up to the legal limits.
class SliderScale {
public:
    /// Requires kind real or count.
    explicit SliderScale(const ParameterInfo&);

    /// Returns the position, which may be outside of 0 to 1. On a logarithmic scale a value that is not positive has
    /// position 0.
    [[nodiscard]] double position(double value) const;
    /// Returns the value, legal and rounded in the displayed unit to the digits that a hand can place.
    [[nodiscard]] double value(double position, Gain = Gain::normal) const;
    /// Returns the value after `steps` presses of an arrow key; legal and rounded.
    [[nodiscard]] double stepped(double value, double steps, Gain = Gain::normal) const;

private:
    /// Returns `value`, or the end of the slider if it is infinite. A word is displayed for such a value.
    [[nodiscard]] double finite(double value) const;
    [[nodiscard]] double legal(double value) const;
    [[nodiscard]] double rounded(double value, Gain) const;

    Range range_;
    bool whole_;
    bool logarithmic_;
    double shownPerStored_;
    double step_;  // Change by one press of an arrow key on a linear scale, in the displayed unit.
};

}  // namespace vitrine::ui
