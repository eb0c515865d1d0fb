#pragma once

#include "render/glsl/std140.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::render {

/// A lamp or a candle: a point, or a sphere of even radiance.
struct LocalLight {
    glm::dvec3 position{0};    ///< World space, meters.
    double radius = 0;         ///< Meters; 0: a point.
    glm::dvec3 intensity{1};   ///< Radiant intensity, W/sr.
    double range = 0;          ///< Meters: beyond, it is not seen; 0: no end.
    bool castsShadow = false;  ///< If it is among the strongest.

    bool operator==(const LocalLight&) const = default;
};

#include "shaders/lib/local_lights_block.glsl"

inline constexpr std::size_t mostLocalLights = MOST_LOCAL_LIGHTS;
inline constexpr std::size_t mostLocalShadows = 4;  ///< Each takes six layers of the shadow maps.
inline constexpr double localShadowNear = 0.01;     ///< Meters: what is nearer to a light throws no shadow.

/// The lights that a frame reckons with.
struct LocalLighting {
    LocalLightsBlock block;
    std::vector<std::size_t> chosen;  ///< Which of the given lights stand in the block, strongest first.
    std::vector<std::size_t>
        shadowed;  ///< Which of them have shadow maps: layers 6 i to 6 i + 5 belong to `shadowed[i]`.
};

/// The one policy of all exhibits: strength is what a light sends to a surface that faces it at `center` (where one
/// looks), the strongest `mostLocalLights` count, and the strongest `mostLocalShadows` of those that cast shadows have
/// maps. Lights without intensity, and those whose range ends before the sphere of `radius` meters about `center`, are
/// left out.
[[nodiscard]] LocalLighting localLighting(std::span<const LocalLight>, const glm::dvec3& center, double radius);

}  // namespace vitrine::render
