#include "exhibits/sdf_scenes/scene_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace vitrine::scenes {

SimplifiedMesh simplified(const SceneMesh& mesh, const Simplification& wanted)
{
    if (mesh.indices.empty()) return {mesh, 0};
    const float* positions = &mesh.vertices.front().position.x;
    const std::size_t count = mesh.vertices.size();
    const float scale = meshopt_simplifyScale(positions, count, sizeof(MeshVertex));
    // The library measures deviations relative to the size of the mesh.
    const float most =
        wanted.deviation > 0 ? static_cast<float>(wanted.deviation) / scale : std::numeric_limits<float>::max();
    const std::size_t target =
        std::min(std::size_t{3} * static_cast<std::size_t>(std::max(wanted.triangles, 0)), mesh.indices.size());
    SimplifiedMesh result;
    std::vector<std::uint32_t>& indices = result.mesh.indices;
    indices.resize(mesh.indices.size());
    float deviation = 0;
    indices.resize(meshopt_simplify(indices.data(), mesh.indices.data(), mesh.indices.size(), positions, count,
                                    sizeof(MeshVertex), target, most, 0, &deviation));
    result.deviation = static_cast<double>(deviation) * static_cast<double>(scale);
    constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> place(count, unseen);
    for (std::uint32_t& index : indices) {
        if (place[index] == unseen) {
            place[index] = static_cast<std::uint32_t>(result.mesh.vertices.size());
            result.mesh.vertices.push_back(mesh.vertices[index]);
        }
        index = place[index];
    }
    return result;
}

}  // namespace vitrine::scenes
