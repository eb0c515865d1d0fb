#pragma once

#include "exhibits/framework/table/parameters.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::ui {

/// Parameters of a table and their new values.
using RowChanges = std::vector<std::pair<std::size_t, Value>>;

/// Returns the changes of other parameters that give parameter `row` an effect (`acts`), in the order to make them. Of
/// several ways, the first in its condition is taken. Empty if it has an effect already; nullopt if only a file would
/// give it one.
[[nodiscard]] std::optional<RowChanges> changesToAct(const ParameterValues&, std::size_t row);

}  // namespace vitrine::ui
