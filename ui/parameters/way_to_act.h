#pragma once

#include "exhibits/framework/table/parameters.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::ui {

/// Parameters of a table and their new values.
using ParameterChanges = std::vector<std::pair<std::size_t, Value>>;

/// Returns the changes of other parameters that give parameter `row` an effect (`makeAct`). Empty if it has an effect
/// already; nullopt if only a file would give it one.
[[nodiscard]] std::optional<ParameterChanges> changesToAct(const ParameterValues&, std::size_t row);

/// Parameter of a group without any effect that needs the fewest changes to get one.
struct IdleGroup {
    std::size_t row;
    ParameterChanges changes;  ///< Empty if only a file would give the group an effect.
};

/// Returns nullopt if one of the parameters has an effect, or if there are none.
[[nodiscard]] std::optional<IdleGroup> idleGroup(const ParameterValues&, std::span<const std::size_t> rows);

/// Returns the command that makes the changes: "Set “Technique” to screen space". Empty without changes.
[[nodiscard]] QString changesText(const ParameterValues&, const ParameterChanges&);

}  // namespace vitrine::ui
