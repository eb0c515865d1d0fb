#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace vitrine {

/// A mesh of the small world at a moment.
struct WorldPart {
    std::shared_ptr<const render::Mesh> mesh;
    glm::dmat4 worldFromModel{1};
    int firstId = 0;                                        ///< Added to the object numbers of its vertices.
    std::shared_ptr<const render::Material> material = {};  ///< Of a visitor's model; null: its vertices are painted.
};

/// Seconds after which everything that moves in the small world is where it was.
inline constexpr double worldRound = 4;

/// The isle: a court of checkered tiles with three pylons, a tumbling torus and cubes, of which two bob, among grass,
/// trees, rocks and water.
[[nodiscard]] std::vector<WorldPart> isleParts(double time);
/// The source's scene: floor, pylons, torus, cubes.
[[nodiscard]] std::vector<WorldPart> testParts(double time);
/// Bars of one and two texels at 240 x 135, upright, lying and slanted, before a wall.
[[nodiscard]] std::vector<WorldPart> barParts();
/// A model of a visitor's, turned about the vertical by the time: what is framed (of the model's own space) as large as
/// the picture comfortably holds, its middle in that of the world.
[[nodiscard]] std::vector<WorldPart> modelParts(const render::Model&, const render::Box& framed, double time);
[[nodiscard]] inline std::vector<WorldPart> modelParts(const render::Model& model, double time)
{
    return modelParts(model, model.bounds, time);
}

/// Of all parts.
[[nodiscard]] render::Box boundsOf(const std::vector<WorldPart>&);

}  // namespace vitrine
