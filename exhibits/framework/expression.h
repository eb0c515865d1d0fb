#pragma once

#include "exhibits/framework/units.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The value, in SI, of what someone typed for a quantity shown in `unit`: numbers, + - * / ^, parentheses,
/// pi, e, and units ("30deg", "12 mm", "1/3", "50%", "2*pi rad", "1 m + 20 cm"). A number without a unit is
/// in the shown unit, also beside one that has a unit. "1/50 s" is 0.02 s in
/// seconds and 0.02 Hz in hertz: what fits is meant. The decimal mark is a dot in every locale.
/// Nothing when the text does not parse, its unit measures something else, or the result is not finite.
[[nodiscard]] std::optional<double> evaluate(std::string_view text, Unit unit);

/// What a name in an expression stands for: a value in SI, and the unit in which it is shown.
struct NamedValue {
    double value = 0;
    Unit unit = Unit::none;
};
/// The value of a name (letters, digits and _, no digit first), or nothing where there is none of that name.
using ExpressionNames = std::function<std::optional<NamedValue>(std::string_view name)>;

/// As above, with names that stand for values, and with functions of plain numbers and angles: sin, cos, sqrt, abs,
/// floor, min, max, mod (never negative for a positive divisor), clamp, mix, smoothstep. abs, floor, min, max, mod,
/// clamp and mix keep the unit of what they are given.
[[nodiscard]] std::optional<double> evaluate(std::string_view text, Unit unit, const ExpressionNames& names);

/// The names in an expression that must be given, each once, in order.
[[nodiscard]] std::vector<std::string> namesIn(std::string_view text);

/// Whether expressions know this word already: a unit, a constant or a function.
[[nodiscard]] bool isExpressionWord(std::string_view word);

}  // namespace vitrine
