#pragma once

#include "render/scene/mesh.h"

#include <memory>

namespace vitrine::test {

/// Returns a box whose faces have outward normals and are counter-clockwise seen from outside.
[[nodiscard]] inline std::shared_ptr<const render::Mesh> boxOf(const render::Box& box)
{
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "box";
    mesh->bounds = box;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            const auto first = static_cast<std::uint32_t>(mesh->vertices.size());
            for (const glm::ivec2 c : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1)}) {
                glm::dvec3 p = box.low;
                p[axis] = side == 1 ? box.high[axis] : box.low[axis];
                if ((side == 1 ? c.x : 1 - c.x) == 1) p[u] = box.high[u];
                if (c.y == 1) p[v] = box.high[v];
                glm::vec3 normal(0);
                normal[axis] = side == 1 ? 1.0F : -1.0F;
                mesh->vertices.push_back({.position = glm::vec3(p), .normal = normal});
            }
            mesh->indices.insert(mesh->indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    return mesh;
}

}  // namespace vitrine::test
