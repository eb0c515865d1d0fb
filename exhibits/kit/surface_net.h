#pragma once

#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <string>

namespace vitrine {

/// Returns a triangle mesh of a distance field (meters, negative inside): surface nets (Gibson 1998, "Constrained
/// Elastic Surface Nets"). The grid has `cells` along the longest side of the bounding box. Vertices are projected onto
/// the surface, normals are the field's. The mesh is closed as far as the grid resolves the field.
[[nodiscard]] std::shared_ptr<const render::Mesh> surfaceNet(const std::function<double(const glm::dvec3&)>& distance,
                                                             const render::Box&, int cells, std::string name);

}  // namespace vitrine
