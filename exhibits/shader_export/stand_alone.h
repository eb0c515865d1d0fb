#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/shader_export/exported_shader.h"

namespace vitrine::guest {

/// Returns an ISF that draws an exhibit alone: the shader of its one pass, with includes and permutations resolved and
/// only the functions that it needs. Its parameters become inputs, its other numbers constants, and three inputs move
/// the camera around the exhibit. Takes as long as preparing a frame; thread-safe. Throws Failure (ErrorKind::check)
/// with a sentence on what keeps the exhibit from standing alone: several passes, pictures, buffers.
[[nodiscard]] std::string standAloneText(const Museum&, const SceneState&, std::size_t subject,
                                         std::vector<Message>& notes);

/// Returns the same as a shader that can be written in any form.
[[nodiscard]] ExportedShader standAloneShader(const Museum&, const SceneState&, std::size_t subject);

/// Returns why the exhibit cannot stand alone; empty if it can. Throws nothing.
[[nodiscard]] Message whyNotAlone(const Museum&, const SceneState&, std::size_t subject);

}  // namespace vitrine::guest
