#include "exhibits/pixel_art/world_builder.h"

#include "exhibits/kit/surface_draw.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace vitrine::pixel_art {
namespace {

constexpr double turnAround = 2 * std::numbers::pi;

glm::dvec3 around(double angle, double radius, double y)
{
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

}  // namespace

WorldBuilder& WorldBuilder::object()
{
    ++object_;
    return *this;
}

WorldBuilder& WorldBuilder::at(const glm::dmat4& modelFromPart)
{
    place_ = modelFromPart;
    return *this;
}

WorldBuilder& WorldBuilder::at(const glm::dvec3& place, double turn)
{
    return at(glm::rotate(glm::translate(glm::dmat4(1), place), turn, glm::dvec3(0, 1, 0)));
}

std::uint32_t WorldBuilder::vertex(const glm::dvec3& p, const glm::dvec3& n, glm::dvec2 uv, const Paint& paint)
{
    const glm::dvec3 placed(place_ * glm::dvec4(p, 1));
    const glm::dvec3 turned = normalMatrix(glm::dmat3(place_)) * n;
    mesh_->bounds.include(placed);
    mesh_->vertices.push_back({glm::vec3(placed),
                               glm::vec3(glm::normalize(turned)),
                               glm::vec4(paint.color, static_cast<float>(object_)),
                               glm::vec2(uv),
                               {paint.glow, static_cast<float>(paint.pattern)}});
    return static_cast<std::uint32_t>(mesh_->vertices.size() - 1);
}

void WorldBuilder::triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Paint& paint)
{
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const auto uv = [](const glm::dvec3& p) { return glm::dvec2(p.x, p.z); };
    for (const glm::dvec3& p : {a, b, c}) mesh_->indices.push_back(vertex(p, n, uv(p), paint));
}

void WorldBuilder::quad(const std::array<glm::dvec3, 4>& corners, const Paint& paint, glm::dvec2 uvA, glm::dvec2 uvC)
{
    const auto& [a, b, c, d] = corners;
    const glm::dvec3 n = glm::normalize(glm::cross(c - a, d - b));
    const std::uint32_t i = vertex(a, n, uvA, paint);
    vertex(b, n, {uvC.x, uvA.y}, paint);
    vertex(c, n, uvC, paint);
    vertex(d, n, {uvA.x, uvC.y}, paint);
    mesh_->indices.insert(mesh_->indices.end(), {i, i + 1, i + 2, i, i + 2, i + 3});
}

WorldBuilder& WorldBuilder::box(const glm::dvec3& half, const Paint& paint)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 n(0), u(0), v(0);
            n[axis] = side * half[axis];
            // v points up on the four sides.
            const int up = axis == 1 ? 2 : 1;
            const int along = 3 - axis - up;
            v[up] = half[up];
            u[along] = half[along];
            if (glm::dot(glm::cross(u, v), n) < 0) u = -u;
            const glm::dvec2 size(half[along], half[up]);
            quad({n - u - v, n + u - v, n + u + v, n - u + v}, paint, -size, size);
        }
    return *this;
}

WorldBuilder& WorldBuilder::prism(int sides, double foot, double top, double height, const Paint& paint, bool smooth)
{
    const double step = turnAround / sides;
    const double lean = (foot - top) / std::max(height, 1e-9);
    for (int i = 0; i < sides; ++i) {
        const double from = i * step;
        const double to = from + step;
        if (smooth) {
            const auto n = [&](double angle) { return glm::normalize(around(angle, 1, lean)); };
            const std::uint32_t first = vertex(around(from, foot, 0), n(from), {from * foot, 0}, paint);
            vertex(around(to, foot, 0), n(to), {to * foot, 0}, paint);
            vertex(around(to, top, height), n(to), {to * foot, height}, paint);
            vertex(around(from, top, height), n(from), {from * foot, height}, paint);
            mesh_->indices.insert(mesh_->indices.end(), {first, first + 2, first + 1, first, first + 3, first + 2});
        } else if (top > 0) {
            quad({around(to, foot, 0), around(from, foot, 0), around(from, top, height), around(to, top, height)},
                 paint, {to * foot, 0}, {from * foot, height});
        } else {
            triangle(around(to, foot, 0), around(from, foot, 0), {0, height, 0}, paint);
        }
        if (top > 0) triangle({0, height, 0}, around(to, top, height), around(from, top, height), paint);
        triangle({0, 0, 0}, around(from, foot, 0), around(to, foot, 0), paint);
    }
    return *this;
}

WorldBuilder& WorldBuilder::ball(const glm::dvec3& radii, const Paint& paint, int rings)
{
    const int sides = 2 * rings;
    const auto first = static_cast<std::uint32_t>(mesh_->vertices.size());
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= sides; ++i) {
            const double up = std::numbers::pi * (static_cast<double>(j) / rings - 0.5);
            const glm::dvec3 p = around(turnAround * i / sides, std::cos(up), std::sin(up));
            vertex(p * radii, p / radii, {p.x, p.y}, paint);
        }
    const auto row = static_cast<std::uint32_t>(sides + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rings); ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + j * row + i;
            mesh_->indices.insert(mesh_->indices.end(), {a, a + row, a + 1, a + 1, a + row, a + row + 1});
        }
    return *this;
}

WorldBuilder& WorldBuilder::torus(double ring, double tube, const Paint& paint, int sides, int across)
{
    const auto first = static_cast<std::uint32_t>(mesh_->vertices.size());
    for (int i = 0; i <= sides; ++i)
        for (int j = 0; j <= across; ++j) {
            const double turn = turnAround * i / sides;
            const double roll = turnAround * j / across;
            const glm::dvec3 n = around(turn, std::cos(roll), std::sin(roll));
            vertex(around(turn, ring, 0) + tube * n, n, {turn, roll}, paint);
        }
    const auto row = static_cast<std::uint32_t>(across + 1);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i)
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            const std::uint32_t a = first + i * row + j;
            mesh_->indices.insert(mesh_->indices.end(), {a, a + 1, a + row, a + 1, a + row + 1, a + row});
        }
    return *this;
}

WorldBuilder& WorldBuilder::gable(const glm::dvec3& half, const Paint& roof, const Paint& wall)
{
    const glm::dvec3 h = half;
    const double slope = std::hypot(h.x, h.y);
    const glm::dvec3 ridgeFront(0, h.y, h.z), ridgeBack(0, h.y, -h.z);
    const glm::dvec3 rightFront(h.x, 0, h.z), rightBack(h.x, 0, -h.z), leftFront(-h.x, 0, h.z), leftBack(-h.x, 0, -h.z);
    quad({rightFront, rightBack, ridgeBack, ridgeFront}, roof, {-h.z, 0}, {h.z, slope});
    quad({leftBack, leftFront, ridgeFront, ridgeBack}, roof, {-h.z, 0}, {h.z, slope});
    quad({leftBack, rightBack, rightFront, leftFront}, roof, {0, 0}, {1, 1});
    triangle(leftFront, rightFront, ridgeFront, wall);
    triangle(rightBack, leftBack, ridgeBack, wall);
    return *this;
}

WorldBuilder& WorldBuilder::slab(const std::function<double(double)>& outline, const Extrusion& extrusion,
                                 const Paint& top, const Paint& side, int sides)
{
    const auto [low, high, lean] = extrusion;
    const double step = turnAround / sides;
    for (int i = 0; i < sides; ++i) {
        const double from = i * step;
        const double to = from + step;
        const glm::dvec3 a = around(to, outline(to), low), b = around(from, outline(from), low);
        const glm::dvec3 c = around(from, outline(from) - lean, high), d = around(to, outline(to) - lean, high);
        quad({a, b, c, d}, side, {to * 4, low}, {from * 4, high});
        triangle({0, high, 0}, d, c, top);
    }
    return *this;
}

WorldBuilder& WorldBuilder::water(const std::function<double(double)>& outline, double height, double reach,
                                  const Paint& paint)
{
    constexpr int sides = 96;
    const double distances[] = {-0.6, 0, 0.3, 0.7, 1.2, 2, 3, reach};
    for (int i = 0; i < sides; ++i)
        for (int j = 0; j + 1 < 8; ++j) {
            const double from = turnAround * i / sides;
            const double to = turnAround * (i + 1) / sides;
            const auto p = [&](double angle, double away) { return around(angle, outline(angle) + away, height); };
            quad({p(from, distances[j]), p(to, distances[j]), p(to, distances[j + 1]), p(from, distances[j + 1])},
                 paint, {0, 0}, {0, 0});
            const std::size_t last = mesh_->vertices.size();
            const auto uv = [&](std::size_t k, double away, double angle) {
                mesh_->vertices[last - k].uv = glm::vec2(glm::dvec2(away, angle / turnAround));
            };
            uv(4, distances[j], from), uv(3, distances[j], to), uv(2, distances[j + 1], to),
                uv(1, distances[j + 1], from);
        }
    return *this;
}

WorldBuilder& WorldBuilder::tiles(const glm::dvec2& half, double tile, const Paint& paint)
{
    quad({{{-half.x, 0, half.y}, {half.x, 0, half.y}, {half.x, 0, -half.y}, {-half.x, 0, -half.y}}}, paint,
         glm::dvec2(-half.x, half.y) / tile, glm::dvec2(half.x, -half.y) / tile);
    return *this;
}

std::shared_ptr<const render::Mesh> WorldBuilder::finished()
{
    return std::exchange(mesh_, std::make_shared<render::Mesh>());
}

}  // namespace vitrine::pixel_art
