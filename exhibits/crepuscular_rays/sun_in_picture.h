#pragma once

#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <limits>
#include <span>
#include <vector>

namespace vitrine {

/// Where a light at infinity stands in a picture.
struct SunInPicture {
    bool inFront = false;
    glm::dvec2 pixel{
        0};  ///< Of the whole picture, from its lower left corner; may lie beyond its edges. Only when `inFront`.
    /// max(|x|, |y|) - 1 in normalized device coordinates: negative inside; infinite on the camera's plane and behind
    /// it.
    double beyond = std::numeric_limits<double>::infinity();
};

/// `towardsSun` is unit length, world space. Projected as the homogeneous point (direction, 0), so that it is
/// right for every view; continuous wherever the sun is in front.
[[nodiscard]] SunInPicture sunInPicture(const render::View&, const glm::dvec3& towardsSun);

/// The log-polar grid around `source` that holds the rectangle from 0 to `size`: angles and radii in pixels.
struct PolarGrid {
    double firstAngle = 0, span = 0;  ///< Radians; the whole circle when the source is inside.
    double firstRadius = 0.5, lastRadius = 1;
    int radii = 1, angles = 1;
    bool around = true;  ///< The source is inside.
};
[[nodiscard]] PolarGrid polarGrid(glm::dvec2 source, glm::dvec2 size, int samples);

/// The beam that the sun makes of an opening, as far as it stays inside the room: for
/// shaders/crepuscular_rays/air.glsl.
struct Beam {
    render::Box opening;  ///< Flat along `axis`.
    int axis = 2;
    double plane = 0;  ///< Where on that axis the light enters the room.
    render::Box box;   ///< That holds what is lit.
};

/// The beams of all openings that the sun shines through into the room; empty for a sun on the other side.
/// A sliver of less than 30 cm, by which the sun misses the rim of a deep opening, is left out.
[[nodiscard]] std::vector<Beam> beams(std::span<const render::Box> openings, const render::Box& room,
                                      const glm::dvec3& towardsSun);

}  // namespace vitrine
