#pragma once

#include "exhibits/museum/museum.h"

#include <string>
#include <vector>

namespace vitrine::ui {

/// Text of one stage of a pass's program, as the driver gets it.
struct PassText {
    std::string pass;   ///< "sdf_morph/march".
    std::string stage;  ///< "vertex", "fragment" or "compute".
    std::string text;   ///< With all includes; a comment names the file where each begins.
};

/// Returns the shaders that draw a subject in the picture of the request, generated ones included, each text once.
/// Thread-safe; takes as long as preparing and planning a frame.
[[nodiscard]] std::vector<PassText> passTexts(const Museum&, const SceneState&, const FrameRequest&,
                                              std::size_t subject);

}  // namespace vitrine::ui
