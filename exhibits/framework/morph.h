#pragma once

#include "exhibits/framework/parameters.h"

namespace vitrine {

/// The value of a row on the way from `a` (t = 0) to `b` (t = 1), never out of its range; `a` and `b` are legal.
///
///  - numbers: evenly, in logarithms where the row's scale is logarithmic and both are positive; counts are rounded to
///    the nearest one. An angle whose range is a full turn goes the shorter way round.
///  - colors: evenly in Oklab, brought into [0, 1] per component.
///  - directions: along the great circle (Shoemake 1985, "Animating Rotation with Quaternion Curves"); between opposite
///    ones along any.
///  - toggles, choices, files, texts, and a number that is a word for something else ("auto"): `a` before the middle,
///    `b` from there on.
[[nodiscard]] Value morphed(const ParameterInfo&, const Value& a, const Value& b, double t);

/// All rows of two settings of one exhibit, each as above; exactly `a` at t <= 0 and `b` at t >= 1. Where files give
/// them different tables, the nearer one's table counts, and rows that the other lacks keep its values.
[[nodiscard]] ParameterValues morphed(const ParameterValues& a, const ParameterValues& b, double t);

}  // namespace vitrine
