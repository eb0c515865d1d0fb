#pragma once

#include "render/gl/program_cache.h"
#include "render/gl/texture.h"

namespace vitrine::render::gl {

/// Generates the mip levels of an image from its level 0. Half-float pictures and cube maps whose sides halve exactly
/// are downsampled by this project's own program, which stays in the program cache on disk. A software driver would
/// recompile its built-in one at every start.
void makeMipmaps(const Texture&, ProgramCache&);

}  // namespace vitrine::render::gl
