#pragma once

#include "exhibits/pixel_art/pixel_camera.h"

#include <glm/glm.hpp>

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace vitrine::test {

/// First hit of a ray, from closed forms at float64.
struct TracedHit {
    double distance = 0;
    glm::dvec3 normal{0};  ///< Normal in world space.
};

/// Ray in world space; `direction` has any length.
using TracedWorld = std::function<std::optional<TracedHit>(const glm::dvec3& origin, const glm::dvec3& direction)>;

inline void nearer(std::optional<TracedHit>& best, double t, const glm::dvec3& normal)
{
    if (t > 1e-6 && (!best || t < best->distance)) best = TracedHit{t, glm::normalize(normal)};
}

inline void meetSphere(std::optional<TracedHit>& best, const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& c,
                       double r)
{
    const glm::dvec3 v = o - c;
    const double a = glm::dot(d, d), b = glm::dot(v, d), q = b * b - a * (glm::dot(v, v) - r * r);
    if (q < 0) return;
    const double t = (-b - std::sqrt(q)) / a;
    nearer(best, t, v + t * d);
}

/// Box that is rotated by `turn` about y and `tilt` about x, in radians.
struct TracedBox {
    glm::dvec3 center, half;  ///< `half` is half its size.
    double turn = 0, tilt = 0;
};

inline void meetBox(std::optional<TracedHit>& best, const glm::dvec3& o, const glm::dvec3& d, const TracedBox& box)
{
    const auto& [c, half, turn, tilt] = box;
    const double cy = std::cos(turn), sy = std::sin(turn), cx = std::cos(tilt), sx = std::sin(tilt);
    const glm::dmat3 m = glm::dmat3(cy, 0, -sy, 0, 1, 0, sy, 0, cy) * glm::dmat3(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    const glm::dvec3 lo = (o - c) * m, ld = d * m;
    double in = -1e30, out = 1e30;
    glm::dvec3 n(0);
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1 / (std::abs(ld[k]) > 1e-12 ? ld[k] : 1e-12);
        const double a = (-half[k] - lo[k]) * inverse, b = (half[k] - lo[k]) * inverse;
        if (std::min(a, b) > in) {
            in = std::min(a, b);
            n = glm::dvec3(0);
            n[k] = ld[k] > 0 ? -1 : 1;
        }
        out = std::min(out, std::max(a, b));
    }
    if (in <= out) nearer(best, in, m * n);
}

inline void meetFloor(std::optional<TracedHit>& best, const glm::dvec3& o, const glm::dvec3& d)
{
    if (d.y != 0) nearer(best, -o.y / d.y, {0, 1, 0});
}

/// Spheres, rotated boxes and a floor.
inline std::optional<TracedHit> solids(const glm::dvec3& o, const glm::dvec3& d)
{
    std::optional<TracedHit> best;
    meetFloor(best, o, d);
    for (int i = 0; i < 5; ++i) {
        meetSphere(best, o, d, {-3.2 + 1.7 * i, 0.8 + 0.1 * i, 1.5 - 0.9 * i}, 0.55 + 0.12 * i);
        meetBox(best, o, d, {{3.1 - 1.6 * i, 0.7, 2.6 - 0.5 * i}, {0.4, 0.7 + 0.1 * i, 0.3}, 0.5 * i + 0.2, 0.15 * i});
    }
    return best;
}

/// Bars of one to two texels for 240 x 135 texels and a picture 9.8 m tall, in front of a floor.
inline std::optional<TracedHit> bars(const glm::dvec3& o, const glm::dvec3& d)
{
    std::optional<TracedHit> best;
    meetFloor(best, o, d);
    constexpr double texel = 9.8 / 135;
    for (int i = 0; i < 12; ++i) {
        const double thick = 0.5 * texel * (1 + 0.5 * (i % 3));
        meetBox(best, o, d, {{-4.4 + 0.8 * i, 1.3, 4.4 - 0.8 * i}, {thick, 1.3, thick}, 0.2 * i});
        meetBox(best, o, d, {{-4 + 0.75 * i, 0.8 + 0.1 * i, 3 - 0.75 * i}, {thick, 1.2, thick}, 0.3 * i, 0.9});
    }
    return best;
}

/// Picture of stored depth and true normals.
struct TracedPicture {
    TracedPicture(const pixel_art::PixelCamera& camera, const TracedWorld& world)
        : block(pixel_art::pixelView(camera, false).block), size(camera.size)
    {
        depth.resize(static_cast<std::size_t>(size.x * size.y), 0.0);
        normals.resize(depth.size(), glm::dvec3(0));
        const glm::dmat4 worldFromView(block.worldFromView);
        const double n = block.nearPlane, f = block.farPlane;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec2 at =
                    (glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(size) * 2.0 - 1.0) * glm::dvec2(block.halfExtent);
                const glm::dvec3 from = block.orthographic ? glm::dvec3(at, 0) : glm::dvec3(0);
                const glm::dvec3 along = block.orthographic ? glm::dvec3(0, 0, -1) : glm::dvec3(at, -1);
                const auto hit =
                    world(glm::dvec3(worldFromView * glm::dvec4(from, 1)), glm::dmat3(worldFromView) * along);
                if (!hit || hit->distance >= f) continue;
                const double z = hit->distance;
                depth[index({x, y})] = block.orthographic ? (f - z) / (f - n) : n * (f - z) / (z * (f - n));
                normals[index({x, y})] = hit->normal * glm::dmat3(worldFromView);
            }
    }
    [[nodiscard]] std::size_t index(glm::ivec2 p) const { return static_cast<std::size_t>(p.y * size.x + p.x); }
    [[nodiscard]] bool hit(glm::ivec2 p) const { return depth[index(p)] > 0; }

    pixel_art::PixelBlock block;
    glm::ivec2 size;
    std::vector<double> depth;        ///< Reversed depth at float64; 0: nothing.
    std::vector<glm::dvec3> normals;  ///< Normals in view space.
};

/// Returns a depth as a buffer of `levels` codes stores it (0: 32-bit floats), reversed or not.
[[nodiscard]] inline double stored(double reversed, double levels, bool standard)
{
    const double d = standard ? 1 - reversed : reversed;
    return levels > 0 ? std::floor(d * levels + 0.5) / levels : static_cast<double>(static_cast<float>(d));
}

}  // namespace vitrine::test
