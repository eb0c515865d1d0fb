#pragma once

#include "render/glsl/std140.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

namespace vitrine {

#include "shaders/lib/standing_block.glsl"

/// Reach that a contact shadow of this shape is given: three times its height, at least 0.15 m and at most 1.5 m.
[[nodiscard]] double contactReach(const StandingShape&);

/// A box with sides along the axes; `color`: the mean share of light that it sends back, linear Rec. 709. Its contact
/// shadow counts in full, to its `contactReach`.
[[nodiscard]] StandingShape standingBox(const render::Box&, const glm::dvec3& color);

/// The upright cylinder in the box: as high, and as wide as its narrower side.
[[nodiscard]] StandingShape standingCylinder(const render::Box&, const glm::dvec3& color);

/// The same shape after a transform that moves, turns about the upright axis and scales evenly; of others, what they do
/// to the box's first side and to the center counts.
[[nodiscard]] StandingShape moved(const StandingShape&, const glm::dmat4& worldFromShape);

/// Holds the shape; world space where it is.
[[nodiscard]] render::Box boundsOf(const StandingShape&);

}  // namespace vitrine
