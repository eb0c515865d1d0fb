#pragma once

#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <limits>
#include <span>
#include <vector>

namespace vitrine::crepuscular_rays {

/// Position of a light at infinity in a picture.
struct SunInPicture {
    bool inFront = false;
    /// Pixels of the whole picture, from its lower left corner; may lie beyond the edges. Valid if `inFront`.
    glm::dvec2 pixel{0};
    /// max(|x|, |y|) - 1 in normalized device coordinates: negative inside the picture, infinite on the camera plane
    /// and behind it.
    double beyond = std::numeric_limits<double>::infinity();
};

/// Returns where the sun is. `towardsSun` is a unit vector in world space. It is projected as the homogeneous point
/// (direction, 0), which is right for every view and continuous wherever the sun is in front.
[[nodiscard]] SunInPicture sunInPicture(const render::View&, const glm::dvec3& towardsSun);

/// Log-polar grid around `source` that covers the rectangle from 0 to `size`. Radii are in pixels, angles in radians.
struct PolarGrid {
    double firstAngle = 0, span = 0;  ///< Radians; the full circle if the source is inside.
    double firstRadius = 0.5, lastRadius = 1;
    int radii = 1, angles = 1;
    bool around = true;  ///< Whether the source is inside the picture.
};
[[nodiscard]] PolarGrid polarGrid(glm::dvec2 source, glm::dvec2 size, int samples);

/// Beam of sunlight through an opening, limited to the inside of the room; read by
/// shaders/crepuscular_rays/participating_media.glsl.
struct Beam {
    render::Box opening;  ///< Flat along `axis`.
    int axis = 2;
    double plane = 0;  ///< Coordinate along `axis` of the plane on which the light enters the room.
    render::Box box;   ///< Bounding box of the lit air.
};

/// Returns the beams of all openings through which the sun shines into the room; empty for a sun on the other side. A
/// beam less than 30 cm wide, which is left of a deep opening in oblique light, is omitted.
[[nodiscard]] std::vector<Beam> beams(std::span<const render::Box> openings, const render::Box& room,
                                      const glm::dvec3& towardsSun);

}  // namespace vitrine::crepuscular_rays
