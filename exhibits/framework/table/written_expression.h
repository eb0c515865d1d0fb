#pragma once

#include "exhibits/framework/table/units.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// Name of an expression as GLSL: a float in SI, and the unit in which it is shown.
struct WrittenValue {
    std::string glsl;
    Unit unit = Unit::none;
};
using WrittenNames = std::function<std::optional<WrittenValue>(std::string_view name)>;

/// Returns a GLSL float with the value in SI that `evaluate` (expression.h) gives for the same text, unit and names.
/// Returns nothing for a text that it does not parse.
[[nodiscard]] std::optional<std::string> writtenExpression(std::string_view text, Unit unit, const WrittenNames&);

}  // namespace vitrine
