#include "exhibits/hall/wall_frame.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace vitrine::hall {
namespace {

/// Adds a quad, counter-clockwise seen from its front, with the normal of its plane.
void addQuad(render::Mesh& mesh, const std::array<glm::dvec3, 4>& corners)
{
    const glm::dvec3 along = glm::normalize(corners[1] - corners[0]);
    const glm::dvec3 normal = glm::normalize(glm::cross(along, corners[2] - corners[0]));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 across = glm::cross(normal, along);
        mesh.vertices.push_back({glm::vec3(corner),
                                 glm::vec3(normal),
                                 glm::vec4(along, 1),
                                 {glm::dot(corner, along), glm::dot(corner, across)},
                                 {}});
        mesh.bounds.include(corner);
    }
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

/// Point of the profile: distance out of the opening's edge, and out of the wall.
struct ProfilePoint {
    double out, height;
};

}  // namespace

std::shared_ptr<const render::Mesh> frameMesh(const WallFrame& frame)
{
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "wall_frame";
    const double b = frame.border, d = frame.depth;
    const std::array<ProfilePoint, 7> profile{
        {{0, 0}, {0, 0.55 * d}, {0.15 * b, 0.7 * d}, {0.3 * b, 0.7 * d}, {0.55 * b, d}, {b, 0.75 * d}, {b, 0}}};
    const auto corner = [&](int which, const ProfilePoint& p) {
        const double x = frame.opening.x / 2 + p.out, y = frame.opening.y / 2 + p.out;
        constexpr std::array<glm::dvec2, 4> signs{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
        const glm::dvec2 at = signs[static_cast<std::size_t>(which % 4)] * glm::dvec2(x, y);
        return glm::dvec3(at, p.height);
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        for (int side = 0; side < 4; ++side)
            addQuad(*mesh, {corner(side, profile[i]), corner(side, profile[i + 1]), corner(side + 1, profile[i + 1]),
                            corner(side + 1, profile[i])});
    return mesh;
}

std::shared_ptr<const render::Mesh> panelMesh(const WallFrame& frame)
{
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "wall_frame_panel";
    const double x = frame.opening.x / 2, y = frame.opening.y / 2, z = 0.1 * frame.depth;
    addQuad(*mesh, {glm::dvec3(-x, -y, z), glm::dvec3(x, -y, z), glm::dvec3(x, y, z), glm::dvec3(-x, y, z)});
    return mesh;
}

glm::dmat4 plaqueBeside(const WallFrame& frame)
{
    // The plaque hangs like those beside the niches: 0.42 m from the border, tilted by 5 degrees towards the reader.
    const double right = frame.opening.x / 2 + frame.border + 0.42;
    const glm::dmat4 at = glm::translate(glm::dmat4(1), glm::dvec3(right, -0.25, 0.042));
    return glm::rotate(at, glm::radians(-5.0), glm::dvec3(1, 0, 0));
}

}  // namespace vitrine::hall
