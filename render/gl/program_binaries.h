#pragma once

#include <epoxy/gl.h>

#include <string_view>

namespace vitrine::render::gl {

/// Linked programs in the user's cache folder ($XDG_CACHE_HOME/vitrine/programs or ~/.cache/...), by a
/// hash of source, renderer and driver version. Every failure is silent: the cache only saves time.
/// VITRINE_NO_PROGRAM_CACHE in the environment turns it off.
[[nodiscard]] bool loadProgramBinary(GLuint program, std::string_view source);
void saveProgramBinary(GLuint program, std::string_view source);

}  // namespace vitrine::render::gl
