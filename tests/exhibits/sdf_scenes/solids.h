#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <string_view>

namespace vitrine::test {

/// Whether a point is inside of a shape of this kind with these numbers (SI, in the order of its fields), from what the
/// shape is and not from a distance; empty for kinds that have no such words (noise).
using Inside = std::function<bool(const glm::dvec3& p)>;
[[nodiscard]] Inside insideOf(std::string_view kind, const double* v);

class Random;

/// Whether no point of the other side was found within |d| of p, among many.
[[nodiscard]] bool isBound(const Inside&, const glm::dvec3& p, double d, Random&);

/// Whether both sides are found within `near` of p.
[[nodiscard]] bool isOnSurface(const Inside&, const glm::dvec3& p, double near, Random&);

}  // namespace vitrine::test
