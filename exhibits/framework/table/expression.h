#pragma once

#include "exhibits/framework/table/units.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Evaluates text that a user typed for a quantity shown in `unit`; returns the value in SI. It may contain numbers, +
/// - * / ^, parentheses, pi, e, and units ("30deg", "12 mm", "1/3", "50%", "2*pi rad", "1 m + 20 cm"). A number without
/// a unit is in the shown unit, also next to one with a unit. "1/50 s" is 0.02 s for seconds and 0.02 Hz for hertz: the
/// reading that fits is used. The decimal mark is a dot in every locale. Returns nothing if the text does not parse,
/// its unit measures another quantity, or the result is not finite.
[[nodiscard]] std::optional<double> evaluate(std::string_view text, Unit unit);

/// Value of a name in an expression: in SI, with the unit in which it is shown.
struct NamedValue {
    double value = 0;
    Unit unit = Unit::none;
};
/// Returns the value of a name (letters, digits and _, no digit first), or nothing for an unknown name.
using ExpressionNames = std::function<std::optional<NamedValue>(std::string_view name)>;

/// The same with named values, and with functions of plain numbers and angles: sin, cos, sqrt, abs, floor, min, max,
/// mod (never negative for a positive divisor), clamp, mix, smoothstep. abs, floor, min, max, mod, clamp and mix keep
/// the unit of their arguments.
[[nodiscard]] std::optional<double> evaluate(std::string_view text, Unit unit, const ExpressionNames& names);

/// Returns the names whose values an expression needs, each once, in order.
[[nodiscard]] std::vector<std::string> namesIn(std::string_view text);

/// Returns whether the word is predefined in expressions: a unit, a constant or a function.
[[nodiscard]] bool isExpressionWord(std::string_view word);

}  // namespace vitrine
