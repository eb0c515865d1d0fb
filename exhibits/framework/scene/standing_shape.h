#pragma once

#include "render/glsl/std140.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

namespace vitrine {

#include "shaders/lib/standing_shape_block.glsl"

/// Returns the reach of this shape's contact shadow: three times its height, at least 0.15 m and at most 1.5 m.
[[nodiscard]] double contactReach(const StandingShape&);

/// Makes a box with sides along the axes; `color` is its mean reflectance, linear Rec. 709. Its contact shadow has full
/// strength and reaches to its `contactReach`.
[[nodiscard]] StandingShape standingBox(const render::Box&, const glm::dvec3& color);

/// Makes the upright cylinder in the box: as high, and as wide as its narrower side.
[[nodiscard]] StandingShape standingCylinder(const render::Box&, const glm::dvec3& color);

/// Transforms the shape. Meant for translation, rotation around the vertical axis and uniform scaling. Of other
/// transforms, only the effect on the box's first side and on the center is used.
[[nodiscard]] StandingShape moved(const StandingShape&, const glm::dmat4& worldFromShape);

/// Returns a box around the shape, in its own space.
[[nodiscard]] render::Box boundsOf(const StandingShape&);

}  // namespace vitrine
