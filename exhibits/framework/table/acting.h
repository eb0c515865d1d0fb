#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstddef>
#include <span>
#include <string>

namespace vitrine {

/// Returns whether the condition holds, and the parameters that it tests act themselves.
[[nodiscard]] bool holds(const Condition&, const ParameterValues&);

/// Returns whether parameter `row` has an effect ("acts"): its condition holds, and the parameters that it tests act
/// themselves. A parameter without effect changes no picture and keeps its value.
[[nodiscard]] bool acts(const ParameterValues&, std::size_t row);

/// Returns the condition under which parameter `row` acts, by the labels of the tested parameters: "“Shadow filter” is
/// sun's disk". Empty: it always acts.
[[nodiscard]] std::string actsWhen(const Parameters&, std::size_t row);
/// The same, followed by the conditions of the tested parameters that do not act themselves with these values.
[[nodiscard]] std::string actsWhen(const ParameterValues&, std::size_t row);

/// Returns the values, with every parameter that does not act at its initial value. The results are equal for two
/// snapshots that differ only in such parameters.
[[nodiscard]] ParameterValues actingValues(const ParameterValues&);

/// Changes as few other parameters as necessary so that parameter `row` acts (`acts`), none of them in `fixed`. Among
/// equally short ways, takes the first one that the condition names. Returns whether the parameter acts now; if not,
/// nothing was changed. Never changes files.
bool makeAct(ParameterValues&, std::size_t row, std::span<const std::size_t> fixed);

}  // namespace vitrine
