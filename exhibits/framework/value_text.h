#pragma once

#include "exhibits/framework/parameters.h"

#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// The value that someone typed for a row, or nothing when the text means none. The same in every locale.
///
///  - real, count: an expression with units, see `evaluate`. Not clamped, and a count not rounded: give it to
///    `ParameterValues::setRow`, which says whether it had to change it. The row's word for a value ("auto") is that
///    value; hours of the day may be written "17:30".
///  - toggle: on, off, true, false, yes, no, 1, 0.
///  - choice: one of its names; upper and lower case matter only where names differ in nothing else.
///  - color: "#rrggbb" or "#rgb" in sRGB, with or without the #, or "r,g,b" in linear light.
///  - direction: "x,y,z", of any length but zero; returned at unit length.
///  - file: the text itself.
[[nodiscard]] std::optional<Value> parseValue(const ParameterInfo&, std::string_view text);

/// The shortest text that `parseValue` reads back as the same bits: numbers in the shown unit without its
/// symbol ("30" for 30°), colors "r,g,b" in linear light, directions "x,y,z".
[[nodiscard]] std::string formatValue(const ParameterInfo&, const Value&);

}  // namespace vitrine
