#include "exhibits/pixel_art/pixel_camera.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vitrine::pixel_art {
namespace {

/// Returns a projection with reversed depth: 1 at the near plane, 0 at `farPlane`.
glm::dmat4 finitePerspective(glm::dvec2 tanHalf, double nearPlane, double farPlane)
{
    glm::dmat4 m(0);
    m[0][0] = 1 / tanHalf.x;
    m[1][1] = 1 / tanHalf.y;
    m[2][2] = nearPlane / (farPlane - nearPlane);
    m[2][3] = -1;
    m[3][2] = nearPlane * farPlane / (farPlane - nearPlane);
    return m;
}

double snapped(double x, double step)
{
    return std::floor(x / step + 0.5) * step;
}

}  // namespace

glm::ivec2 sizeOf(PixelResolution resolution)
{
    constexpr std::array<glm::ivec2, 6> sizes{glm::ivec2(240, 135), glm::ivec2(320, 180), glm::ivec2(480, 270),
                                              glm::ivec2(640, 360), glm::ivec2(960, 540), glm::ivec2(1920, 1080)};
    return sizes[static_cast<std::size_t>(resolution)];
}

PixelCamera pixelCamera(const PixelArtTable& t, const ParameterValues& values, glm::dvec2 aside)
{
    PixelCamera camera;
    const double follow = values[t.parallax];
    camera.azimuth = values[t.azimuth] + follow * aside.x;
    camera.elevation = values[t.elevation] + follow * aside.y;
    if (values[t.snap]) {
        camera.azimuth = snapped(camera.azimuth, values[t.turnStep]);
        camera.elevation = snapped(camera.elevation, values[t.turnStep]);
    }
    const double most = 0.49 * std::numbers::pi;
    camera.elevation = std::clamp(camera.elevation, -most, most);
    camera.distance = values[t.distance];
    camera.tall = values[t.tall];
    camera.orthographic = values[t.projection] == PixelProjection::orthographic;
    camera.size = sizeOf(values[t.resolution]);
    const glm::dvec3 right(std::cos(camera.azimuth), 0, -std::sin(camera.azimuth));
    camera.target = right * values[t.panX] + glm::dvec3(0, values[t.panY], 0);
    return camera;
}

PixelEye pixelView(const PixelCamera& camera, bool snap)
{
    PixelEye eye;
    const double a = camera.azimuth, e = camera.elevation;
    const glm::dvec3 back(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
    const glm::dvec3 right(std::cos(a), 0, -std::sin(a));
    const glm::dvec3 up = glm::cross(back, right);
    const double texel = camera.tall / camera.size.y;
    glm::dvec2 place(glm::dot(camera.target, right), glm::dot(camera.target, up));
    glm::dvec2 left(0);
    if (snap) {
        const glm::dvec2 whole = glm::floor(place / texel + 0.5) * texel;
        left = (place - whole) / texel;
        place = whole;
    }
    const glm::dvec3 target = right * place.x + up * place.y + back * glm::dot(camera.target, back);
    const glm::dvec3 at = target + back * camera.distance;
    glm::dmat4 worldFromView(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(back, 0), glm::dvec4(at, 1));

    const double aspect = static_cast<double>(camera.size.x) / camera.size.y;
    const double nearPlane = camera.orthographic ? 0.1 : std::clamp(0.02 * camera.distance, 0.02, 0.5);
    const double farPlane = nearPlane + 100;
    const double half = camera.orthographic ? 0.5 * camera.tall : 0.5 * camera.tall / camera.distance;
    const glm::dvec2 extent(half * aspect, half);
    eye.view.viewFromWorld = glm::affineInverse(worldFromView);
    eye.view.clipFromView = camera.orthographic ? render::reversedOrthographic(-extent, extent, -nearPlane, -farPlane)
                                                : finitePerspective(extent, nearPlane, farPlane);
    eye.view.clipFromWorld = eye.view.clipFromView * eye.view.viewFromWorld;
    eye.view.eye = at;
    eye.view.tanHalfFov = extent;
    eye.view.nearPlane = nearPlane;
    eye.view.raster.size = camera.size;

    PixelBlock& block = eye.block;
    block.worldFromView = glm::mat4(worldFromView);
    block.up = glm::vec3(eye.view.viewFromWorld * glm::dvec4(0, 1, 0, 0));
    block.halfExtent = glm::vec2(extent);
    block.remainder = glm::vec2(left);
    block.size = camera.size;
    block.nearPlane = static_cast<float>(nearPlane);
    block.farPlane = static_cast<float>(farPlane);
    block.orthographic = camera.orthographic;
    block.divider = camera.size.x;
    return eye;
}

}  // namespace vitrine::pixel_art
