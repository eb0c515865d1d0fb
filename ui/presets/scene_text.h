#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

namespace vitrine::ui {

/// Returns the scene state as the text of an exhibition file, which is self-contained. `chosen`: the exhibit whose
/// parameters are shown.
[[nodiscard]] std::string textOf(const Museum&, const SceneState&, std::size_t chosen, const std::string& name);

/// Reads a scene state from the text of an exhibition file. `notes` gets what was corrected or unknown. `fileName` is
/// for messages. `chosen` is set to the chosen exhibit, or to the one in the middle of the picture if the file names
/// none. Throws Failure naming file, line and key.
[[nodiscard]] SceneState lookFrom(const Museum&, std::string text, std::string fileName,
                                  std::vector<std::string>& notes, std::size_t* chosen = nullptr);

}  // namespace vitrine::ui
