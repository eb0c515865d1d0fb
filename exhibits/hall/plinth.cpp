#include "exhibits/hall/plinth.h"

#include "render/scene/held_bytes.h"
#include "render/scene/mesh_shading.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace vitrine::hall {
namespace {

/// Adds the four sides of a plinth between two levels (half width, height), flat shaded.
void addPlinthSides(render::Mesh& mesh, glm::vec2 lower, glm::vec2 upper)
{
    const glm::vec2 along = glm::normalize(upper - lower);
    for (int side = 0; side < 4; ++side) {
        const float c = side == 0 ? 1.0F : side == 2 ? -1.0F : 0.0F, s = side == 1 ? 1.0F : side == 3 ? -1.0F : 0.0F;
        const auto at = [&](float out, float aside, float y) {
            return glm::vec3(out * c - aside * s, y, -(out * s + aside * c));
        };
        const glm::vec3 normal = at(along.y, 0, -along.x);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [ring, sign] : {std::pair(lower, -1.0F), {lower, 1.0F}, {upper, 1.0F}, {upper, -1.0F}})
            mesh.vertices.push_back(
                {at(ring.x, sign * ring.x, ring.y), normal, {1, 0, 0, 1}, {sign * ring.x, 1 - ring.y}, {}});
        mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
}

}  // namespace

render::AssetStore::Made<render::Mesh> makePlinth(double halfWidth, double height)
{
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "plinth";
    const auto w = static_cast<float>(halfWidth), h = static_cast<float>(height);
    const float foot = std::min(0.08F, 0.25F * h), slab = std::min(0.05F, 0.2F * h), edge = std::min(0.006F, 0.05F * h);
    const glm::vec2 profile[] = {{w, 0},
                                 {w, foot - edge},
                                 {w - edge, foot},
                                 {w - 0.03F, foot},
                                 {w - 0.03F, h - slab},
                                 {w - 0.01F - edge, h - slab},
                                 {w - 0.01F, h - slab + edge},
                                 {w - 0.01F, h - edge},
                                 {w - 0.01F - edge, h}};
    for (std::size_t i = 0; i + 1 < std::size(profile); ++i) addPlinthSides(*mesh, profile[i], profile[i + 1]);
    const float top = profile[std::size(profile) - 1].x;
    const auto first = static_cast<std::uint32_t>(mesh->vertices.size());
    for (const glm::vec2 c : {glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1), glm::vec2(-1, -1)})
        mesh->vertices.push_back({{top * c.x, h, top * c.y}, {0, 1, 0}, {1, 0, 0, 1}, top * c, {}});
    mesh->indices.insert(mesh->indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    mesh->bounds = {{-halfWidth, 0, -halfWidth}, {halfWidth, height, halfWidth}};
    render::makeTangents(*mesh);
    const std::uint64_t bytes = heldBytes(*mesh);
    return {std::move(mesh), bytes};
}

}  // namespace vitrine::hall
