#include "exhibits/kit/surface_net.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace vitrine {
namespace {

using Distance = std::function<double(const glm::dvec3&)>;
using VertexOfCell = std::map<std::size_t, std::uint32_t>;

/// A regular grid of field values around the object.
struct FieldGrid {
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

FieldGrid sampled(const Distance& distance, const render::Box& box, int cells)
{
    FieldGrid grid;
    const glm::dvec3 extent = 2.0 * box.halfSize();
    grid.cell = std::max({extent.x, extent.y, extent.z}) / cells;
    grid.points = glm::ivec3(glm::ceil(extent / grid.cell)) + 3;
    grid.low = box.center() - 0.5 * grid.cell * glm::dvec3(grid.points - 1);
    grid.values.resize(static_cast<std::size_t>(grid.points.x) * static_cast<std::size_t>(grid.points.y) *
                       static_cast<std::size_t>(grid.points.z));
    for (int z = 0; z < grid.points.z; ++z)
        for (int y = 0; y < grid.points.y; ++y)
            for (int x = 0; x < grid.points.x; ++x)
                grid.values[grid.index({x, y, z})] = static_cast<float>(distance(grid.position({x, y, z})));
    return grid;
}

/// Finds the mean of the crossings along the cell's edges. Returns false if the surface does not cross the cell.
bool cellVertex(const FieldGrid& grid, glm::ivec3 cell, glm::dvec3& result)
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

glm::dvec3 slopeOf(const Distance& distance, const glm::dvec3& p)
{
    constexpr double h = 1e-4;
    return {distance(p + glm::dvec3(h, 0, 0)) - distance(p - glm::dvec3(h, 0, 0)),
            distance(p + glm::dvec3(0, h, 0)) - distance(p - glm::dvec3(0, h, 0)),
            distance(p + glm::dvec3(0, 0, h)) - distance(p - glm::dvec3(0, 0, h))};
}

/// Adds one vertex on the surface for each cell that it crosses.
VertexOfCell addVertices(const FieldGrid& grid, const Distance& distance, render::Mesh& mesh)
{
    VertexOfCell vertexOfCell;
    for (int z = 0; z + 1 < grid.points.z; ++z) {
        for (int y = 0; y + 1 < grid.points.y; ++y) {
            for (int x = 0; x + 1 < grid.points.x; ++x) {
                glm::dvec3 cell;
                if (!cellVertex(grid, {x, y, z}, cell)) continue;
                glm::dvec3 p = grid.position(cell);
                glm::dvec3 n(0, 1, 0);
                for (int round = 0; round < 2; ++round) {
                    const glm::dvec3 g = slopeOf(distance, p);
                    if (!(glm::length(g) > 1e-9)) break;
                    n = glm::normalize(g);
                    p -= n * glm::clamp(distance(p), -0.5 * grid.cell, 0.5 * grid.cell);
                }
                vertexOfCell[grid.index({x, y, z})] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back({glm::vec3(p), glm::vec3(n), {1, 0, 0, 1}, {}, {}});
                mesh.bounds.include(p);
            }
        }
    }
    return vertexOfCell;
}

/// Adds the quad around the grid edge from `here` along `axis`, if the surface crosses it.
void addQuad(const FieldGrid& grid, const VertexOfCell& vertexOfCell, glm::ivec3 here, int axis, render::Mesh& mesh)
{
    glm::ivec3 next = here;
    next[axis] += 1;
    const bool inside = grid.at(here) < 0;
    if (inside == (grid.at(next) < 0)) return;
    glm::ivec3 u(0), v(0);
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    const std::uint32_t a = vertexOfCell.at(grid.index(here - u - v));
    const std::uint32_t b = vertexOfCell.at(grid.index(here - v));
    const std::uint32_t c = vertexOfCell.at(grid.index(here));
    const std::uint32_t d = vertexOfCell.at(grid.index(here - u));
    if (inside)
        mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    else
        mesh.indices.insert(mesh.indices.end(), {a, c, b, a, d, c});
}

/// Adds quads of all edges with four cells around them, including the outermost, since a body may touch the box's
/// faces.
void addQuads(const FieldGrid& grid, const VertexOfCell& vertexOfCell, render::Mesh& mesh)
{
    for (int z = 0; z + 1 < grid.points.z; ++z)
        for (int y = 0; y + 1 < grid.points.y; ++y)
            for (int x = 0; x + 1 < grid.points.x; ++x)
                for (int axis = 0; axis < 3; ++axis) {
                    const glm::ivec3 here(x, y, z);
                    if (here[(axis + 1) % 3] > 0 && here[(axis + 2) % 3] > 0)
                        addQuad(grid, vertexOfCell, here, axis, mesh);
                }
}

}  // namespace

std::shared_ptr<const render::Mesh> surfaceNet(const Distance& distance, const render::Box& box, int cells,
                                               std::string name)
{
    const FieldGrid grid = sampled(distance, box, cells);
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = std::move(name);
    addQuads(grid, addVertices(grid, distance, *mesh), *mesh);
    return mesh;
}

}  // namespace vitrine
