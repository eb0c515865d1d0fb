#include "render/scene/mesh_shading.h"

#include <cmath>

namespace vitrine::render {
namespace {

glm::dvec3 anyPerpendicular(const glm::dvec3& n)
{
    const glm::dvec3 axis = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(axis - n * glm::dot(n, axis));
}

}  // namespace

void keepUsedVertices(Mesh& mesh)
{
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const std::uint32_t i : mesh.indices) used[i] = 1;
    std::vector<std::uint32_t> place(used.size());
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i] == 0) continue;
        place[i] = kept;
        mesh.vertices[kept] = mesh.vertices[i];
        if (!mesh.colors.empty()) mesh.colors[kept] = mesh.colors[i];
        ++kept;
    }
    if (kept == used.size()) return;
    mesh.vertices.resize(kept);
    if (!mesh.colors.empty()) mesh.colors.resize(kept);
    for (std::uint32_t& i : mesh.indices) i = place[i];
}

void makeFlatNormals(Mesh& mesh)
{
    std::vector<Vertex> vertices;
    std::vector<glm::vec4> colors;
    vertices.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.vertices[mesh.indices[i]].position;
        const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].position;
        const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].position;
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            Vertex vertex = mesh.vertices[mesh.indices[i + k]];
            vertex.normal = length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 1, 0);
            vertices.push_back(vertex);
            if (!mesh.colors.empty()) colors.push_back(mesh.colors[mesh.indices[i + k]]);
        }
    }
    mesh.vertices = std::move(vertices);
    mesh.colors = std::move(colors);
    mesh.indices.resize(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = static_cast<std::uint32_t>(i);
}

void makeTangents(Mesh& mesh)
{
    struct Sum {
        glm::dvec3 alongU{0};
        glm::dvec3 alongV{0};
    };
    std::vector<Sum> sums(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::dvec3 ab = glm::dvec3(b.position) - glm::dvec3(a.position);
        const glm::dvec3 ac = glm::dvec3(c.position) - glm::dvec3(a.position);
        const glm::dvec2 uvAb = glm::dvec2(b.uv) - glm::dvec2(a.uv);
        const glm::dvec2 uvAc = glm::dvec2(c.uv) - glm::dvec2(a.uv);
        const double chart = uvAb.x * uvAc.y - uvAc.x * uvAb.y;  // Twice the area in texture space.
        const double area = glm::length(glm::cross(ab, ac));
        if (chart == 0 || area == 0) continue;
        const double sign = chart < 0 ? -1 : 1;
        const glm::dvec3 alongU = sign * (ab * uvAc.y - ac * uvAb.y);
        const glm::dvec3 alongV = sign * (ac * uvAb.x - ab * uvAc.x);
        const double lengthU = glm::length(alongU);
        const double lengthV = glm::length(alongV);
        for (std::size_t k = 0; k < 3; ++k) {
            Sum& sum = sums[mesh.indices[i + k]];
            if (lengthU > 0) sum.alongU += alongU * (area / lengthU);
            if (lengthV > 0) sum.alongV += alongV * (area / lengthV);
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        const glm::dvec3 n = vertex.normal;
        const glm::dvec3 inPlane = sums[i].alongU - n * glm::dot(n, sums[i].alongU);
        const double length = glm::length(inPlane);
        const glm::dvec3 tangent = length > 0 ? inPlane / length : anyPerpendicular(n);
        // Green in a normal map points up in the picture and v points down, so the bitangent is along -v.
        const double sign = glm::dot(glm::cross(n, tangent), sums[i].alongV) > 0 ? -1 : 1;
        vertex.tangent = glm::vec4(glm::vec3(tangent), static_cast<float>(sign));
    }
}

}  // namespace vitrine::render
