#include "exhibits/sdf_scenes/mesh_stitch.h"

#include <map>
#include <unordered_map>

namespace vitrine::scenes {
namespace {

std::uint64_t packed(const glm::ivec3& v)
{
    const auto part = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) & 0x1FFFFFU; };
    return part(v.x) << 42U | part(v.y) << 21U | part(v.z);
}

int bitOf(unsigned axis, unsigned bits)
{
    return static_cast<int>(bits >> axis & 1U);
}

/// A cell at a crossed edge.
struct CellAtEdge {
    glm::ivec3 place{0};
    unsigned inside = 0;
    unsigned edge = 0;  ///< Number of the crossed edge within the cell.
    std::uint32_t vertex = 0;
};

class Stitcher {
public:
    Stitcher(const std::vector<MeshLeaf>& leaves, std::vector<LeafSurface>& surfaces, const MeshField& field)
        : leaves_(leaves), surfaces_(surfaces), field_(field)
    {
        std::size_t vertices = 0, edges = 0;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            leafAt_[packed(leaves[i].low / leafCells)] = i;
            firstOfLeaf_.push_back(static_cast<std::uint32_t>(vertices));
            vertices += surfaces[i].vertices.size();
            edges += surfaces[i].edges.size();
        }
        mesh_.vertices.reserve(vertices);
        mesh_.indices.reserve(6 * edges);
        for (LeafSurface& surface : surfaces) {
            mesh_.vertices.insert(mesh_.vertices.end(), surface.vertices.begin(), surface.vertices.end());
            std::vector<MeshVertex>().swap(surface.vertices);
        }
    }

    SceneMesh joined()
    {
        for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
            for (const CrossedEdge& edge : surfaces_[leaf].edges)
                addPolygon(leaves_[leaf].low + placeInLeaf(edge.cell), edge);
        return std::move(mesh_);
    }

private:
    /// Returns the cell at `place`, one of whose edges along `axis` is crossed; `corner` has the bits of that edge's
    /// position.
    [[nodiscard]] CellAtEdge cellAt(const glm::ivec3& place, unsigned axis, unsigned corner) const
    {
        const std::size_t leaf = leafAt_.at(packed(place / leafCells));
        const glm::ivec3 in = place - leaves_[leaf].low;
        const std::size_t cell = cellOfLeaf(in.x, in.y, in.z);
        CellAtEdge found{place, surfaces_[leaf].inside[cell], edgeAt(axis, corner)};
        const int loop = cellLoops(found.inside).loopOf[found.edge];
        found.vertex = firstOfLeaf_[leaf] + surfaces_[leaf].firstVertex[cell] + static_cast<std::uint32_t>(loop);
        return found;
    }

    /// Returns an extra vertex for an ambiguous face, shared by two neighbors along `across` that both connect the two
    /// lines on it. It lies in the middle of the line that ends at this edge, so that the two lines do not become the
    /// same mesh edge. Else returns none.
    std::uint32_t middleOf(const CellAtEdge& a, const CellAtEdge& b, unsigned across, unsigned insideEnd)
    {
        const bool aIsLow = a.place[static_cast<int>(across)] < b.place[static_cast<int>(across)];
        const CellAtEdge& lower = aIsLow ? a : b;
        const CellAtEdge& upper = aIsLow ? b : a;
        const unsigned u = (across + 1) % 3, v = (across + 2) % 3, face = 1U << across;
        const auto isIn = [&](unsigned bits) { return (upper.inside >> bits & 1U) != 0; };
        const bool crossed = isIn(0) != isIn(1U << u) && isIn(0) != isIn(1U << v) && isIn(0) == isIn(1U << u | 1U << v);
        if (!crossed) return noIndex;
        // The other line is around the corner opposite to the inside end of this edge.
        const unsigned here = insideEnd & ~face, there = here ^ (1U << u | 1U << v);
        const auto isOneLoop = [&](const CellAtEdge& cell, unsigned side) {
            const CellLoops& loops = cellLoops(cell.inside);
            return loops.loopOf[edgeAt(u, here | side)] == loops.loopOf[edgeAt(u, there | side)];
        };
        if (!isOneLoop(lower, face) || !isOneLoop(upper, 0)) return noIndex;
        const glm::ivec3 corner = upper.place + glm::ivec3(bitOf(0, here), bitOf(1, here), bitOf(2, here));
        const auto [found, isNew] = middles_.try_emplace({packed(corner), packed(upper.place), across},
                                                         static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (isNew) {
            MeshVertex middle = mesh_.vertices[lower.vertex];
            const MeshVertex& other = mesh_.vertices[upper.vertex];
            glm::dvec3 at =
                glm::dvec3(upper.place) + 0.25 * glm::dvec3(bitOf(0, here), bitOf(1, here), bitOf(2, here)) + 0.375;
            at[static_cast<int>(across)] = upper.place[static_cast<int>(across)];
            middle.position = glm::vec3(field_.at(at));
            middle.normal = glm::normalize(middle.normal + other.normal + glm::vec3(1e-9F, 0, 0));
            middle.color = 0.5F * (middle.color + other.color);
            mesh_.vertices.push_back(middle);
        }
        return found->second;
    }

    void addPolygon(const glm::ivec3& place, const CrossedEdge& edge)
    {
        const unsigned axis = edge.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
        // Counter-clockwise around the axis: position of the edge in each cell, and the axis towards the next cell.
        const std::array<unsigned, 4> corners{1U << u | 1U << v, 1U << v, 0, 1U << u};
        const std::array<unsigned, 4> across{u, v, u, v};
        std::array<CellAtEdge, 4> cells;
        for (std::size_t i = 0; i < 4; ++i)
            cells[i] = cellAt(place - glm::ivec3(bitOf(0, corners[i]), bitOf(1, corners[i]), bitOf(2, corners[i])),
                              axis, corners[i]);
        std::vector<std::uint32_t>& polygon = polygon_;
        polygon.clear();
        for (std::size_t i = 0; i < 4; ++i) {
            polygon.push_back(cells[i].vertex);
            const unsigned upperCorner = corners[i] & corners[(i + 1) % 4];
            const unsigned insideEnd = upperCorner | (edge.startsInside ? 0U : 1U << axis);
            const std::uint32_t middle = middleOf(cells[i], cells[(i + 1) % 4], across[i], insideEnd);
            if (middle != noIndex) polygon.push_back(middle);
        }
        if (polygon.size() == 4)
            addQuad(edge);
        else
            addFan(edge);
    }

    void addTriangle(bool forward, std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        if (!forward) std::swap(b, c);
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    /// Returns whether a triangle faces away from the normals of its corners.
    [[nodiscard]] bool isTurned(bool forward, std::size_t a, std::size_t b, std::size_t c) const
    {
        const MeshVertex& va = mesh_.vertices[polygon_[a]];
        const MeshVertex& vb = mesh_.vertices[polygon_[b]];
        const MeshVertex& vc = mesh_.vertices[polygon_[c]];
        const glm::vec3 across = glm::cross(vb.position - va.position, vc.position - va.position);
        return (forward ? 1.0F : -1.0F) * glm::dot(across, va.normal + vb.normal + vc.normal) < 0;
    }

    /// Splits the quad along the diagonal that flips fewer triangles. If both are equal, takes the one closer to the
    /// surface, so that a sharp edge of the scene becomes an edge of the mesh.
    void addQuad(const CrossedEdge& edge)
    {
        const auto& q = polygon_;
        const bool forward = edge.startsInside;
        const auto off = [&](std::size_t a, std::size_t b) {
            const glm::vec3 middle = 0.5F * (mesh_.vertices[q[a]].position + mesh_.vertices[q[b]].position);
            return std::abs(glm::dot(edge.normal, middle - edge.position));
        };
        const int turnedFirst = isTurned(forward, 0, 1, 2) + isTurned(forward, 0, 2, 3);
        const int turnedSecond = isTurned(forward, 0, 1, 3) + isTurned(forward, 1, 2, 3);
        const bool first = turnedFirst != turnedSecond ? turnedFirst < turnedSecond : off(0, 2) <= off(1, 3);
        addTriangle(forward, q[0], q[1], q[first ? 2 : 3]);
        addTriangle(forward, q[first ? 0 : 1], q[2], q[3]);
    }

    /// Triangulates around the point where the surface crosses the edge.
    void addFan(const CrossedEdge& edge)
    {
        const auto center = static_cast<std::uint32_t>(mesh_.vertices.size());
        mesh_.vertices.push_back({edge.position, edge.normal, mesh_.vertices[polygon_.front()].color});
        for (std::size_t i = 0; i < polygon_.size(); ++i)
            addTriangle(edge.startsInside, center, polygon_[i], polygon_[(i + 1) % polygon_.size()]);
    }

    const std::vector<MeshLeaf>& leaves_;
    std::vector<LeafSurface>& surfaces_;
    const MeshField& field_;
    std::unordered_map<std::uint64_t, std::size_t> leafAt_;
    std::vector<std::uint32_t> firstOfLeaf_;
    std::map<std::tuple<std::uint64_t, std::uint64_t, unsigned>, std::uint32_t> middles_;
    std::vector<std::uint32_t> polygon_;
    SceneMesh mesh_;
};

}  // namespace

SceneMesh stitched(const std::vector<MeshLeaf>& leaves, std::vector<LeafSurface> surfaces, const MeshField& field)
{
    return Stitcher(leaves, surfaces, field).joined();
}

}  // namespace vitrine::scenes
