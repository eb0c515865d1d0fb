#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstddef>
#include <span>
#include <string>

namespace vitrine {

/// Returns whether the condition holds, and the parameters that it tests act themselves.
[[nodiscard]] bool holds(const Condition&, const ParameterValues&);

/// Whether row `row` acts: its condition holds, and the rows that it looks at act themselves. A row that does not act
/// changes no picture and keeps its value.
[[nodiscard]] bool acts(const ParameterValues&, std::size_t row);

/// When row `row` acts, by the labels of the other rows: "“Shadow filter” is sun's disk". Empty: always.
[[nodiscard]] std::string actsWhen(const Parameters&, std::size_t row);
/// The same, and of every row in it that does not act itself, when that one does.
[[nodiscard]] std::string actsWhen(const ParameterValues&, std::size_t row);

/// The values with every row that does not act at its initial value: alike for two snapshots that differ in such rows
/// alone.
[[nodiscard]] ParameterValues actingValues(const ParameterValues&);

/// Changes as few other parameters as necessary so that parameter `row` acts (`acts`), none of them in `fixed`. Among
/// equally short ways, takes the first one that the condition names. Returns whether the parameter acts now; if not,
/// nothing was changed. Never changes files.
bool makeAct(ParameterValues&, std::size_t row, std::span<const std::size_t> fixed);

}  // namespace vitrine
