#pragma once

#include <glm/glm.hpp>

namespace vitrine::render {

/// Converts linear Rec. 709 to Oklab (Ottosson 2020, "A perceptual color space for image processing") and back. Colors
/// interpolated in Oklab look perceptually in between. The inverse may leave [0, 1] near saturated colors.
[[nodiscard]] glm::dvec3 oklabFromLinear(const glm::dvec3& linear);
[[nodiscard]] glm::dvec3 linearFromOklab(const glm::dvec3& lab);

}  // namespace vitrine::render
