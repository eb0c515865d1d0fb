#pragma once

#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/step_lists.h"

#include <string>

namespace vitrine::scenes {

/// Generates GLSL that evaluates lists of steps (`step_lists.h`) instead of the steps of one scene. It defines the same
/// functions as `sceneGlsl`, for every scene of this vocabulary. At each point it evaluates the list of the point's
/// cell (shaders/sdf_scenes/near.glsl), and `planes` half spaces besides.
[[nodiscard]] std::string listGlsl(const ListVocabulary&, std::uint32_t planes, const FurtherMember& = {});

}  // namespace vitrine::scenes
