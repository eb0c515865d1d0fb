#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace vitrine::render::gl {

/// Linked programs in the user's cache folder ($XDG_CACHE_HOME/vitrine/programs or ~/.cache/vitrine/programs), by a
/// hash of source, renderer and driver version. Every failure is silent: the cache only saves time. The environment
/// variable VITRINE_NO_PROGRAM_CACHE turns it off.
/// Generated shaders add new programs all the time. So at most `mostStored` binaries are kept; the least recently used
/// are deleted.
inline constexpr std::size_t mostStored = 2000;
[[nodiscard]] bool loadProgramBinary(GLuint program, std::string_view source);
void saveProgramBinary(GLuint program, std::string_view source);

/// Deletes all binaries of a folder except the `most` that were written or used last.
void dropOldBinaries(const std::filesystem::path& folder, std::size_t most);

}  // namespace vitrine::render::gl
