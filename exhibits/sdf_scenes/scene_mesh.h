#pragma once

#include "exhibits/sdf_scenes/scene_field.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

struct MeshVertex {
    glm::vec3 position{0};  ///< Meters.
    glm::vec3 normal{0};
    glm::vec3 color{0};  ///< Linear color of the material.
};

/// Triangle mesh, counter-clockwise as seen from outside.
struct SceneMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Region and resolution of a mesh.
struct MeshRequest {
    double cell = 0.01;  ///< Edge of a cell, meters.
    /// The scene is cut and closed at this box; without it, the whole of a finite scene.
    std::optional<render::Box> part;
    std::uint64_t mostBytes = 1U << 30U;  ///< Memory limit.
};

/// Returns the occupied box of the scene or of its part. Throws Failure (ErrorKind::usage) for an infinite scene
/// without a part, for a part without anything, and for cells too small for float32.
[[nodiscard]] render::Box meshedBox(const SceneField&, const MeshRequest&);

/// Size of a mesh, estimated before it is made.
struct MeshPlan {
    glm::ivec3 cells{0};
    /// Cells that a surface may pass through; the field proves that it passes no other.
    std::uint64_t nearSurface = 0;
    /// Cells whose center is on the other side than all their corners: thin parts that get lost.
    std::uint64_t lost = 0;
    std::uint64_t bytes = 0;  ///< Upper bound on memory.

    [[nodiscard]] double allCells() const { return double(cells.x) * double(cells.y) * double(cells.z); }
};

/// Called from time to time with the finished share, 0 to 1; false cancels the work.
using MeshProgress = std::function<bool(double part)>;

/// Makes a closed mesh of a scene's surface by dual contouring (Ju et al. 2002, "Dual Contouring of Hermite Data").
/// Each loop of the surface in a cell has its own vertex (Nielson 2004, "Dual Marching Cubes"). So for any field, every
/// edge has two triangles and every vertex a single fan. Vertices are placed where the tangent planes at the crossed
/// edges meet best, clamped to their cell, so that sharp edges stay sharp. Two cells that would share two edges get an
/// extra vertex on each of these. Blocks of cells are skipped where the distance proves that no surface is near.
class SceneMesher {
public:
    /// Finds the cells near the surface. Throws Failure (ErrorKind::usage) for an infinite scene without a part, for
    /// cells too small for float32, and if more than `mostBytes` would be needed; the sentence suggests a cell size
    /// that works. If `progress` cancels, the plan is empty.
    SceneMesher(const SceneField&, const MeshRequest&, const MeshProgress& = {});
    ~SceneMesher();
    SceneMesher(const SceneMesher&) = delete;
    SceneMesher& operator=(const SceneMesher&) = delete;

    [[nodiscard]] const MeshPlan& plan() const { return plan_; }
    /// Returns nothing if canceled.
    [[nodiscard]] std::optional<SceneMesh> mesh(const MeshProgress& = {});
    /// Number of shapes evaluated so far, and of evaluations of the scene.
    [[nodiscard]] std::uint64_t primitiveEvaluations() const;
    [[nodiscard]] std::uint64_t evaluations() const;

private:
    struct Work;
    MeshPlan plan_;
    std::unique_ptr<Work> work_;
};

/// Topology check of a mesh, from positions alone, as a reader sees it that merges vertices of equal position.
struct MeshCheck {
    std::size_t openEdges = 0;        ///< Edges without exactly one triangle on each side.
    std::size_t brokenVertices = 0;   ///< Vertices with more than one fan of triangles.
    std::size_t emptyTriangles = 0;   ///< Triangles with two corners of equal position.
    std::size_t foldedTriangles = 0;  ///< Triangles with the same corners as another one: nothing is between them.
    std::size_t joinedVertices = 0;   ///< Positions shared by several vertices.
    double volume = 0, area = 0;      ///< Cubic and square meters.

    /// Returns true for a closed 2-manifold.
    [[nodiscard]] bool good() const
    {
        return openEdges + brokenVertices + emptyTriangles + foldedTriangles + joinedVertices == 0;
    }
};
[[nodiscard]] MeshCheck checkMesh(const SceneMesh&);

/// Limits of a simplification; 0: none.
struct Simplification {
    int triangles = 0;     ///< Number of triangles to reach.
    double deviation = 0;  ///< Largest distance between the two surfaces, meters, as far as it is estimated.
};
/// Simplified mesh, and the estimate of its largest deviation in meters.
struct SimplifiedMesh {
    SceneMesh mesh;
    double deviation = 0;
};
/// Collapses edges in the order of their quadric errors until a limit is reached (meshoptimizer; Garland and Heckbert
/// 1997, "Surface Simplification Using Quadric Error Metrics"). Vertices keep their places, normals and colors; some
/// are left out. Check the result with `checkMesh`.
[[nodiscard]] SimplifiedMesh simplified(const SceneMesh&, const Simplification&);

enum class MeshFormat : std::uint8_t { glb, stl, ply, obj, threeMf };
/// Extensions of all formats, in the order of the enumerators.
inline constexpr std::array<std::string_view, 5> meshEndings{"glb", "stl", "ply", "obj", "3mf"};
/// Returns the format for the extension of a file's name.
[[nodiscard]] std::optional<MeshFormat> meshFormat(const std::string& file);
/// Returns the bytes of a file: glTF 2.0 (meters, y up, a material for each color, linear vertex colors for triangles
/// of several colors), binary STL (millimeters, without colors), binary PLY (meters, sRGB vertex colors), OBJ and 3MF
/// (mesh_text.h).
[[nodiscard]] std::string meshFile(const SceneMesh&, MeshFormat, const std::string& name);

}  // namespace vitrine::scenes
