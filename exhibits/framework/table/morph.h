#pragma once

#include "exhibits/framework/table/parameters.h"

#include <span>
#include <vector>

namespace vitrine {

/// Interpolates several values of a parameter with weights (at least 0, sum 1); the result is never out of range. There
/// must be as many weights as values, at least one, and the values must be legal. If one has all the weight, the result
/// is exactly that value; values without weight have no effect.
///
///  - numbers: their weighted mean, in logarithms if the parameter's scale is logarithmic and all are positive; counts
///    are rounded to the nearest integer. An angle whose range is a full turn: the mean on the circle; between two
///    values by the shorter way.
///  - colors: the mean in Oklab, clamped to [0, 1] per component.
///  - directions: the mean on the sphere. Between two, it follows the great circle (Shoemake 1985, "Animating Rotation
///    with Quaternion Curves"); among more it is that of Buss and Fillmore (2001, "Spherical Averages and Applications
///    to Spherical Splines and Interpolation"). Between opposite directions the way is arbitrary.
///  - toggles, choices, files and texts: the value of the largest weight; of equal ones the first. A number with a
///    special meaning ("auto") is switched in the same way; the other numbers have their mean without it.
[[nodiscard]] Value morphed(const ParameterInfo&, std::span<const Value> values, std::span<const double> weights);

/// The same for two values, from `a` (t = 0) to `b` (t = 1). Values that are switched are `a` below t = 0.5, else `b`.
[[nodiscard]] Value morphed(const ParameterInfo&, const Value& a, const Value& b, double t);

/// Settings of an exhibit with their weight.
struct WeightedValues {
    const ParameterValues* values;  ///< Not null.
    double weight;                  ///< At least 0.
};

/// Interpolates all parameters of several settings of one exhibit, each as above. If files give them different sets of
/// parameters, those of the largest weight are used, of equal ones the first; parameters that only it has keep its
/// values. Animations are kept as well. If all settings have the same animation except for its two end values, these
/// are interpolated.
[[nodiscard]] ParameterValues morphed(std::span<const WeightedValues>);

/// The same for two settings; exactly `a` at t <= 0 and `b` at t >= 1.
[[nodiscard]] ParameterValues morphed(const ParameterValues& a, const ParameterValues& b, double t);

}  // namespace vitrine
