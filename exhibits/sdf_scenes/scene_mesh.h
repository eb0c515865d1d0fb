#pragma once

#include "exhibits/sdf_scenes/scene_field.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::scenes {

struct MeshVertex {
    glm::vec3 position{0};  ///< Meters.
    glm::vec3 normal{0};
    glm::vec3 color{0};  ///< Linear, of the material.
};

/// Triangles, counter-clockwise seen from outside.
struct SceneMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// What is to be meshed, and how finely.
struct MeshRequest {
    double cell = 0.01;                   ///< Edge of a cell, meters.
    std::optional<render::Box> part;      ///< The scene is cut there and closed; without it, all of a scene that ends.
    std::uint64_t mostBytes = 1U << 30U;  ///< Of memory.
};

/// What a mesh will take, known before it is made.
struct MeshPlan {
    glm::ivec3 cells{0};
    std::uint64_t nearSurface = 0;  ///< Cells that a surface may pass through; the field says that it passes no other.
    std::uint64_t lost = 0;         ///< Cells whose middle is on the other side than all corners: too thin for them.
    std::uint64_t bytes = 0;        ///< Of memory, at most.

    [[nodiscard]] double allCells() const { return double(cells.x) * double(cells.y) * double(cells.z); }
};

/// Asked now and then with the part that is done, 0 to 1; false stops the work.
using MeshProgress = std::function<bool(double part)>;

/// A closed mesh of a scene's surface: dual contouring (Ju et al. 2002, "Dual Contouring of Hermite Data") with a
/// vertex for each loop of the surface in a cell (Nielson 2004, "Dual Marching Cubes"), so that every edge has two
/// triangles and every vertex one fan of them, whatever the field. Vertices are where the tangent planes at the crossed
/// edges meet best, kept inside their cell, so sharp edges stay sharp. Two cells that would share two edges get a
/// vertex between them on each. Cells are skipped wholesale where the distance says that no surface is near.
class SceneMesher {
public:
    /// Finds the cells near the surface. Throws Failure (Blame::usage) for an endless scene without a part, for cells
    /// too small for float32, and where more than `mostBytes` would be needed; the sentence names a cell that is not.
    /// Nothing is planned where the progress stops it.
    SceneMesher(const SceneField&, const MeshRequest&, const MeshProgress& = {});
    ~SceneMesher();
    SceneMesher(const SceneMesher&) = delete;
    SceneMesher& operator=(const SceneMesher&) = delete;

    [[nodiscard]] const MeshPlan& plan() const { return plan_; }
    /// Nothing where the progress stopped it.
    [[nodiscard]] std::optional<SceneMesh> mesh(const MeshProgress& = {});
    /// Shapes that were evaluated so far, and evaluations of the scene.
    [[nodiscard]] std::uint64_t shapesAsked() const;
    [[nodiscard]] std::uint64_t evaluations() const;

private:
    struct Work;
    MeshPlan plan_;
    std::unique_ptr<Work> work_;
};

/// What a mesh is, found from positions alone, as a reader finds it who joins vertices of the same position.
struct MeshCheck {
    std::size_t openEdges = 0;       ///< Edges without exactly one triangle on each side.
    std::size_t brokenVertices = 0;  ///< Vertices with more than one fan of triangles.
    std::size_t emptyTriangles = 0;  ///< With two corners of one position.
    std::size_t joinedVertices = 0;  ///< Positions that several vertices have.
    double volume = 0, area = 0;     ///< Cubic and square meters.

    /// Closed, and a 2-manifold.
    [[nodiscard]] bool good() const { return openEdges + brokenVertices + emptyTriangles + joinedVertices == 0; }
};
[[nodiscard]] MeshCheck checkMesh(const SceneMesh&);

enum class MeshFormat : std::uint8_t { glb, stl, ply };
/// By the end of a file's name.
[[nodiscard]] std::optional<MeshFormat> meshFormat(const std::string& file);
/// The bytes of a file: glTF 2.0 (meters, y up, a material for
/// each color, linear vertex colors between them), binary STL (millimeters, without colors), binary
/// PLY (meters, sRGB vertex colors).
[[nodiscard]] std::string meshFile(const SceneMesh&, MeshFormat, const std::string& name);

}  // namespace vitrine::scenes
