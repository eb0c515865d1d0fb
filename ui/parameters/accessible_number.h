#pragma once

#include "ui/kit/accessible_content.h"
#include "ui/parameters/slider_scale.h"

namespace vitrine::ui {

/// Returns a parameter's value for screen readers, in the displayed unit. `value`, `low` and `high` are in the stored
/// unit.
[[nodiscard]] AccessibleNumber accessibleNumber(const ParameterInfo&, const SliderScale&, double value, double low,
                                                double high);
/// Converts a number in the displayed unit to the stored unit.
[[nodiscard]] double storedNumber(const ParameterInfo&, double spoken);

}  // namespace vitrine::ui
