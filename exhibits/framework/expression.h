#pragma once

#include "exhibits/framework/units.h"

#include <optional>
#include <string_view>

namespace vitrine {

/// The value, in SI, of what someone typed for a quantity shown in `unit`: numbers, + - * / ^, parentheses,
/// pi, e, and units ("30deg", "12 mm", "1/3", "50%", "2*pi rad", "1 m + 20 cm"). A number without a unit is
/// in the shown unit, also beside one that has a unit. "1/50 s" is 0.02 s in
/// seconds and 0.02 Hz in hertz: what fits is meant. The decimal mark is a dot in every locale.
/// Nothing when the text does not parse, its unit measures something else, or the result is not finite.
[[nodiscard]] std::optional<double> evaluate(std::string_view text, Unit unit);

}  // namespace vitrine
