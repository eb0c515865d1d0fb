#pragma once

#include "exhibits/framework/parameters.h"

#include <span>
#include <vector>

namespace vitrine {

/// The value of a row among several, each with its weight (at least 0, all together 1), never out of its range; there
/// are as many weights as values, at least one, and the values are legal. Where one has all the weight, exactly that
/// one; what has no weight counts for nothing.
///
///  - numbers: their weighted mean, in logarithms where the row's scale is logarithmic and all are positive; counts are
///    rounded to the nearest one. An angle whose range is a full turn: the mean on the circle, between two by the
///    shorter way round.
///  - colors: the mean in Oklab, brought into [0, 1] per component.
///  - directions: the mean on the sphere, which between two goes along the great circle (Shoemake 1985, "Animating
///    Rotation with Quaternion Curves") and among more is that of Buss and Fillmore (2001, "Spherical Averages and
///    Applications to Spherical Splines and Interpolation"); between opposite ones any way.
///  - toggles, choices, files and texts: the one of the largest weight, of equal ones the first. A number that is a
///    word for something else ("auto") is so switched as well; numbers beside it have their mean without it.
[[nodiscard]] Value morphed(const ParameterInfo&, std::span<const Value> values, std::span<const double> weights);

/// The same of two, on the way from `a` (t = 0) to `b` (t = 1): what is switched is `a` before the middle, and `b` from
/// there on.
[[nodiscard]] Value morphed(const ParameterInfo&, const Value& a, const Value& b, double t);

/// One of several settings of an exhibit, and how much it counts.
struct WeightedValues {
    const ParameterValues* values;  ///< Not null.
    double weight;                  ///< At least 0.
};

/// All rows of several settings of one exhibit, each as above. Where files give them different tables, that of the
/// largest weight counts, of equal ones the first, and rows that it alone has keep its values. Rows move as they do
/// there; where all move alike but for the two ends of the way, the ends are morphed.
[[nodiscard]] ParameterValues morphed(std::span<const WeightedValues>);

/// The same of two; exactly `a` at t <= 0 and `b` at t >= 1.
[[nodiscard]] ParameterValues morphed(const ParameterValues& a, const ParameterValues& b, double t);

}  // namespace vitrine
