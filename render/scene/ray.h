#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace vitrine::render {

/// A half line. Distances along it are in multiples of `direction`'s length, so that a transform does not change them.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};

    [[nodiscard]] glm::dvec3 at(double distance) const { return origin + distance * direction; }
    [[nodiscard]] Ray transformed(const glm::dmat4& transform) const;
};

/// Interval of a ray inside a box, from `enter` (0 if the ray starts inside) to `exit`. `enter > exit`: the ray misses
/// the box.
struct RayInterval {
    double enter = 0, exit = 0;
};
[[nodiscard]] RayInterval insideBox(const Ray&, const Box&);

enum class Faces : std::uint8_t { front, both };

// Returns the distance to the first hit; infinity if there is none.
[[nodiscard]] double firstHit(const Ray&, const Box&);
/// The same for a sphere around `center`; 0 from inside.
[[nodiscard]] double firstHit(const Ray&, const glm::dvec3& center, double radius);
/// The same for a triangle mesh (Möller and Trumbore 1997). `front`: counter-clockwise faces only. Tests every
/// triangle, unless the ray misses the bounds: 60,000 triangles take less than a millisecond.
[[nodiscard]] double firstHit(const Ray&, const Mesh&, Faces);
/// The same for a part with its transform. For a mirrored part both faces count.
[[nodiscard]] double firstHit(const Ray&, const MeshInstance&, Faces);

}  // namespace vitrine::render
