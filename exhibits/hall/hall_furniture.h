#pragma once

#include "exhibits/framework/standing.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vitrine {

class HallModel;

/// What hangs together in a mesh: triangles that share a place, to a tenth of a millimeter.
struct MeshPiece {
    render::Box box;        ///< In the mesh's space.
    bool round = false;     ///< Turned about the upright axis of its box.
    double meanRadius = 0;  ///< Of its vertices about that axis.
    double discLow = 0;     ///< Heights between which it is at least 0.7 times as wide as at its widest.
    double discHigh = 0;
};
[[nodiscard]] std::vector<MeshPiece> piecesOf(const render::Mesh&);

/// A piece as a shape: a cylinder where it is round, and only its foot where that is flat and the rest slender.
[[nodiscard]] StandingShape shapeOf(const MeshPiece&, const glm::dvec3& color);

/// Boxes of one color and one height that lie side by side become one: the boards of a seat.
void joinBoards(std::vector<StandingShape>&);

/// Bars before a window, each its middle and half its width, meters: upright ones by x, level ones by y.
struct WindowBars {
    std::vector<glm::dvec2> upright, level;
    double z = 0;  ///< Of the panes; the opening's middle where there are no bars.
};

/// What of the building's walls is no wall.
struct Furniture {
    std::vector<StandingShape> shapes;
    WindowBars bars;
};

/// Plinths, posts, desk, benches and the rim of the pit: the pieces of `HallModel::walls()` that lie where colliders no
/// higher than a visitor stand; a collider without any stands for itself. World space. Large ones are in the baked
/// light, which smears what it has of them: their contact shadows count less, and reach less far. And the bars before
/// the opening in a wall along x, where there is one.
[[nodiscard]] Furniture furnitureOf(const HallModel&);

/// The shapes of a place's own parts, as `partsAt` has them. World space. No light is baked with them.
[[nodiscard]] std::vector<StandingShape> shapesOf(const HallModel&, std::span<const render::MeshInstance> parts);

}  // namespace vitrine
