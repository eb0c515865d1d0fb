#pragma once

#include <glm/glm.hpp>

namespace vitrine::render {

/// Oklab (Ottosson 2020, "A perceptual color space for image processing") of linear Rec. 709, and back. What lies
/// between two colors there looks as if it lay between them. The inverse may leave [0, 1] beside saturated colors.
[[nodiscard]] glm::dvec3 oklabFromLinear(const glm::dvec3& linear);
[[nodiscard]] glm::dvec3 linearFromOklab(const glm::dvec3& lab);

}  // namespace vitrine::render
