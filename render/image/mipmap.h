#pragma once

#include "render/image/texture.h"

namespace vitrine::render {

/// Returns the next smaller mip level of a texture: half as wide and high, rounded down, at least 1. Each texel is the
/// mean of the area that it covers. On an odd side, texels share the border texels with their neighbors (Guthe and
/// Heckbert, "Non-Power-of-Two Mipmapping", 2005). sRGB colors are averaged in linear light, not weighted by alpha, as
/// in OpenGL. The driver is not used for this, because a software driver compiles shaders for it at every start.
[[nodiscard]] Texture halved(const Texture&);

}  // namespace vitrine::render
