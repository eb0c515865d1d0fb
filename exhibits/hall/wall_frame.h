#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <memory>

namespace vitrine::hall {

/// Picture frame on a wall. In its own space the middle of the opening is the origin, the wall is the plane z = 0, z
/// runs into the room and y up. Meters.
struct WallFrame {
    glm::dvec2 opening{2.4, 1.6};  ///< Width and height inside the border.
    double border = 0.14;          ///< Width of the border.
    double depth = 0.07;           ///< How far the border stands out from the wall.
};

/// Returns the border: one molded profile along all four sides, mitered at the corners, with flat normals.
[[nodiscard]] std::shared_ptr<const render::Mesh> frameMesh(const WallFrame&);
/// Returns the panel that fills the opening while no work hangs in it.
[[nodiscard]] std::shared_ptr<const render::Mesh> panelMesh(const WallFrame&);
/// Returns where the plaque hangs, frame from plaque: to the right of the border, at reading height below its middle.
[[nodiscard]] glm::dmat4 plaqueBeside(const WallFrame&);

}  // namespace vitrine::hall
