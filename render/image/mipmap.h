#pragma once

#include "render/scene/mesh.h"

namespace vitrine::render {

/// The next smaller level of a texture's mipmaps: half as wide and high, rounded down, at least 1. Each texel is the
/// mean of the area that it covers: where a side is odd it shares the texels at its borders with its neighbors (Guthe
/// and Heckbert, "Non-Power-of-Two Mipmapping", 2005). Colors of sRGB are averaged in linear light; alpha does not
/// weigh them, as in OpenGL. Done here and not by the driver: a software driver compiles shaders for it at every start.
[[nodiscard]] Texture halved(const Texture&);

}  // namespace vitrine::render
