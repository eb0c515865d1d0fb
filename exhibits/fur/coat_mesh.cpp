#include "exhibits/fur/coat_mesh.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <set>

namespace vitrine::fur {
namespace {

using render::Mesh;
using render::Vertex;

constexpr double pi = std::numbers::pi;

Vertex skinVertex(const glm::dvec3& position, const glm::dvec3& normal, double curvature)
{
    Vertex v;
    v.position = glm::vec3(position);
    v.normal = glm::vec3(normal);
    v.extra = {static_cast<float>(std::max(curvature, 0.0)), 0};
    return v;
}

void boundIt(Mesh& mesh)
{
    for (const Vertex& v : mesh.vertices) mesh.bounds.include(glm::dvec3(v.position));
}

/// Adds a grid of (columns + 1) × (rows + 1) vertices; its faces look along du × dv.
void addGrid(Mesh& mesh, int columns, int rows, const std::function<Vertex(double u, double v)>& at)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            mesh.vertices.push_back(at(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
            const std::uint32_t a = first + j * stride + i;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + stride + 1, a, a + stride + 1, a + stride});
        }
    }
}

}  // namespace

std::shared_ptr<const Mesh> ballSkin(double radius, int cells)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "ball";
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            addGrid(*mesh, cells, cells, [&](double u, double v) {
                glm::dvec3 d(0);
                d[axis] = side;
                d[(axis + 1) % 3] = std::tan((2 * u - 1) * pi / 4) * side;
                d[(axis + 2) % 3] = std::tan((2 * v - 1) * pi / 4);
                d = glm::normalize(d);
                return skinVertex(radius * d, d, 1 / radius);
            });
        }
    }
    boundIt(*mesh);
    return mesh;
}

std::shared_ptr<const Mesh> rollSkin(double radius, double halfLength, int segments)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "roll";
    const int quarter = std::max(segments / 4, 2);
    const int straight = std::max(static_cast<int>(std::lround(halfLength / radius * quarter)), 1);
    const int rows = 2 * quarter + straight;
    addGrid(*mesh, rows, segments, [&](double u, double v) {
        const int row = static_cast<int>(std::lround(u * rows));
        const bool onCap = row <= quarter || row >= quarter + straight;
        const double angle = row <= quarter ? 0.5 * pi * (1 - static_cast<double>(row) / quarter)
                                            : -0.5 * pi * std::max(row - quarter - straight, 0) / quarter;
        const double along =
            row <= quarter
                ? -halfLength
                : -halfLength + 2 * halfLength * std::min(static_cast<double>(row - quarter) / straight, 1.0);
        const double phi = 2 * pi * v;
        const bool pole = row == 0 || row == rows;
        const double ring = pole ? 0.0 : std::cos(angle);
        const glm::dvec3 n(-std::sin(angle), ring * std::cos(phi), ring * std::sin(phi));
        return skinVertex(radius * n + glm::dvec3(along, 0, 0), n, (onCap ? 1.0 : 0.5) / radius);
    });
    // Columns run along x, rows from y to z, so du × dv looks inwards.
    for (std::size_t i = 0; i + 2 < mesh->indices.size(); i += 3) std::swap(mesh->indices[i + 1], mesh->indices[i + 2]);
    boundIt(*mesh);
    return mesh;
}

std::shared_ptr<const Mesh> ringSkin(double radius, double tube, int segments)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "ring";
    addGrid(*mesh, segments / 2, segments, [&](double u, double v) {
        const double theta = 2 * pi * u;  // Around the tube.
        const double phi = 2 * pi * v;    // Around the ring.
        const glm::dvec3 out(std::cos(phi), 0, std::sin(phi));
        const glm::dvec3 n = out * std::cos(theta) + glm::dvec3(0, std::sin(theta), 0);
        const double curvature = 0.5 * (1 / tube + std::cos(theta) / (radius + tube * std::cos(theta)));
        return skinVertex(radius * out + tube * n, n, curvature);
    });
    boundIt(*mesh);
    return mesh;
}

int finRows(const Mesh& skin)
{
    // A closed skin has 1.5 times as many edges as triangles, and a row has two triangles on each edge.
    const std::size_t inOneRow = std::max<std::size_t>(skin.indices.size(), 1);
    return static_cast<int>(std::min<std::size_t>(600000 / inOneRow, 6));
}

std::shared_ptr<const Mesh> finsOf(const Mesh& skin, int rows)
{
    auto fins = std::make_shared<Mesh>();
    fins->name = skin.name + " fins";
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i + 2 < skin.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = skin.indices[i + k];
            const std::uint32_t b = skin.indices[i + (k + 1) % 3];
            if (!edges.insert({std::min(a, b), std::max(a, b)}).second) continue;
            addGrid(*fins, 1, rows, [&](double u, double v) {
                Vertex vertex = skin.vertices[u > 0.5 ? b : a];
                vertex.extra.y = static_cast<float>(v);
                return vertex;
            });
        }
    }
    fins->bounds = skin.bounds;
    return fins;
}

std::shared_ptr<const Mesh> diskMesh()
{
    static const std::shared_ptr<const Mesh> disk = [] {
        auto mesh = std::make_shared<Mesh>();
        mesh->name = "floor of the pit";
        addGrid(*mesh, 72, 30, [](double u, double v) {
            const double phi = -2 * pi * u;
            return skinVertex({v * std::cos(phi), 0, v * std::sin(phi)}, {0, 1, 0}, 0);
        });
        mesh->bounds = {{-1, 0, -1}, {1, 0, 1}};
        return mesh;
    }();
    return disk;
}

}  // namespace vitrine::fur
