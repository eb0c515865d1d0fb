#pragma once

#include "exhibits/hall/hall_model.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine {

/// A visitor is an upright cylinder of this radius, meters.
inline constexpr double visitorRadius = 0.28;

/// Where a visitor going from eye position `from` to `to` ends up: pushed out of every obstacle, in steps
/// short enough that none is jumped over. The height of `to` is kept. A NaN in `to` leaves him at `from`.
[[nodiscard]] glm::dvec3 walkAround(const std::vector<Collider>&, const glm::dvec3& from, const glm::dvec3& to);

/// Where a thing that fills `radius` around it (meters) can stand on the floor: `at` (x, z), moved out of every
/// obstacle in its way; `at` itself where it cannot get out of them.
[[nodiscard]] glm::dvec2 standingPlace(const std::vector<Collider>&, const glm::dvec2& at, double radius);

/// A camera, which goes where a visitor cannot stand, keeps so far from what it must not run into, meters.
inline constexpr double cameraRadius = 0.08;

/// Whether a camera gets straight from `from` to `to` past every obstacle: over, under or beside it. NaN: no.
[[nodiscard]] bool cameraPasses(const std::vector<Collider>&, const glm::dvec3& from, const glm::dvec3& to);

/// Whether one occluder alone hides the whole box from `eye`: exact for a convex occluder and a box, so what
/// is called hidden is hidden.
[[nodiscard]] bool isBehind(const Occluder&, const render::Box&, const glm::dvec3& eye);

}  // namespace vitrine
