#include "render/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::render {

Box Box::transformed(const glm::dmat4& transform) const
{
    Box result;
    if (empty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                           (corner & 4) != 0 ? high.z : low.z);
        result.include(glm::dvec3(transform * glm::dvec4(p, 1)));
    }
    return result;
}

glm::dvec3 View::direction(glm::dvec2 ndc) const
{
    return glm::transpose(glm::dmat3(viewFromWorld)) * glm::dvec3(ndc * tanHalfFov + tanShift, -1);
}

bool View::mayContain(const Box& box) const
{
    if (box.empty()) return false;
    // The box is outside if all its corners lie beyond one clip plane. The far plane is at infinity.
    std::array<int, 5> outside{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 p((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z, 1);
        const glm::dvec4 clip = clipFromWorld * p;
        outside[0] += clip.x < -clip.w;
        outside[1] += clip.x > clip.w;
        outside[2] += clip.y < -clip.w;
        outside[3] += clip.y > clip.w;
        outside[4] += clip.w < nearPlane;
    }
    return std::none_of(outside.begin(), outside.end(), [](int n) { return n == 8; });
}

namespace {

/// Clamps a position to the range that float32 matrices can hold; a NaN component becomes 0.
glm::dvec3 insideTheWorld(const glm::dvec3& p)
{
    glm::dvec3 result(0);
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isnan(p[axis])) result[axis] = std::clamp(p[axis], -farthestPlace, farthestPlace);
    return result;
}

}  // namespace

View makeView(const Camera& camera, const Raster& raster)
{
    View view;
    view.raster = raster;
    view.eye = insideTheWorld(camera.eye);
    const glm::dvec3 toTarget = insideTheWorld(camera.target) - view.eye;
    const double distance = glm::length(toTarget);
    const glm::dvec3 forward = distance > 1e-9 ? toTarget / distance : glm::dvec3(0, 0, -1);
    const glm::dvec3 up =
        std::abs(forward.y) > 0.99999 ? glm::dvec3(0, 0, forward.y > 0 ? 1 : -1) : glm::dvec3(0, 1, 0);
    // Does not use lookAt: far from the origin, its target one meter ahead would round to the eye.
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward));
    view.viewFromWorld = glm::dmat4(viewFromWorld);
    view.viewFromWorld[3] = glm::dvec4(-(viewFromWorld * view.eye), 1);

    const double degree = std::numbers::pi / 180;
    const double fov = std::clamp(std::isfinite(camera.fovY) ? camera.fovY : 55 * degree, degree, 175 * degree);
    const glm::dvec2 size = glm::max(raster.size, glm::ivec2(1));
    view.tanHalfFov = std::tan(fov / 2) * glm::dvec2(size.x / size.y, 1);

    view.tanShift = {std::isfinite(camera.lensShift.x) ? camera.lensShift.x : 0,
                     std::isfinite(camera.lensShift.y) ? camera.lensShift.y : 0};

    return withRaster(view, raster);
}

View withRaster(const View& camera, const Raster& raster)
{
    View view = camera;
    view.raster = raster;
    // Maps the tile's pixels to [-1, 1]. The jitter moves the sample, so the picture moves the opposite way.
    const glm::dvec2 size = glm::max(raster.size, glm::ivec2(1));
    const glm::dvec2 drawn = glm::max(raster.drawn(), glm::ivec2(1));
    const glm::dvec2 scale = size / drawn;
    const glm::dvec2 shift = (size - 2.0 * (glm::dvec2(raster.offset) + raster.jitter)) / drawn - 1.0;
    glm::dmat4 tileFromWhole(1);
    tileFromWhole[0][0] = scale.x;
    tileFromWhole[1][1] = scale.y;
    tileFromWhole[3][0] = shift.x;
    tileFromWhole[3][1] = shift.y;
    view.clipFromView = tileFromWhole * reversedPerspective(view.tanHalfFov, view.nearPlane, view.tanShift);
    view.clipFromWorld = view.clipFromView * view.viewFromWorld;
    return view;
}

glm::dmat4 reversedPerspective(glm::dvec2 tanHalfFov, double nearPlane, glm::dvec2 tanShift)
{
    glm::dmat4 clipFromView(0);
    clipFromView[0][0] = 1 / tanHalfFov.x;
    clipFromView[1][1] = 1 / tanHalfFov.y;
    clipFromView[2][0] = tanShift.x / tanHalfFov.x;
    clipFromView[2][1] = tanShift.y / tanHalfFov.y;
    clipFromView[2][3] = -1;
    clipFromView[3][2] = nearPlane;
    return clipFromView;
}

glm::dmat4 reversedOrthographic(const glm::dvec2& low, const glm::dvec2& high, double nearest, double farthest)
{
    glm::dmat4 clipFromView(1);
    clipFromView[0][0] = 2 / (high.x - low.x);
    clipFromView[1][1] = 2 / (high.y - low.y);
    clipFromView[2][2] = 1 / (nearest - farthest);
    clipFromView[3][0] = -(high.x + low.x) / (high.x - low.x);
    clipFromView[3][1] = -(high.y + low.y) / (high.y - low.y);
    clipFromView[3][2] = -farthest / (nearest - farthest);
    return clipFromView;
}

glm::dvec2 samplePosition(int i, int n)
{
    if (i == 0 || n <= 1) return glm::dvec2(0);
    const double plastic = 1.32471795724474602596;
    const glm::dvec2 step(1 / plastic, 1 / (plastic * plastic));
    const glm::dvec2 p = glm::dvec2(0.5) + step * static_cast<double>(i);
    return glm::floor((p - glm::floor(p)) * 512.0) / 512.0 - 0.5;
}

}  // namespace vitrine::render
