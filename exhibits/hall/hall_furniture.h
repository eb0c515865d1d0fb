#pragma once

#include "exhibits/framework/scene/standing_shape.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vitrine::hall {

class HallModel;

/// Connected component of a mesh. Vertices within a tenth of a millimeter count as one.
struct MeshPiece {
    render::Box box;        ///< Bounds in the space of the mesh.
    bool round = false;     ///< Whether it is a solid of revolution about the vertical axis of its box.
    double meanRadius = 0;  ///< Mean distance of its vertices from that axis.
    double discLow = 0;     ///< Range of heights in which the piece is at least 0.7 times as wide as at its widest.
    double discHigh = 0;
};
[[nodiscard]] std::vector<MeshPiece> piecesOf(const render::Mesh&);

/// Returns a piece as a shape: a cylinder if it is round. If it has a flat foot and is slender above, only the foot
/// counts.
[[nodiscard]] StandingShape shapeOf(const MeshPiece&, const glm::dvec3& color);

/// Merges adjacent boxes of the same color and height, such as the boards of a seat.
void joinBoards(std::vector<StandingShape>&);

/// Bars of a window, each as center and half width in meters: upright ones along x, horizontal ones along y.
struct WindowBars {
    std::vector<glm::dvec2> upright, level;
    double z = 0;  ///< Depth of the bars; without bars, the center of the opening.
};

/// Parts of the building's walls that are furniture.
struct Furniture {
    std::vector<StandingShape> shapes;
    WindowBars bars;
};

/// Returns plinths, posts, desk, benches and the rim of the pit, in world space. These are the pieces of
/// `HallModel::walls()` inside colliders lower than `wallHeight`. A collider without any piece counts as a shape
/// itself.
///
/// Large pieces are also in the baked light, which blurs them, so their contact shadows are weaker and shorter. The
/// result includes the bars of the opening in a wall along x, if there is one.
[[nodiscard]] Furniture furnitureOf(const HallModel&);

/// Returns the shapes of a place's own parts, in world space. No light is baked with them.
[[nodiscard]] std::vector<StandingShape> shapesOf(const HallModel&, std::span<const render::MeshInstance> parts);

}  // namespace vitrine::hall
