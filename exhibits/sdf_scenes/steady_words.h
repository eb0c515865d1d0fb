#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <vector>

namespace vitrine::scenes {

/// Returns for each number of a program whether it is time-invariant.
[[nodiscard]] std::vector<char> steadyWords(const SceneProgram&);

}  // namespace vitrine::scenes
