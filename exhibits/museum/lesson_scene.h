#pragma once

#include "exhibits/framework/files/lesson.h"
#include "exhibits/museum/scene_state.h"

#include <cstddef>

namespace vitrine {

class Museum;

/// Returns the scene state that a step of a lesson shows: `before`, with the step's values of the exhibit and of the
/// hall, and its camera if it has one.
[[nodiscard]] SceneState sceneOfStep(const Museum&, std::size_t exhibit, const LessonStep&, SceneState before);

}  // namespace vitrine
