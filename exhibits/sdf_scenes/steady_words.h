#pragma once

#include "exhibits/sdf_scenes/scene_program.h"

#include <vector>

namespace vitrine::scenes {

/// Which words of a program stay as they are while time runs, by word: those whose numbers do not depend on it.
[[nodiscard]] std::vector<char> steadyWords(const SceneProgram&);

}  // namespace vitrine::scenes
