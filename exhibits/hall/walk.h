#pragma once

#include "exhibits/hall/hall_model.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::hall {

/// Radius in meters of the upright cylinder that a walking user fills.
inline constexpr double visitorRadius = 0.28;

/// Returns where a walk from eye position `from` to `to` ends. It is pushed out of every obstacle, in steps too short
/// to jump over one. The height of `to` is kept. A NaN or an infinite value in `to` leaves the eye at `from`.
[[nodiscard]] glm::dvec3 walkAround(const std::vector<Collider>&, const glm::dvec3& from, const glm::dvec3& to);

/// Returns a free position on the floor for an object that fills `radius` meters around it: `at` (x, z), moved out of
/// obstacles. Returns `at` unchanged if there is no way out.
[[nodiscard]] glm::dvec2 standingPlace(const std::vector<Collider>&, const glm::dvec2& at, double radius);

/// Distance in meters that a flying camera keeps from obstacles.
inline constexpr double cameraRadius = 0.08;

/// Returns whether a camera can move straight from `from` to `to` past every obstacle. With NaN it cannot.
[[nodiscard]] bool cameraPasses(const std::vector<Collider>&, const glm::dvec3& from, const glm::dvec3& to);

/// Returns whether one occluder alone hides the whole box from `eye`. The test is exact for a rectangle and a box.
[[nodiscard]] bool isBehind(const Occluder&, const render::Box&, const glm::dvec3& eye);

}  // namespace vitrine::hall
