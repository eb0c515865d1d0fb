#pragma once

#include "exhibits/framework/parameters.h"

#include <cstddef>
#include <span>

namespace vitrine {

/// Returns whether the condition holds, and the parameters that it tests act themselves.
[[nodiscard]] bool holds(const Condition&, const ParameterValues&);

/// Changes as few other parameters as necessary so that parameter `row` acts (`acts`), none of them in `fixed`. Among
/// equally short ways, takes the first one that the condition names. Returns whether the parameter acts now; if not,
/// nothing was changed. Never changes files.
bool makeAct(ParameterValues&, std::size_t row, std::span<const std::size_t> fixed);

}  // namespace vitrine
