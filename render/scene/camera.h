#pragma once

#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace vitrine::render {

/// How far from the origin anything may be, along each axis, meters: a thousand kilometers.
inline constexpr double farthestPlace = 1e6;

/// Where one looks from. World space: y up, meters, within `farthestPlace`.
struct Camera {
    glm::dvec3 eye{0, 1.65, 10.5};
    glm::dvec3 target{0, 1.75, 0};
    double fovY = 0.959931;  ///< Vertical field of view, radians (55°). Clamped to [1°, 175°] by `makeView`.
    /// Where the middle of the picture looks, off the view axis: tangents, to the right and up. Slides the picture
    /// within the same image plane, as a shift lens does; 0 is straight ahead. Not finite counts as 0.
    glm::dvec2 lensShift{0};

    /// The same camera elsewhere: eye and target moved.
    [[nodiscard]] Camera transformed(const glm::dmat4& m) const
    {
        Camera moved = *this;
        moved.eye = glm::dvec3(m * glm::dvec4(eye, 1));
        moved.target = glm::dvec3(m * glm::dvec4(target, 1));
        return moved;
    }
    bool operator==(const Camera&) const = default;
};

/// Which part of a picture is being drawn, and where inside its pixels.
struct Raster {
    glm::ivec2 size{640, 360};  ///< Of the whole picture, in pixels.
    glm::ivec2 offset{0};       ///< Lower left corner of the tile in the whole picture.
    glm::ivec2 tile{0};         ///< Size of the tile; (0, 0) means the whole picture.
    glm::dvec2 jitter{0};       ///< Sample position relative to the pixel's center, in pixels, inside ±0.5.

    [[nodiscard]] glm::ivec2 drawn() const { return tile.x > 0 && tile.y > 0 ? tile : size; }
};

/// A camera made concrete for one picture. Clip space: reversed depth, near 1, infinitely far 0.
struct View {
    glm::dmat4 viewFromWorld{1};
    glm::dmat4 clipFromView{1};  ///< Of the tile, jitter included.
    glm::dmat4 clipFromWorld{1};
    glm::dvec3 eye{0};
    glm::dvec2 tanHalfFov{1};  ///< Of the whole picture, horizontal and vertical.
    glm::dvec2 tanShift{0};    ///< Of the middle of the whole picture, off the view axis.
    double nearPlane = 0.02;   ///< Meters.
    Raster raster;
    /// World space: only points p with dot(plane, (p, 1)) >= 0 are drawn, in what lies behind a mirror or a portal.
    std::optional<glm::dvec4> clipPlane;

    /// World-space direction through a place in the whole picture (each -1 to 1, y up), with length 1 along the axis.
    [[nodiscard]] glm::dvec3 direction(glm::dvec2 ndc) const;
    /// False only when no point of `worldBox` can be inside the view frustum (conservative).
    [[nodiscard]] bool mayContain(const Box& worldBox) const;
};

/// Handles a target equal to the eye, a vertical look direction, a field of view out of range, and positions out of
/// range or NaN: they are brought into it.
[[nodiscard]] View makeView(const Camera&, const Raster&);

/// The same camera for other pixels: another tile, jitter or size. The angles stay, so that pixels of another aspect
/// are not square.
[[nodiscard]] View withRaster(const View&, const Raster&);

/// Reversed infinite perspective: near plane at depth 1, infinity at 0. `tanHalfFov` > 0, `nearPlane` > 0;
/// `tanShift` is where its middle looks, off the axis.
[[nodiscard]] glm::dmat4 reversedPerspective(glm::dvec2 tanHalfFov, double nearPlane,
                                             glm::dvec2 tanShift = glm::dvec2(0));

/// Reversed orthographic projection of a box in light space: z = `nearest` gives depth 1, `farthest` 0
/// (both are view-space z, negative in front).
[[nodiscard]] glm::dmat4 reversedOrthographic(const glm::dvec2& low, const glm::dvec2& high, double nearest,
                                              double farthest);

/// Position `i` of `n` inside a pixel, in ±0.5: sample 0 is the center, the rest follow the R2 sequence
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"), in steps of 1/512: added to a
/// pixel's number it is exact in float32 up to pixel 32768, so that tiles see the same rays to the bit.
[[nodiscard]] glm::dvec2 samplePosition(int i, int n);

}  // namespace vitrine::render
