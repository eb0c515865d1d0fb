#pragma once

#include "render/image/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace vitrine {

/// The first four channels of a picture as PictureMaker makes it.
[[nodiscard]] render::Image colorsOf(const render::Image&);

/// Color only, interpolated at another size in pixels: what a screen does with a picture of fewer pixels.
[[nodiscard]] render::Image resampled(const render::Image& from, glm::ivec2 size);

/// Sum of a counting channel over all pixels, exact while below 2^53; 0 where the picture has no channel of that name.
[[nodiscard]] std::int64_t channelTotal(const render::Image&, std::string_view channel);

/// Leaves out the counters of the program's state ("images", "programs", ...), which are not of a picture's work.
void eraseStateCounters(std::map<std::string, std::int64_t>& counters);

}  // namespace vitrine
