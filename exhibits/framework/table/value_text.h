#pragma once

#include "exhibits/framework/table/parameters.h"

#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// Parses a value typed for a parameter; nullopt if the text is invalid. Independent of the locale.
///
///  - real, count: an expression with units, see `evaluate`. Neither clamped nor rounded: pass it to
///    `ParameterValues::setParameter`, which reports whether it changed the value. The parameter's word for a value
///    ("auto") is also accepted, as are times of day ("17:30") for hours.
///  - toggle: on, off, true, false, yes, no, 1, 0.
///  - choice: one of its names; case matters only if two names differ in nothing else.
///  - color: "#rrggbb" or "#rgb" in sRGB, with or without the #, or "r,g,b" in linear light.
///  - direction: "x,y,z", of any length but zero; returned at unit length.
///  - file: the text itself.
[[nodiscard]] std::optional<Value> parseValue(const ParameterInfo&, std::string_view text);

/// The shortest text that `parseValue` reads back as the same bits: numbers in the shown unit without its
/// symbol ("30" for 30°), the word of a number outside of the range ("inf"), colors "r,g,b" in linear light, directions
/// "x,y,z".
[[nodiscard]] std::string formatValue(const ParameterInfo&, const Value&);

}  // namespace vitrine
