#include "exhibits/fur/coat_mesh.h"
#include "exhibits/kit/surface_draw.h"
#include "render/failure.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace vitrine::fur {
namespace {

using render::Mesh;
using render::Vertex;

/// Writes the mean curvature into the vertices: half the divergence of the normals, which are interpolated across each
/// triangle. A vertex gets the mean of its triangles, weighted by area. The result is exact on a sphere.
void bendIt(Mesh& mesh)
{
    std::vector<double> bend(mesh.vertices.size());
    std::vector<double> weight(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<glm::dvec3, 3> at, normal;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = glm::dvec3(mesh.vertices[mesh.indices[i + k]].position);
            normal[k] = glm::dvec3(mesh.vertices[mesh.indices[i + k]].normal);
        }
        const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
        const double area = glm::length(across);  // Twice the area of the triangle.
        if (!(area > 1e-14)) continue;
        double divergence = 0;
        for (std::size_t k = 0; k < 3; ++k)
            divergence += glm::dot(glm::cross(across, at[(k + 2) % 3] - at[(k + 1) % 3]), normal[k]) / (area * area);
        for (std::size_t k = 0; k < 3; ++k) {
            bend[mesh.indices[i + k]] += 0.5 * divergence * area;
            weight[mesh.indices[i + k]] += area;
        }
    }
    for (std::size_t i = 0; i < bend.size(); ++i)
        mesh.vertices[i].extra.x = weight[i] > 0 ? static_cast<float>(std::max(bend[i] / weight[i], 0.0)) : 0;
}

/// Builder of one skin from the triangles of all parts. Vertices at one place are merged, and their normal is that of
/// all faces around it.
class Sewing {
public:
    /// `radius` is that of the skin, meters.
    explicit Sewing(double radius) : grid_(radius * 1e-5) { mesh_->name = "model"; }

    void add(const std::array<glm::dvec3, 3>& at)
    {
        const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
        const double area = glm::length(across);
        if (!(area > 1e-14)) {
            ++flat_;
            return;
        }
        std::array<std::uint32_t, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k) corner[k] = place(at[k]);
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
            ++flat_;
            return;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = glm::normalize(at[(k + 1) % 3] - at[k]);
            const glm::dvec3 b = glm::normalize(at[(k + 2) % 3] - at[k]);
            normals_[corner[k]] += across / area * std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
        }
        mesh_->indices.insert(mesh_->indices.end(), corner.begin(), corner.end());
    }
    [[nodiscard]] bool empty() const { return mesh_->indices.empty(); }
    /// Returns the skin. No triangles may be added afterwards.
    [[nodiscard]] std::shared_ptr<const Mesh> finished(std::vector<std::string>& notes)
    {
        std::size_t without = 0;
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            const double length = glm::length(normals_[i]);
            if (!(length > 1e-9)) ++without;
            // If the faces cancel, as on both sides of a sheet, the normal points away from the center.
            const glm::vec3& p = mesh_->vertices[i].position;
            const double out = glm::length(glm::dvec3(p));
            mesh_->vertices[i].normal = length > 1e-9 ? glm::vec3(normals_[i] / length)
                                        : out > 0     ? p / static_cast<float>(out)
                                                      : glm::vec3(0, 1, 0);
        }
        if (flat_ > 0)
            notes.push_back(flat_ == 1 ? "1 triangle without area was left out"
                                       : std::to_string(flat_) + " triangles without area were left out");
        if (without > 0)
            notes.push_back(without == 1 ? "1 place had no outward side and was given one"
                                         : std::to_string(without) + " places had no outward side and were given one");
        for (const Vertex& v : mesh_->vertices) mesh_->bounds.include(glm::dvec3(v.position));
        bendIt(*mesh_);
        return mesh_;
    }

private:
    std::uint32_t place(const glm::dvec3& p)
    {
        const std::array<std::int64_t, 3> key{std::llround(p.x / grid_), std::llround(p.y / grid_),
                                              std::llround(p.z / grid_)};
        const auto [found, fresh] = places_.try_emplace(key, static_cast<std::uint32_t>(mesh_->vertices.size()));
        if (fresh) {
            mesh_->vertices.emplace_back().position = glm::vec3(p);
            normals_.emplace_back(0);
        }
        return found->second;
    }

    std::shared_ptr<Mesh> mesh_ = std::make_shared<Mesh>();
    std::map<std::array<std::int64_t, 3>, std::uint32_t> places_;
    std::vector<glm::dvec3> normals_;
    double grid_;  ///< Meters; vertices within the same cell of this size are merged.
    std::size_t flat_ = 0;
};

}  // namespace

std::shared_ptr<const Mesh> modelSkin(const render::Model& model, const std::string& file, double radius,
                                      std::vector<std::string>& notes)
{
    const glm::dvec3 center = model.bounds.empty() ? glm::dvec3(0) : model.bounds.center();
    const double extent = model.bounds.empty() ? 0 : glm::length(model.bounds.halfSize());
    if (!(extent > 0))
        throw Failure(ErrorKind::file, file + " has no surface that could wear a coat. Give a model with triangles.");
    Sewing sewing(radius);
    for (const render::MeshInstance& part : model.parts) {
        const bool mirrored = isMirrored(part.modelFromPart);
        for (std::size_t i = 0; i + 2 < part.mesh->indices.size(); i += 3) {
            std::array<glm::dvec3, 3> at;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t source = mirrored ? 2 - k : k;
                const glm::vec3& p = part.mesh->vertices[part.mesh->indices[i + source]].position;
                at[k] = (glm::dvec3(part.modelFromPart * glm::dvec4(p, 1)) - center) * (radius / extent);
            }
            sewing.add(at);
        }
    }
    if (sewing.empty())
        throw Failure(ErrorKind::file,
                      file + " has no triangle with an area that could wear a coat. Give a model with triangles.");
    return sewing.finished(notes);
}

double meanRadius(const Mesh& mesh)
{
    double sum = 0;
    for (const Vertex& v : mesh.vertices) sum += glm::length(glm::dvec3(v.position));
    return mesh.vertices.empty() ? 0 : sum / static_cast<double>(mesh.vertices.size());
}

}  // namespace vitrine::fur
