#pragma once

#include "render/glsl/std140.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::render {

/// A small light: a point or a sphere of uniform radiance, optionally limited to a cone.
struct LocalLight {
    glm::dvec3 position{0};    ///< World space, meters.
    double radius = 0;         ///< Meters; 0: a point.
    glm::dvec3 intensity{1};   ///< Radiant intensity, W/sr.
    double range = 0;          ///< Meters: farther away it has no effect; 0: unlimited.
    bool castsShadow = false;  ///< It has a shadow map if it is among the strongest lights.
    glm::dvec3 axis{0};        ///< Unit, the axis of its cone; 0: it shines in all directions.
    double coneInner = 0;      ///< Half angle of full intensity, radians.
    double coneOuter = 0;      ///< Half angle of no intensity: above `coneInner`, at most pi.
    /// Meters: closer surfaces get the irradiance of this distance, which gives its light an upper bound; 0: no limit.
    double nearest = 0;

    bool operator==(const LocalLight&) const = default;
};

#include "shaders/lib/local_lights_block.glsl"

inline constexpr std::size_t mostLocalLights = MOST_LOCAL_LIGHTS;
inline constexpr std::size_t mostLocalShadows = 4;  ///< Each uses six layers of the shadow maps.
inline constexpr double localShadowNear = 0.01;     ///< Meters: anything nearer to a light casts no shadow.

/// Lights selected for a frame.
struct LocalLighting {
    LocalLightsBlock block;
    std::vector<std::size_t> chosen;  ///< Indices of the given lights that are in the block, strongest first.
    /// Indices of the given lights that have shadow maps: layers 6 i to 6 i + 5 belong to `shadowed[i]`.
    std::vector<std::size_t> shadowed;
};

/// Selects lights by one rule for all exhibits. A light's strength is the luminance of its irradiance at `center`, the
/// point that the camera looks at. The strongest `mostLocalLights` are used; the strongest `mostLocalShadows` of those
/// with `castsShadow` get shadow maps. Lights without intensity are left out, and lights whose range ends before the
/// sphere of `radius` meters around `center`.
[[nodiscard]] LocalLighting localLighting(std::span<const LocalLight>, const glm::dvec3& center, double radius);

/// Divides a box into cells and marks in each the lights that may reach a place in it (Olsson et al. 2012, "Clustered
/// Deferred and Forward Shading"). Without it there is one cell with all lights. Places outside the box belong to the
/// nearest cell, so `space` must contain all places that are shaded.
void divideIntoCells(LocalLightsBlock&, const Box& space);

/// Returns the block with one cell, in which all lights are.
[[nodiscard]] LocalLightsBlock inOneCell(LocalLightsBlock);

/// Places that a pass shades.
struct ShadedSpace {
    std::optional<Box> within = {};  ///< World space, meters; unset: anywhere.
    bool inView = false;             ///< Only places that the view of the pass may show.
};

/// Returns the lights that may reach a place in `space`, in their order. It is conservative: a light that is left out
/// adds exactly nothing there. `view` is that of the pass.
[[nodiscard]] LocalLightsBlock reachingLights(const LocalLightsBlock&, const ShadedSpace& space, const View& view);

}  // namespace vitrine::render
