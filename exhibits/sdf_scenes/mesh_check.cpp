#include "exhibits/sdf_scenes/scene_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace vitrine::scenes {
namespace {

/// Returns for each vertex the first one of the same position.
std::vector<std::uint32_t> joinedByPosition(const std::vector<MeshVertex>& vertices, std::size_t& joined)
{
    std::vector<std::uint32_t> order(vertices.size()), same(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) {
        const glm::vec3& p = vertices[i].position;
        return std::tuple(p.x, p.y, p.z, i);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool again = i > 0 && vertices[order[i]].position == vertices[order[i - 1]].position;
        same[order[i]] = again ? same[order[i - 1]] : order[i];
        joined += again;
    }
    return same;
}

/// Returns the number of directed edges that occur twice, or have no opposite edge.
std::size_t openEdges(const std::vector<std::uint32_t>& corners)
{
    std::vector<std::uint64_t> edges;
    edges.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t next = corners[i % 3 == 2 ? i - 2 : i + 1];
        edges.push_back(std::uint64_t{corners[i]} << 32U | next);
    }
    std::sort(edges.begin(), edges.end());
    std::size_t open = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::uint64_t opposite = edges[i] << 32U | edges[i] >> 32U;
        open += (i > 0 && edges[i] == edges[i - 1]) || !std::binary_search(edges.begin(), edges.end(), opposite);
    }
    return open;
}

/// Returns the number of vertices whose triangles do not form a single ring.
std::size_t brokenVertices(const std::vector<std::uint32_t>& corners, std::size_t vertices)
{
    std::vector<std::uint32_t> first(vertices + 1, 0);
    for (const std::uint32_t v : corners) ++first[v + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> at(first.begin(), first.end() - 1), triangles(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) triangles[at[corners[i]]++] = static_cast<std::uint32_t>(i);
    std::size_t broken = 0;
    std::vector<std::array<std::uint32_t, 2>> ring;  // For each triangle, the corners after and before the vertex.
    for (std::size_t v = 0; v < vertices; ++v) {
        ring.clear();
        for (std::size_t k = first[v]; k < first[v + 1]; ++k) {
            const std::uint32_t i = triangles[k], base = i / 3 * 3;
            ring.push_back({corners[base + (i + 1) % 3], corners[base + (i + 2) % 3]});
        }
        if (ring.empty()) continue;
        std::size_t turned = 0;
        std::uint32_t here = ring.front()[0];
        do {
            const auto next = std::find_if(ring.begin(), ring.end(), [&](const auto& pair) { return pair[0] == here; });
            if (next == ring.end()) break;
            here = (*next)[1];
            ++turned;
        } while (here != ring.front()[0] && turned < ring.size());
        broken += turned != ring.size() || here != ring.front()[0];
    }
    return broken;
}

/// Returns the number of triangles whose corners are those of another one.
std::size_t foldedTriangles(const std::vector<std::uint32_t>& corners)
{
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        std::sort(triangles.back().begin(), triangles.back().end());
    }
    std::sort(triangles.begin(), triangles.end());
    std::size_t folded = 0;
    for (std::size_t i = 1; i < triangles.size(); ++i) folded += triangles[i] == triangles[i - 1];
    return folded;
}

}  // namespace

MeshCheck checkMesh(const SceneMesh& mesh)
{
    MeshCheck found;
    const std::vector<std::uint32_t> same = joinedByPosition(mesh.vertices, found.joinedVertices);
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t i : mesh.indices) corners.push_back(same[i]);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t a = corners[i], b = corners[i + 1], c = corners[i + 2];
        found.emptyTriangles += a == b || b == c || c == a;
        const glm::dvec3 pa(mesh.vertices[a].position), pb(mesh.vertices[b].position), pc(mesh.vertices[c].position);
        found.volume += glm::dot(pa, glm::cross(pb, pc)) / 6;
        found.area += 0.5 * glm::length(glm::cross(pb - pa, pc - pa));
    }
    found.openEdges = openEdges(corners);
    found.brokenVertices = brokenVertices(corners, mesh.vertices.size());
    found.foldedTriangles = foldedTriangles(corners);
    return found;
}

}  // namespace vitrine::scenes
