#pragma once

#include "render/scene/mesh.h"

#include <cstdint>
#include <set>

namespace vitrine::render {

/// Returns the bytes of memory that the texels take.
[[nodiscard]] inline std::uint64_t heldBytes(const Texture& texture)
{
    return texture.bytes.size() + texture.floats.size() * sizeof(float);
}

[[nodiscard]] inline std::uint64_t heldBytes(const Mesh& mesh)
{
    return mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t) +
           mesh.colors.size() * sizeof(glm::vec4);
}

/// Returns the bytes of all meshes and textures; shared ones count once.
[[nodiscard]] inline std::uint64_t heldBytes(const Model& model)
{
    std::set<const void*> counted;
    std::uint64_t sum = 0;
    const auto add = [&](const auto& shared) {
        if (shared && counted.insert(shared.get()).second) sum += heldBytes(*shared);
    };
    for (const MeshInstance& part : model.parts) {
        add(part.mesh);
        if (!part.material) continue;
        for (const auto* map :
             {&part.material->baseColorMap, &part.material->metallicRoughnessMap, &part.material->normalMap,
              &part.material->occlusionMap, &part.material->emissiveMap, &part.material->surfaceMap})
            add(*map);
    }
    return sum;
}

}  // namespace vitrine::render
