#pragma once

#include "render/glsl/std140.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::render {

/// A lamp or a candle: a point, or a sphere of even radiance; or such a one that shines in a cone.
struct LocalLight {
    glm::dvec3 position{0};    ///< World space, meters.
    double radius = 0;         ///< Meters; 0: a point.
    glm::dvec3 intensity{1};   ///< Radiant intensity, W/sr.
    double range = 0;          ///< Meters: beyond, it is not seen; 0: no end.
    bool castsShadow = false;  ///< If it is among the strongest.
    glm::dvec3 axis{0};        ///< Unit, the middle of its cone; 0: it shines to all sides.
    double coneInner = 0;      ///< Half the angle within which it has all its intensity, radians ...
    double coneOuter = 0;      ///< ... and that beyond which it has none: more, and at most pi.
    /// Meters: surfaces nearer than this get the irradiance of this distance, so that a bound of its light is known; 0:
    /// no limit.
    double nearest = 0;

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
