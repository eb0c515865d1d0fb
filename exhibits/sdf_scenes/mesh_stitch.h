#pragma once

#include "exhibits/sdf_scenes/mesh_leaf.h"

#include <vector>

namespace vitrine::scenes {

/// Joins the surfaces of leaves to a mesh: around every crossed grid edge, it connects the vertices of the four cells.
[[nodiscard]] SceneMesh stitched(const std::vector<MeshLeaf>&, std::vector<LeafSurface>, const MeshField&);

}  // namespace vitrine::scenes
