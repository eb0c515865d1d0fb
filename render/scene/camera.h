#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace vitrine::render {

/// Largest distance from the origin along each axis, meters: a thousand kilometers.
inline constexpr double farthestPlace = 1e6;

/// Camera position and direction. World space: y up, meters, within `farthestPlace`.
struct Camera {
    glm::dvec3 eye{0, 1.65, 10.5};
    glm::dvec3 target{0, 1.75, 0};
    double fovY = 0.959931;  ///< Vertical field of view, radians (55°). Clamped to [1°, 175°] by `makeView`.
    /// Direction at the center of the picture, off the view axis: tangents, to the right and up. Shifts the picture
    /// within its image plane, as a shift lens does; 0 is straight ahead. A value that is not finite counts as 0.
    glm::dvec2 lensShift{0};

    /// Returns the camera with eye and target transformed.
    [[nodiscard]] Camera transformed(const glm::dmat4& m) const
    {
        Camera moved = *this;
        moved.eye = glm::dvec3(m * glm::dvec4(eye, 1));
        moved.target = glm::dvec3(m * glm::dvec4(target, 1));
        return moved;
    }
    bool operator==(const Camera&) const = default;
};

/// Part of a picture that is drawn (tile), and the sample position inside its pixels.
struct Raster {
    glm::ivec2 size{640, 360};  ///< Size of the whole picture, in pixels.
    glm::ivec2 offset{0};       ///< Lower left corner of the tile in the whole picture.
    glm::ivec2 tile{0};         ///< Size of the tile; (0, 0) means the whole picture.
    glm::dvec2 jitter{0};       ///< Sample position relative to the pixel's center, in pixels, inside ±0.5.

    [[nodiscard]] glm::ivec2 drawn() const { return tile.x > 0 && tile.y > 0 ? tile : size; }
};

/// Matrices and frustum of a camera for one picture. Clip space: reversed depth, near 1, infinitely far 0.
struct View {
    glm::dmat4 viewFromWorld{1};
    glm::dmat4 clipFromView{1};  ///< Projection of the tile, jitter included.
    glm::dmat4 clipFromWorld{1};
    glm::dvec3 eye{0};
    glm::dvec2 tanHalfFov{1};  ///< Half angles of the whole picture, horizontal and vertical, as tangents.
    glm::dvec2 tanShift{0};    ///< Center of the whole picture, off the view axis, as tangents.
    double nearPlane = 0.02;   ///< Meters.
    Raster raster;

    /// Returns the world-space direction through a position in the whole picture (each -1 to 1, y up). Its component
    /// along the view axis has length 1.
    [[nodiscard]] glm::dvec3 direction(glm::dvec2 ndc) const;
    /// Conservative frustum culling: false only if no point of `worldBox` can be inside the frustum.
    [[nodiscard]] bool mayContain(const Box& worldBox) const;
};

/// Makes the view of a camera. Invalid input is corrected: a target equal to the eye, a vertical view direction, a
/// field of view out of range, and positions out of range or NaN.
[[nodiscard]] View makeView(const Camera&, const Raster&);

/// Returns the same view for other pixels: another tile, jitter or size. The field of view stays, so pixels of another
/// aspect ratio are not square.
[[nodiscard]] View withRaster(const View&, const Raster&);

/// Reversed infinite perspective: near plane at depth 1, infinity at 0. `tanHalfFov` > 0, `nearPlane` > 0; `tanShift`
/// is the off-axis center of the picture, as tangents.
[[nodiscard]] glm::dmat4 reversedPerspective(glm::dvec2 tanHalfFov, double nearPlane,
                                             glm::dvec2 tanShift = glm::dvec2(0));

/// Reversed orthographic projection of a box in light space: z = `nearest` gives depth 1, `farthest` 0
/// (both are view-space z, negative in front).
[[nodiscard]] glm::dmat4 reversedOrthographic(const glm::dvec2& low, const glm::dvec2& high, double nearest,
                                              double farthest);

/// Returns position `i` of `n` inside a pixel, in ±0.5. Sample 0 is the center; the rest follow the R2 sequence
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"), in steps of 1/512. Added to a pixel's
/// index, the position is exact in float32 up to pixel 32768, so that tiles use bit-identical rays.
[[nodiscard]] glm::dvec2 samplePosition(int i, int n);

}  // namespace vitrine::render
