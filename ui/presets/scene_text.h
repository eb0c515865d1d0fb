#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

namespace vitrine::ui {

/// The look as the text of an exhibition: everything in one file. `chosen`: the exhibit whose parameters are on show.
[[nodiscard]] std::string textOf(const Museum&, const SceneState&, std::size_t chosen, const std::string& name);

/// The look in the text of an exhibition. What reading changed or did not know goes to `notes`. Throws
/// Failure naming file, line and key; `fileName` is for messages. `chosen`: the exhibit that was chosen, or where the
/// file does not say it, the one in the middle of the picture.
[[nodiscard]] SceneState lookFrom(const Museum&, std::string text, std::string fileName,
                                  std::vector<std::string>& notes, std::size_t* chosen = nullptr);

}  // namespace vitrine::ui
