#pragma once

#include "exhibits/framework/parameters.h"

namespace vitrine::ui {

/// How finely a hand moves a number: Shift a tenth, Ctrl tenfold.
enum class Gain { fine, normal, coarse };
[[nodiscard]] double factor(Gain);

/// The way of a number along its slider. Position 0 is the low end of the comfortable range and 1 the
/// high end, linear or logarithmic as the row says; dragging a field may go beyond, up to the legal limits.
class SliderScale {
public:
    /// For kinds real and count.
    explicit SliderScale(const ParameterInfo&);

    /// Not limited to 0..1; on a logarithmic scale a value that is not positive has position 0.
    [[nodiscard]] double position(double value) const;
    /// Legal, and round in the unit shown: as many digits as a hand can place.
    [[nodiscard]] double value(double position, Gain = Gain::normal) const;
    /// The value `steps` arrow presses away; legal and round.
    [[nodiscard]] double stepped(double value, double steps, Gain = Gain::normal) const;

private:
    [[nodiscard]] double legal(double value) const;
    [[nodiscard]] double rounded(double value, Gain) const;

    Range range_;
    bool whole_;
    bool logarithmic_;
    double shownPerStored_;
    double step_;  // One arrow press on a linear scale, in the unit shown.
};

}  // namespace vitrine::ui
