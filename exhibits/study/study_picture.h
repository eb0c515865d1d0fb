#pragma once

#include "render/image/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace vitrine::study {

/// Returns the first four channels of a picture made by PictureMaker.
[[nodiscard]] render::Image colorsOf(const render::Image&);

/// Returns the color channels interpolated to another size in pixels, as a screen scales a smaller picture.
[[nodiscard]] render::Image resampled(const render::Image& from, glm::ivec2 size);

/// Returns the sum of a counting channel over all pixels, exact below 2^53; 0 if the picture has no such channel.
[[nodiscard]] std::int64_t channelTotal(const render::Image&, std::string_view channel);

/// Removes the counters of the program's state ("images", "programs", ...), which are not work of a picture.
void eraseStateCounters(std::map<std::string, std::int64_t>& counters);

}  // namespace vitrine::study
