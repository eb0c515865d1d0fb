#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace vitrine::render::gl {

/// Linked programs in the user's cache folder ($XDG_CACHE_HOME/vitrine/programs or ~/.cache/...), by a
/// hash of source, renderer and driver version. Every failure is silent: the cache only saves time.
/// VITRINE_NO_PROGRAM_CACHE in the environment turns it off.
/// Generated shaders bring ever new ones: of more than `mostStored` binaries the ones that were not used for the
/// longest time are deleted.
inline constexpr std::size_t mostStored = 2000;
[[nodiscard]] bool loadProgramBinary(GLuint program, std::string_view source);
void saveProgramBinary(GLuint program, std::string_view source);

/// Deletes all but the `most` binaries of a folder that were written or used last.
void dropOldBinaries(const std::filesystem::path& folder, std::size_t most);

}  // namespace vitrine::render::gl
