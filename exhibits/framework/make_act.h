#pragma once

#include "exhibits/framework/parameters.h"

#include <cstddef>
#include <span>

namespace vitrine {

/// Whether the condition holds, and the rows that it looks at act themselves.
[[nodiscard]] bool holds(const Condition&, const ParameterValues&);

/// Changes as few other rows as it takes for row `row` to act (`acts`), none of them in `fixed`. Of several ways with
/// as few changes, the first that the condition names. Returns whether the row acts now; if not, nothing was changed.
/// Files cannot be chosen for it.
bool makeAct(ParameterValues&, std::size_t row, std::span<const std::size_t> fixed);

}  // namespace vitrine
