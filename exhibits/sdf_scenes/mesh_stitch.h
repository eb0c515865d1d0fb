#pragma once

#include "exhibits/sdf_scenes/mesh_leaf.h"

#include <vector>

namespace vitrine::scenes {

/// Joins what was found in leaves: around every crossed grid edge, the vertices of its four cells.
[[nodiscard]] SceneMesh stitched(const std::vector<MeshLeaf>&, std::vector<LeafSurface>, const MeshField&);

}  // namespace vitrine::scenes
