#include "exhibits/crepuscular_rays/sun_in_picture.h"

#include "exhibits/framework/scene/scene_lighting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vitrine::crepuscular_rays {
namespace {

constexpr double thinnestBeam = 0.3;  ///< Meters.

/// Returns the beam behind one opening; its box is empty if no light enters.
Beam beamBehind(const render::Box& opening, const render::Box& room, const glm::dvec3& towardsSun)
{
    Beam beam;
    beam.opening = opening;
    beam.axis = flatAxis(opening);
    const int axis = beam.axis;
    const bool high = opening.center()[axis] > room.center()[axis];
    // The sun has to be outside, on the other side of this wall.
    const double outwards = high ? towardsSun[axis] : -towardsSun[axis];
    if (!(outwards > 1e-4)) return beam;
    beam.plane = high ? std::min(opening.low[axis], room.high[axis]) : std::max(opening.high[axis], room.low[axis]);
    const glm::dvec3 along = towardsSun / towardsSun[axis];
    const double deep = opening.high[axis] - opening.low[axis];
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        if (opening.high[i] - opening.low[i] - deep * std::abs(along[i]) < thinnestBeam) return beam;
    }
    // Sweeps the rectangle on its plane along the light, until all of it has left the room on the other side.
    const double other = high ? room.low[axis] : room.high[axis];
    double reach = other - beam.plane;
    for (int i = 0; i < 3; ++i) {
        if (i == axis || std::abs(along[i]) < 1e-9) continue;
        const double drift = along[i] * (reach > 0 ? 1 : -1);
        const double path =
            drift > 0 ? (room.high[i] - opening.low[i]) / drift : (opening.high[i] - room.low[i]) / -drift;
        if (path < std::abs(reach)) reach = std::copysign(std::max(path, 0.0), reach);
    }
    for (const double t : {0.0, reach}) {
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec3 p((corner & 1) != 0 ? opening.high.x : opening.low.x,
                         (corner & 2) != 0 ? opening.high.y : opening.low.y,
                         (corner & 4) != 0 ? opening.high.z : opening.low.z);
            p[axis] = beam.plane;
            beam.box.include(glm::clamp(p + along * t, room.low, room.high));
        }
    }
    return beam;
}

}  // namespace

SunInPicture sunInPicture(const render::View& view, const glm::dvec3& towardsSun)
{
    SunInPicture sun;
    const glm::dvec3 inView = glm::dmat3(view.viewFromWorld) * towardsSun;
    const double w = -inView.z;
    // This close to the camera plane, rounding alone decides on which side the sun is.
    if (!(w > 1e-9)) return sun;
    const glm::dvec2 ndc = (glm::dvec2(inView) / w - view.tanShift) / view.tanHalfFov;
    sun.inFront = true;
    sun.pixel = (ndc * 0.5 + 0.5) * glm::dvec2(view.raster.size);
    sun.beyond = std::max(std::abs(ndc.x), std::abs(ndc.y)) - 1;
    return sun;
}

PolarGrid polarGrid(glm::dvec2 source, glm::dvec2 size, int samples)
{
    PolarGrid grid;
    const std::array<glm::dvec2, 4> corners{glm::dvec2(0), glm::dvec2(size.x, 0), glm::dvec2(0, size.y), size};
    double farthest = 1;
    for (const glm::dvec2& corner : corners) farthest = std::max(farthest, glm::length(corner - source));
    const glm::dvec2 nearest = glm::clamp(source, glm::dvec2(0), size);
    const double distance = glm::length(source - nearest);
    grid.around = distance < 1;
    grid.radii = grid.angles = std::clamp(4 * samples, 16, 4096);
    grid.lastRadius = farthest * 1.01;
    // Radii below a few pixels (farthest / 512) are not resolved. From outside, nothing shines before the edge.
    grid.firstRadius = std::max({grid.around ? 0.5 : distance * 0.995, farthest / 512, 0.25});
    if (grid.around) {
        grid.firstAngle = -std::numbers::pi;
        grid.span = 2 * std::numbers::pi;
        return grid;
    }
    const glm::dvec2 middle = size * 0.5 - source;
    const double center = std::atan2(middle.y, middle.x);
    double low = 0;
    double high = 0;
    for (const glm::dvec2& corner : corners) {
        const glm::dvec2 path = corner - source;
        double angle = std::atan2(path.y, path.x) - center;
        angle -= 2 * std::numbers::pi * std::round(angle / (2 * std::numbers::pi));
        low = std::min(low, angle);
        high = std::max(high, angle);
    }
    const double margin = 2 * (high - low) / grid.angles;
    grid.firstAngle = center + low - margin;
    grid.span = high - low + 2 * margin;
    return grid;
}

std::vector<Beam> beams(std::span<const render::Box> openings, const render::Box& room, const glm::dvec3& towardsSun)
{
    std::vector<Beam> result;
    for (const render::Box& opening : openings) {
        Beam beam = beamBehind(opening, room, towardsSun);
        if (!beam.box.empty()) result.push_back(std::move(beam));
    }
    return result;
}

}  // namespace vitrine::crepuscular_rays
