#pragma once

#include "render/gl/program_cache.h"
#include "render/gl/texture.h"

namespace vitrine::render::gl {

/// Makes the lower levels of an image from its level 0. Cube maps of half floats whose sides are powers of two are
/// halved by a program of ours, which the cache on disk keeps; a software driver compiles its own anew at every start.
void makeMipmaps(const Texture&, ProgramCache&);

}  // namespace vitrine::render::gl
