#pragma once

#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <string>

namespace vitrine {

/// A triangle mesh of a distance field (meters, negative inside): surface nets (Gibson 1998, "Constrained Elastic
/// Surface Nets") on a grid of `cells` along the longest side of the box that holds the body, vertices drawn onto the
/// surface, normals from the field. Closed as far as the grid resolves.
[[nodiscard]] std::shared_ptr<const render::Mesh> surfaceNet(const std::function<double(const glm::dvec3&)>& distance,
                                                             const render::Box&, int cells, std::string name);

}  // namespace vitrine
