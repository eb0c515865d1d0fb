#pragma once

#include "render/image/image.h"

#include <glm/glm.hpp>

namespace vitrine::render {

/// Returns the color of a pixel over black. One or two channels: gray. The second of two and the fourth are alpha.
[[nodiscard]] inline glm::dvec3 colorAt(const Image& image, int x, int y)
{
    const bool gray = image.channels < 3;
    const bool hasAlpha = image.channels == 2 || image.channels >= 4;
    const double alpha = hasAlpha ? image.at(x, y, gray ? 1 : 3) : 1.0;
    if (alpha == 0) return glm::dvec3(0);
    if (gray) return glm::dvec3(image.at(x, y, 0)) * alpha;
    return glm::dvec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) * alpha;
}

}  // namespace vitrine::render
