#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <string_view>

namespace vitrine::test {

/// Returns a test whether a point is inside of a shape of this kind with these numbers (SI, in the order of its
/// fields), from the shape's definition and not from a distance. Empty for kinds without such a definition (noise).
using Inside = std::function<bool(const glm::dvec3& p)>;
[[nodiscard]] Inside insideOf(std::string_view kind, const double* v);

class Random;

/// Returns whether no point of the other side was found within |d| of p, among many random ones.
[[nodiscard]] bool isBound(const Inside&, const glm::dvec3& p, double d, Random&);

/// Returns whether points of both sides were found within `near` of p.
[[nodiscard]] bool isOnSurface(const Inside&, const glm::dvec3& p, double near, Random&);

}  // namespace vitrine::test
