#pragma once

#include "render/image/image.h"

#include <glm/glm.hpp>

namespace vitrine {

/// The first four channels of a picture as PictureMaker makes it.
[[nodiscard]] render::Image colorsOf(const render::Image&);

/// Color only, interpolated at another size in pixels: what a screen does with a picture of fewer pixels.
[[nodiscard]] render::Image resampled(const render::Image& from, glm::ivec2 size);

}  // namespace vitrine
