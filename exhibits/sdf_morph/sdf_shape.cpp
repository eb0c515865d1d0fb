#include "exhibits/sdf_morph/sdf_shape.h"

#include "render/glsl/cpu.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace vitrine {
namespace {

glsl::TorusMug torusMug(const SdfMoment& m)
{
    const auto& [table, values, morph] = m;
    return {morph,
            values[table.majorRadius],
            values[table.minorRadius],
            values[table.mugRadius],
            values[table.mugHeight],
            values[table.wallThickness],
            values[table.handleRadius],
            values[table.handleThickness],
            values[table.blend]};
}

render::Box boxOf(const glsl::TorusMugBox& box)
{
    return {box.center - box.halfSize, box.center + box.halfSize};
}

/// The fields of TorusMugShape in order; the shader unpacks them in the same order.
std::array<glm::vec4, 7> packed(const glsl::TorusMugShape& s)
{
    return {glm::vec4(glm::dvec4(s.morph, s.bodyCenter)),
            glm::vec4(s.bodyRadius, s.bodyHalfHeight, s.bodyRoundingAbove, s.bodyRoundingBelow),
            glm::vec4(s.cavityRadius, s.cavityBottom, s.cavityRounding, s.footRadius),
            glm::vec4(s.footHeight, s.footTube, s.ringCenter.x, s.ringCenter.y),
            glm::vec4(s.ringRadius, s.ringTube, s.ringStretch, s.joint),
            glm::vec4(s.lip, 0, 0, 0),
            glm::vec4(0)};
}

/// A regular grid of field values around the object.
struct Grid {
    glm::dvec3 low{0};
    double cell = 1;
    glm::ivec3 points{0};
    std::vector<float> values;

    [[nodiscard]] std::size_t index(glm::ivec3 p) const
    {
        return (static_cast<std::size_t>(p.z) * static_cast<std::size_t>(points.y) + static_cast<std::size_t>(p.y)) *
                   static_cast<std::size_t>(points.x) +
               static_cast<std::size_t>(p.x);
    }
    [[nodiscard]] double at(glm::ivec3 p) const { return values[index(p)]; }
    [[nodiscard]] glm::dvec3 position(glm::dvec3 p) const { return low + cell * p; }
};

Grid sampled(const glsl::TorusMugShape& shape, const render::Box& box, int cells)
{
    Grid grid;
    const glm::dvec3 extent = 2.0 * box.halfSize();
    grid.cell = std::max({extent.x, extent.y, extent.z}) / cells;
    grid.points = glm::ivec3(glm::ceil(extent / grid.cell)) + 3;
    grid.low = box.center() - 0.5 * grid.cell * glm::dvec3(grid.points - 1);
    grid.values.resize(static_cast<std::size_t>(grid.points.x) * static_cast<std::size_t>(grid.points.y) *
                       static_cast<std::size_t>(grid.points.z));
    for (int z = 0; z < grid.points.z; ++z)
        for (int y = 0; y < grid.points.y; ++y)
            for (int x = 0; x < grid.points.x; ++x)
                grid.values[grid.index({x, y, z})] =
                    static_cast<float>(glsl::sdfTorusMug(grid.position({x, y, z}), shape));
    return grid;
}

/// Mean of the crossings along the cell's edges, or nothing where the surface does not cross it.
bool cellVertex(const Grid& grid, glm::ivec3 cell, glm::dvec3& result)
{
    glm::dvec3 sum(0);
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            glm::ivec3 a = cell;
            a[(axis + 1) % 3] += corner & 1;
            a[(axis + 2) % 3] += corner >> 1;
            glm::ivec3 b = a;
            b[axis] += 1;
            const double va = grid.at(a);
            const double vb = grid.at(b);
            if ((va < 0) == (vb < 0)) continue;
            sum += glm::dvec3(a) + glm::dvec3(b - a) * (va / (va - vb));
            ++crossings;
        }
    }
    if (crossings == 0) return false;
    result = sum / static_cast<double>(crossings);
    return true;
}

}  // namespace

render::Box momentaryBox(const SdfMoment& m)
{
    return boxOf(glsl::torusMugBox(glsl::torusMugShape(torusMug(m))));
}

render::Box boxOverMorph(const SdfMoment& m)
{
    return boxOf(glsl::torusMugBoxOverMorph(torusMug(m)));
}

render::Box resized(const render::Box& box, double factor)
{
    return {box.center() - factor * box.halfSize(), box.center() + factor * box.halfSize()};
}

double firstHitOf(const SdfMoment& m, const render::Ray& ray)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double tolerance = 1e-4;  // Metres: less than a pixel from anywhere a visitor can be.
    const double length = glm::length(ray.direction);
    const render::Stretch inside = render::insideBox(ray, momentaryBox(m));
    if (!(inside.enter <= inside.exit) || !(length > 0)) return never;
    const glsl::TorusMugShape shape = glsl::torusMugShape(torusMug(m));
    double t = inside.enter;
    for (int step = 0; step < 1000 && t <= inside.exit; ++step) {
        const double distance = glsl::sdfTorusMug(ray.at(t), shape);
        if (distance < tolerance) return t;
        t += distance / length;
    }
    return never;
}

SdfObject sdfObject(const SdfMoment& m, const render::Box& box, const glm::dmat4& worldFromLocal)
{
    SdfObject object;
    const glm::dmat3 linear(worldFromLocal);
    const double largest = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    object.worldFromLocal = glm::mat4(worldFromLocal);
    object.localFromWorld = glm::mat4(glm::affineInverse(worldFromLocal));
    object.boxLow = glm::vec4(glm::dvec4(box.low, largest));
    object.boxHigh = glm::vec4(glm::dvec4(box.high, 0));
    const auto shape = packed(glsl::torusMugShape(torusMug(m)));
    std::copy(shape.begin(), shape.end(), std::begin(object.shape));
    object.wipe.x = 1e9F;
    return object;
}

std::shared_ptr<const render::Mesh> meshOf(const SdfMoment& m, int cells)
{
    const glsl::TorusMugShape shape = glsl::torusMugShape(torusMug(m));
    const Grid grid = sampled(shape, momentaryBox(m), cells);
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "torus-mug mesh";
    const double h = 1e-4;
    const auto gradient = [&](const glm::dvec3& p) {
        return glm::dvec3(
            glsl::sdfTorusMug(p + glm::dvec3(h, 0, 0), shape) - glsl::sdfTorusMug(p - glm::dvec3(h, 0, 0), shape),
            glsl::sdfTorusMug(p + glm::dvec3(0, h, 0), shape) - glsl::sdfTorusMug(p - glm::dvec3(0, h, 0), shape),
            glsl::sdfTorusMug(p + glm::dvec3(0, 0, h), shape) - glsl::sdfTorusMug(p - glm::dvec3(0, 0, h), shape));
    };
    std::map<std::size_t, std::uint32_t> vertexOfCell;
    for (int z = 0; z + 1 < grid.points.z; ++z) {
        for (int y = 0; y + 1 < grid.points.y; ++y) {
            for (int x = 0; x + 1 < grid.points.x; ++x) {
                glm::dvec3 cell;
                if (!cellVertex(grid, {x, y, z}, cell)) continue;
                glm::dvec3 p = grid.position(cell);
                glm::dvec3 n(0, 1, 0);
                for (int round = 0; round < 2; ++round) {
                    const glm::dvec3 g = gradient(p);
                    if (!(glm::length(g) > 1e-9)) break;
                    n = glm::normalize(g);
                    p -= n * glm::clamp(glsl::sdfTorusMug(p, shape), -0.5 * grid.cell, 0.5 * grid.cell);
                }
                vertexOfCell[grid.index({x, y, z})] = static_cast<std::uint32_t>(mesh->vertices.size());
                mesh->vertices.push_back({glm::vec3(p), glm::vec3(n), {1, 0, 0, 1}, {}, {}});
                mesh->bounds.include(p);
            }
        }
    }
    // One quad around every grid edge that the surface crosses.
    for (int z = 1; z + 1 < grid.points.z; ++z) {
        for (int y = 1; y + 1 < grid.points.y; ++y) {
            for (int x = 1; x + 1 < grid.points.x; ++x) {
                const glm::ivec3 here(x, y, z);
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 next = here;
                    next[axis] += 1;
                    const bool inside = grid.at(here) < 0;
                    if (inside == (grid.at(next) < 0)) continue;
                    glm::ivec3 u(0), v(0);
                    u[(axis + 1) % 3] = 1;
                    v[(axis + 2) % 3] = 1;
                    const std::uint32_t a = vertexOfCell.at(grid.index(here - u - v));
                    const std::uint32_t b = vertexOfCell.at(grid.index(here - v));
                    const std::uint32_t c = vertexOfCell.at(grid.index(here));
                    const std::uint32_t d = vertexOfCell.at(grid.index(here - u));
                    if (inside)
                        mesh->indices.insert(mesh->indices.end(), {a, b, c, a, c, d});
                    else
                        mesh->indices.insert(mesh->indices.end(), {a, c, b, a, d, c});
                }
            }
        }
    }
    return mesh;
}

}  // namespace vitrine
