#pragma once

#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/step_lists.h"

#include <string>

namespace vitrine::scenes {

/// GLSL that walks lists of steps (`step_lists.h`) in place of the steps themselves: the same functions as by
/// `sceneGlsl`, for every scene of this vocabulary. At each point it asks what the point's cell names
/// (shaders/sdf_scenes/near.glsl), and `planes` half spaces beside it.
[[nodiscard]] std::string listGlsl(const ListVocabulary&, std::uint32_t planes, const FurtherMember& = {});

}  // namespace vitrine::scenes
