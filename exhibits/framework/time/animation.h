#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>

namespace vitrine {

/// Returns the position of an animation between its ends, 0 to 1. Periods are counted in double, so that the timing
/// stays exact for days.
[[nodiscard]] double positionOf(const Motion&, const AnimationTime&);

/// Returns the parameter's value at that time, in its own space: `morphed` from one end to the other, never out of
/// range.
[[nodiscard]] Value valueOf(const ParameterInfo&, const Motion&, const AnimationTime&);

/// Returns the seconds until the parameter next changes by itself: 0 while it moves, infinity if it has ended, is held,
/// or depends on the distance alone. Switches and choices change only in the middle of a way.
[[nodiscard]] double nextChangeOf(const ParameterInfo&, const Motion&, double time);

/// The same for all animated parameters that act; infinity: none.
[[nodiscard]] double nextMotion(const ParameterValues&, double time);

/// Returns the values at that time: every animated parameter has its current value, and stays animated.
[[nodiscard]] ParameterValues valuesAt(const ParameterValues&, const AnimationTime&);

/// Returns the values with every animated parameter at one end of its way: 0, `from`; 1, `to`.
[[nodiscard]] ParameterValues valuesAtEnd(const ParameterValues&, int end);

/// Returns the animation frozen at this time, or continued from where it was frozen.
[[nodiscard]] Motion held(Motion, const AnimationTime&);
[[nodiscard]] Motion resumed(Motion, const AnimationTime&);

/// Returns a description for people: "sine between 0.1 and 0.9, period 4 s".
[[nodiscard]] std::string describe(const ParameterInfo&, const Motion&);

}  // namespace vitrine
