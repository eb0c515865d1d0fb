#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace vitrine::render {

/// A half line. Distances along it are counted in lengths of `direction`, so that they are the same in every space.
struct Ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};

    [[nodiscard]] glm::dvec3 at(double distance) const { return origin + distance * direction; }
    [[nodiscard]] Ray transformed(const glm::dmat4& transform) const;
};

/// Where a ray is inside a box: enters at `enter` (0 when it starts inside) and leaves at `exit`; `enter > exit`:
/// never.
struct Stretch {
    double enter = 0, exit = 0;
};
[[nodiscard]] Stretch insideBox(const Ray&, const Box&);

enum class Faces : std::uint8_t { front, both };

// Distance to the first point that is hit; infinity where there is none.
[[nodiscard]] double firstHit(const Ray&, const Box&);
/// Of a sphere of this radius about `center`; from inside, 0.
[[nodiscard]] double firstHit(const Ray&, const glm::dvec3& center, double radius);
/// Of a triangle mesh (Möller and Trumbore 1997); `front`: counter-clockwise faces only. Tries every triangle, unless
/// the ray misses the bounds: 60,000 triangles take less than a millisecond.
[[nodiscard]] double firstHit(const Ray&, const Mesh&, Faces);
/// Of a part where it stands; of a mirrored one both faces count.
[[nodiscard]] double firstHit(const Ray&, const MeshInstance&, Faces);

}  // namespace vitrine::render
