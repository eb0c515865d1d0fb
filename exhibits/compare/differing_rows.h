#pragma once

#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// A row that two settings, A and B, have different values in.
struct DifferingRow {
    std::size_t subject = 0;    ///< By its index in SceneState::values.
    std::string name;           ///< Of the row: tables that files made tell their rows by name only.
    ParameterInfo info;         ///< Of A, or of B where A has no such row; valid while the settings are.
    std::optional<Value> a, b;  ///< Nothing: the table of that one lacks the row.
    bool actsInA = false, actsInB = false;
};

/// Every row in which the two differ, subject by subject in the order of the tables, those that only B has last. A row
/// of another kind under the same name is another row. Both are of one museum.
[[nodiscard]] std::vector<DifferingRow> differingRows(const SceneState& a, const SceneState& b);

/// Gives `to` the value that `from` has in that row, or the nearest legal one there; files take their documents with
/// them. Returns whether both tables have such a row.
bool copyRow(const SceneState& from, SceneState& to, std::size_t subject, const std::string& name);

/// A value with its unit, as `--set` takes it: "30°", "0.5", "hard".
[[nodiscard]] std::string valueWithUnit(const ParameterInfo&, const Value&);

}  // namespace vitrine
