#pragma once

#include "exhibits/framework/parameters.h"
#include "render/scene/camera.h"

#include <cstddef>
#include <vector>

namespace vitrine {

/// Where the hall comes among the subjects of a museum, and its values in a SceneState; the exhibits come after it.
inline constexpr std::size_t hallIndex = 0;

/// A snapshot of everything that can be set: one set of values per subject of the museum, and the camera. Undo, presets
/// of everything and A/B comparisons are Looks.
struct SceneState {
    std::vector<ParameterValues> values;  ///< In the order of Museum::subjects().
    render::Camera camera;

    [[nodiscard]] ParameterValues& hall() { return values[hallIndex]; }
    [[nodiscard]] const ParameterValues& hall() const { return values[hallIndex]; }

    bool operator==(const SceneState&) const = default;
};

}  // namespace vitrine
