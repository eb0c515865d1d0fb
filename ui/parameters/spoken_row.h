#pragma once

#include "ui/kit/spoken.h"
#include "ui/parameters/slider_scale.h"

namespace vitrine::ui {

/// A value of a row as a screen reader says it: in the unit shown, within `low` to `high`, which are in the stored one.
[[nodiscard]] SpokenNumber spokenNumber(const ParameterInfo&, const SliderScale&, double value, double low,
                                        double high);
/// What was set in the unit shown, in the stored one.
[[nodiscard]] double storedNumber(const ParameterInfo&, double spoken);

}  // namespace vitrine::ui
