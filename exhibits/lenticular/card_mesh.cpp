#include "exhibits/lenticular/card_mesh.h"

#include "exhibits/lenticular/card_sheet.h"

#include <cmath>
#include <numbers>

namespace vitrine::lenticular {
namespace {

constexpr double cornerRadius = 0.007;
constexpr double chamfer = 0.0007;
constexpr int perCorner = 8;

/// Closed line around the card: distance inside its outline, depth, and tilt of the normal.
struct Ring {
    double inset, z, outward, forward;
};

std::uint32_t addRing(render::Mesh& mesh, const Ring& ring)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double radius = cornerRadius - ring.inset;
    const glm::dvec3 normalShare = glm::normalize(glm::dvec3(ring.outward, ring.forward, 0));
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 sign(corner == 0 || corner == 3 ? 1 : -1, corner < 2 ? 1 : -1);
        const glm::dvec2 center = sign * (glm::dvec2(cardHalfSize) - cornerRadius);
        for (int i = 0; i <= perCorner; ++i) {
            const double angle = std::numbers::pi / 2 * (corner + static_cast<double>(i) / perCorner);
            const glm::dvec2 out(std::cos(angle), std::sin(angle));
            const glm::vec3 position(glm::dvec3(center + radius * out, ring.z));
            const glm::vec3 normal(glm::dvec3(out * normalShare.x, normalShare.y));
            mesh.vertices.push_back({position, normal, {1, 0, 0, 1}, glm::vec2(position) * 0.5F + 0.5F, {}});
        }
    }
    return first;
}

void addFace(render::Mesh& mesh, double z, double forward, std::uint32_t count)
{
    const std::uint32_t rim = addRing(mesh, {chamfer, z, 0, forward});
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(
        {{0, 0, static_cast<float>(z)}, {0, 0, static_cast<float>(forward)}, {1, 0, 0, 1}, {0.5F, 0.5F}, {}});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = rim + i;
        const std::uint32_t b = rim + (i + 1) % count;
        if (forward > 0)
            mesh.indices.insert(mesh.indices.end(), {middle, a, b});
        else
            mesh.indices.insert(mesh.indices.end(), {middle, b, a});
    }
}

/// Adds a band between a ring nearer to the front and one farther back.
void addBand(render::Mesh& mesh, const Ring& front, const Ring& back, std::uint32_t count)
{
    const std::uint32_t f = addRing(mesh, front);
    const std::uint32_t r = addRing(mesh, back);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        mesh.indices.insert(mesh.indices.end(), {f + i, r + i, r + next, f + i, r + next, f + next});
    }
}

std::shared_ptr<const render::Mesh> make()
{
    constexpr std::uint32_t count = 4 * (perCorner + 1);
    const double rear = -2 * cardHalfSize.z;
    auto mesh = std::make_shared<render::Mesh>();
    mesh->name = "lenticular card";
    addFace(*mesh, 0, 1, count);
    addBand(*mesh, {chamfer, 0, 1, 1}, {0, -chamfer, 1, 1}, count);
    addBand(*mesh, {0, -chamfer, 1, 0}, {0, rear + chamfer, 1, 0}, count);
    addBand(*mesh, {0, rear + chamfer, 1, -1}, {chamfer, rear, 1, -1}, count);
    addFace(*mesh, rear, -1, count);
    mesh->bounds = {glm::dvec3(-cardHalfSize.x, -cardHalfSize.y, rear), glm::dvec3(cardHalfSize.x, cardHalfSize.y, 0)};
    return mesh;
}

}  // namespace

std::shared_ptr<const render::Mesh> cardMesh()
{
    static const std::shared_ptr<const render::Mesh> mesh = make();
    return mesh;
}

}  // namespace vitrine::lenticular
