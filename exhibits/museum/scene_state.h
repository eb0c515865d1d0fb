#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/scene/camera.h"

#include <cstddef>
#include <vector>

namespace vitrine {

/// Index of the hall among the subjects of a museum and in SceneState::values; the exhibits follow.
inline constexpr std::size_t hallIndex = 0;

/// Snapshot of everything that can be set: the parameter values of each subject, and the camera. Undo, presets of the
/// whole exhibition and A/B comparisons store scene states.
struct SceneState {
    std::vector<ParameterValues> values;  ///< In the order of Museum::subjects().
    render::Camera camera;

    [[nodiscard]] ParameterValues& hall() { return values[hallIndex]; }
    [[nodiscard]] const ParameterValues& hall() const { return values[hallIndex]; }

    bool operator==(const SceneState&) const = default;
};

}  // namespace vitrine
