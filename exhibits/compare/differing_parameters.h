#pragma once

#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::compare {

/// Parameter whose values in two settings, A and B, differ.
struct DifferingParameter {
    std::size_t subject = 0;    ///< Index in SceneState::values.
    std::string name;           ///< Name of the parameter; tables made from files identify parameters by name only.
    ParameterInfo info;         ///< A's parameter, or B's if A has none; valid as long as the settings.
    std::optional<Value> a, b;  ///< Unset if the table of that setting lacks the parameter.
    bool actsInA = false, actsInB = false;
};

/// Returns every parameter in which the two differ, by subject and in the order of the tables, those of B alone last.
/// Parameters with the same name but of different kind are different ones. Both must be of one museum.
[[nodiscard]] std::vector<DifferingParameter> differingParameters(const SceneState& a, const SceneState& b);

/// Copies a parameter's value from `from` to `to`, as the nearest legal value there. Documents of files are copied
/// along. Returns whether both tables have the parameter.
bool copyParameter(const SceneState& from, SceneState& to, std::size_t subject, const std::string& name);

/// Returns a value with its unit, in the form of `--set`: "30°", "0.5", "hard".
[[nodiscard]] std::string valueWithUnit(const ParameterInfo&, const Value&);

}  // namespace vitrine::compare
