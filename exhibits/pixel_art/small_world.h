#pragma once

#include "exhibits/pixel_art/pixel_art_table.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace vitrine::pixel_art {

/// Mesh of the small world at one time.
struct WorldPart {
    std::shared_ptr<const render::Mesh> mesh;
    glm::dmat4 worldFromModel{1};
    int firstId = 0;                                        ///< Added to the object numbers of its vertices.
    std::shared_ptr<const render::Material> material = {};  ///< The user's model's; null: vertices are painted.
};

/// Seconds after which all motion in the small world repeats.
inline constexpr double worldRound = 4;

/// Returns the isle: a court of checkered tiles with three pylons, a tumbling torus and cubes, two of which bob, among
/// grass, trees, rocks and water.
[[nodiscard]] std::vector<WorldPart> isleParts(double time);
/// Returns the reference's scene: floor, pylons, torus, cubes.
[[nodiscard]] std::vector<WorldPart> testParts(double time);
/// Returns bars of one and two texels at 240 x 135 in front of a wall: upright, horizontal and slanted.
[[nodiscard]] std::vector<WorldPart> barParts();
/// Returns the user's model, rotated about the vertical by the time. The box `framed` in model space is scaled to fill
/// the picture comfortably, with its center in the center of the world.
[[nodiscard]] std::vector<WorldPart> modelParts(const render::Model&, const render::Box& framed, double time);
[[nodiscard]] inline std::vector<WorldPart> modelParts(const render::Model& model, double time)
{
    return modelParts(model, model.bounds, time);
}

/// Returns the bounds of all parts.
[[nodiscard]] render::Box boundsOf(const std::vector<WorldPart>&);

}  // namespace vitrine::pixel_art
