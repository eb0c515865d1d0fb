#pragma once

#include "exhibits/framework/parameters.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::ui {

/// Rows of a table and what each is to be set to.
using RowChanges = std::vector<std::pair<std::size_t, Value>>;

/// Changes of other rows after which row `row` acts (`acts`), the row that is changed first in front. Of several ways
/// the first one that its condition names. Empty where it acts already; nothing where only a file would make it act.
[[nodiscard]] std::optional<RowChanges> changesToAct(const ParameterValues&, std::size_t row);

}  // namespace vitrine::ui
