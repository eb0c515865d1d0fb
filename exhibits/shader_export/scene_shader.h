#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/shader_export/exported_shader.h"

namespace vitrine::guest {

/// Returns the shader that a scene shows at the moment of the request: the visitor's own, or one that draws the exhibit
/// alone. Reads the files that the settings name, and takes as long as preparing a frame. Thread-safe. Throws Failure
/// with a sentence on why the exhibit cannot be exported.
[[nodiscard]] ExportedShader sceneShader(const Museum&, const SceneState&, std::size_t subject, const FrameRequest&);

}  // namespace vitrine::guest
