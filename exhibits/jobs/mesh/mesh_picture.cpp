#include "exhibits/jobs/mesh/mesh_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace vitrine::jobs {
namespace mesh_picture {
namespace {

constexpr double margin = 0.04;     // Share of the picture around the mesh.
constexpr double edgeWidth = 0.7;   // Half the width of an edge, in pixels.
constexpr double leastFace = 40;    // Mean size of a triangle from which edges are drawn, in square pixels.
constexpr double edgeLight = 0.35;  // Light of an edge relative to the face.
constexpr double ambientLight = 0.2;

/// Vertex on the picture.
struct Corner {
    glm::dvec3 place;  ///< Pixels from the upper left corner; z grows toward the eye.
    glm::dvec3 light;
};

/// Rasterizer of triangles with a depth buffer.
class Raster {
public:
    Raster(const glm::ivec2& size, bool hasEdges)
        : picture_(size.x, size.y, 4), hasEdges_(hasEdges),
          depth_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                 -std::numeric_limits<double>::infinity())
    {
    }

    /// Draws a triangle; those that show their back are left out.
    void draw(const std::array<Corner, 3>& corners)
    {
        const auto at = [&](std::size_t i) { return glm::dvec2(corners.at(i % 3).place); };
        const auto twice = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
        const double area = twice(at(2) - at(0), at(1) - at(0));  // Rows go down.
        if (!(area > 0)) return;
        const glm::dvec2 low = glm::min(glm::min(at(0), at(1)), at(2)), high = glm::max(glm::max(at(0), at(1)), at(2));
        const glm::ivec2 last(picture_.width - 1, picture_.height - 1);
        const glm::ivec2 from = glm::max(glm::ivec2(glm::floor(low)), glm::ivec2(0));
        const glm::ivec2 to = glm::min(glm::ivec2(glm::floor(high)), last);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                glm::dvec3 part;
                bool isEdge = false;
                for (std::size_t i = 0; i < 3; ++i) {
                    const glm::dvec2 side = at(i + 2) - at(i + 1);
                    const double across = twice(p - at(i + 1), side);
                    part[static_cast<int>(i)] = across / area;
                    isEdge = isEdge || across < edgeWidth * glm::length(side);
                }
                if (part.x >= 0 && part.y >= 0 && part.z >= 0) set(x, y, corners, part, isEdge && hasEdges_);
            }
    }
    [[nodiscard]] render::Image take() { return std::move(picture_); }

private:
    void set(int x, int y, const std::array<Corner, 3>& corners, const glm::dvec3& part, bool isEdge)
    {
        glm::dvec3 light(0);
        double depth = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            light += part[static_cast<int>(i)] * corners.at(i).light;
            depth += part[static_cast<int>(i)] * corners.at(i).place.z;
        }
        double& nearest = depth_[picture_.index(x, y) / 4];
        if (depth <= nearest) return;
        nearest = depth;
        for (int c = 0; c < 3; ++c) picture_.at(x, y, c) = static_cast<float>(light[c] * (isEdge ? edgeLight : 1));
        picture_.at(x, y, 3) = 1;
    }

    render::Image picture_;
    bool hasEdges_;
    std::vector<double> depth_;
};

/// Places the vertices on a picture of this size.
std::vector<Corner> cornersOf(const scenes::SceneMesh& mesh, const glm::dvec3& towards, const glm::dvec3& above,
                              const glm::dvec2& size)
{
    const glm::dvec3 toEye = glm::normalize(towards);
    const glm::dvec3 right = glm::normalize(glm::cross(above, toEye)), up = glm::cross(toEye, right);
    const glm::dvec3 toLight = glm::normalize(0.6 * toEye + 0.7 * up - 0.4 * right);
    std::vector<Corner> corners;
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const scenes::MeshVertex& vertex : mesh.vertices) {
        const glm::dvec3 p(vertex.position);
        const double facing = std::max(glm::dot(glm::dvec3(vertex.normal), toLight), 0.0);
        corners.push_back({{glm::dot(p, right), -glm::dot(p, up), glm::dot(p, toEye)},
                           glm::dvec3(vertex.color) * (ambientLight + (1 - ambientLight) * facing)});
        low = glm::min(low, glm::dvec2(corners.back().place));
        high = glm::max(high, glm::dvec2(corners.back().place));
    }
    const glm::dvec2 extent = glm::max(high - low, glm::dvec2(1e-12)), room = size * (1 - 2 * margin);
    const double scale = std::min(room.x / extent.x, room.y / extent.y);
    for (Corner& corner : corners)
        corner.place = glm::dvec3(0.5 * size + scale * (glm::dvec2(corner.place) - 0.5 * (low + high)), corner.place.z);
    return corners;
}

}  // namespace
}  // namespace mesh_picture

render::Image meshPicture(const scenes::SceneMesh& mesh, const glm::dvec3& toEye, const glm::dvec3& up,
                          const glm::ivec2& size)
{
    using namespace mesh_picture;
    const std::vector<Corner> corners = cornersOf(mesh, toEye, up, size);
    double area = 0;
    const auto triangle = [&](std::size_t first) {
        return std::array{corners[mesh.indices[first]], corners[mesh.indices[first + 1]],
                          corners[mesh.indices[first + 2]]};
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto [a, b, c] = triangle(i);
        const glm::dvec2 ab(b.place - a.place), ac(c.place - a.place);
        area += std::abs(ab.x * ac.y - ab.y * ac.x) / 2;
    }
    const double triangles = static_cast<double>(std::max<std::size_t>(mesh.indices.size() / 3, 1));
    Raster raster(size, area / triangles >= leastFace);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) raster.draw(triangle(i));
    return raster.take();
}

}  // namespace vitrine::jobs
