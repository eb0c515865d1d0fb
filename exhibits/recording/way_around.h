#pragma once

#include "exhibits/museum/obstacles.h"

#include <glm/glm.hpp>

#include <vector>

namespace vitrine::recording {

/// Returns places between `from` and `to`, at most `stride` meters apart, along which a camera avoids obstacles: at a
/// walking user's height, where one can walk. The ends are excluded, and may be up to 2.5 m from such a place. Empty if
/// there is no way.
///
/// It is the shortest way over a grid of 0.25 m (A*: Hart, Nilsson and Raphael 1968), with corners cut where possible.
[[nodiscard]] std::vector<glm::dvec3> wayAround(const Obstacles&, const glm::dvec3& from, const glm::dvec3& to,
                                                double stride);

}  // namespace vitrine::recording
