#pragma once

#include "exhibits/museum/obstacles.h"

#include <glm/glm.hpp>

#include <vector>

namespace vitrine {

/// Places between `from` and `to`, at most `stride` meters apart, by which a camera gets round what stands between
/// them: as a visitor walks, at his height, where it can. The ends are not among them and need only be near to where he
/// can stand. Empty: there is no such way. The shortest over a grid of 0.25 m (A*: Hart, Nilsson and Raphael 1968),
/// without the corners that can be cut.
[[nodiscard]] std::vector<glm::dvec3> wayAround(const Obstacles&, const glm::dvec3& from, const glm::dvec3& to,
                                                double stride);

}  // namespace vitrine
