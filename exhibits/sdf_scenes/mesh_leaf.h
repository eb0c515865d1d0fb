#pragma once

#include "exhibits/sdf_scenes/cell_loops.h"
#include "exhibits/sdf_scenes/pruning.h"
#include "exhibits/sdf_scenes/scene_mesh.h"

#include <array>
#include <bitset>
#include <memory>

namespace vitrine::scenes {

/// Cells along the edge of a leaf: the smallest block that is pruned.
inline constexpr int leafCells = 4;
inline constexpr std::size_t leafVolume = leafCells * leafCells * leafCells;

/// A field sampled on a lattice, and cut by a box.
struct MeshField {
    const SceneField& scene;
    render::Box part;   ///< Infinite if nothing is cut.
    glm::dvec3 low{0};  ///< Low corner of the first cell.
    double cell = 1;

    [[nodiscard]] glm::dvec3 at(const glm::dvec3& cells) const { return low + cell * cells; }
    /// Returns the distance, intersected with the box.
    [[nodiscard]] double cut(const glm::dvec3& p, double distance) const;
};

/// Block of cells near the surface, with the steps that matter in it.
struct MeshLeaf {
    glm::ivec3 low{0};
    std::shared_ptr<const std::vector<Step>> steps;
    std::bitset<leafVolume> near, middleInside;
};

/// A grid edge that the surface crosses. It starts at the low corner of a cell.
struct CrossedEdge {
    std::uint16_t cell = 0;
    std::uint8_t axis = 0;
    bool startsInside = false;
    glm::vec3 position{0}, normal{0};
};

/// Surface found in a leaf.
struct LeafSurface {
    std::array<std::uint32_t, leafVolume> firstVertex{};  ///< Index in `vertices`, for cells with a vertex.
    std::array<std::uint8_t, leafVolume> inside{};        ///< Inside corners, as `cellLoops` takes them.
    std::vector<MeshVertex> vertices;
    std::vector<CrossedEdge> edges;
};

[[nodiscard]] constexpr std::size_t cellOfLeaf(int x, int y, int z)
{
    return static_cast<std::size_t>((z * leafCells + y) * leafCells + x);
}
[[nodiscard]] inline glm::ivec3 placeInLeaf(std::size_t cell)
{
    const int i = static_cast<int>(cell);
    return {i % leafCells, i / leafCells % leafCells, i / (leafCells * leafCells)};
}

/// Planes through points: sum of squared distances to them as a function of a position (quadric error).
class Planes {
public:
    Planes(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& normals);

    /// Returns the point with the least sum; if it is not unique, the one nearest to the mean of the points.
    [[nodiscard]] glm::dvec3 meetingPoint() const;
    /// The same among the points of a box.
    [[nodiscard]] glm::dvec3 bestPointOf(const render::Box&) const;

private:
    glm::dvec3 mean_{0}, right_{0};
    glm::dmat3 square_{0};
};

/// Evaluates leaves one after another. Not thread-safe: use one per thread.
class LeafMesher {
public:
    explicit LeafMesher(const MeshField&);

    /// Finds the cells that a surface may pass through.
    void findNear(MeshLeaf&);
    /// Finds the surface in these cells. Returns the number of cells that are too coarse for their content.
    std::size_t findSurface(const MeshLeaf&, LeafSurface&);

    [[nodiscard]] std::uint64_t primitiveEvaluations() const
    {
        return walk_.primitiveEvaluations() + colors_.primitiveEvaluations();
    }
    [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }

private:
    struct Crossing {
        glm::dvec3 position{0}, normal{0};
    };

    double distance(const glm::dvec3& p);
    void findNear(MeshLeaf&, const glm::ivec3& low, int size);
    double cornerValue(const glm::ivec3& corner);
    const Crossing& crossingAt(const glm::ivec3& corner, unsigned axis);
    Crossing crossingBetween(const glm::dvec3& a, const glm::dvec3& b, double valueA, double valueB);
    glm::dvec3 slopeAt(const glm::dvec3& p, double distanceThere);
    glm::dvec3 vertexOf(const Planes&, const render::Box& cell);
    glm::dvec3 broughtToSurface(glm::dvec3 p, const render::Box& cell);
    void addVertices(const glm::ivec3& place, unsigned inside, LeafSurface&);
    MeshVertex vertexAt(const glm::dvec3& p, const glm::dvec3& normal);

    const MeshField& field_;
    SceneWalk walk_, colors_;
    const std::vector<Step>* steps_ = nullptr;
    glm::ivec3 low_{0};
    std::uint64_t evaluations_ = 0;
    static constexpr int corners_ = leafCells + 1;
    std::array<double, corners_ * corners_ * corners_> values_{};
    std::array<std::int32_t, 3 * corners_ * corners_ * corners_> crossingOf_{};
    std::vector<Crossing> crossings_;
};

}  // namespace vitrine::scenes
