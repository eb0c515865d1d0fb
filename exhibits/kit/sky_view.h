#pragma once

#include "render/image/texture.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace vitrine {

/// Light above the air of a sky.
struct SkySource {
    double sunElevation = 0;  ///< Radians above the horizon; negative at night.
    double haze = 1;          ///< A multiple of the haze of clear air.
    glm::dvec3 sun{1};        ///< Factor of sunlight and sky; 1: the sun has irradiance 1 above the air.
    glm::dvec3 night{0};      ///< Radiance that the sky has without the sun.

    bool operator==(const SkySource&) const = default;
};

/// The clear sky of all works with a sky: a table of its radiance for shaders/lib/sky_view.glsl, and sums of it.
struct SkyView {
    std::shared_ptr<const render::Texture> radiance;  ///< For UNIT_ENVIRONMENT.
    glm::dvec3 sun{0};          ///< Irradiance of the sun on a plane that faces it, at the ground,
    glm::dvec3 sunOnClouds{0};  ///< ... and at 8 km, at the height of cirrus.
    glm::dvec3 above{0};        ///< Irradiance over pi of the sky on level ground.
    glm::dvec3 around{0};       ///< Mean radiance near the horizon.
    double brightest = 0;       ///< Largest value of the table.
};

/// Returns the sky under this light. Thread-safe. The last few are kept; a new one takes some milliseconds.
[[nodiscard]] std::shared_ptr<const SkyView> skyView(const SkySource&);

/// Name of the texture `SkyView::radiance`.
inline constexpr const char* skyTableName = "sky";
/// Returns shaders/lib/sky_view.glsl with a constant array in place of the texture, for shaders without textures. Each
/// channel is off by at most a thousandth of the brightest one.
[[nodiscard]] std::string skyArrayGlsl(const render::Texture& table);

}  // namespace vitrine
