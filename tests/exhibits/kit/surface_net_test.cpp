// Mesh of a field, compared with closed forms of a sphere.

#include "exhibits/kit/surface_net.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <utility>

namespace vitrine {
namespace {

constexpr double radius = 0.3;
const glm::dvec3 middle(0.1, -0.2, 0.05);

std::shared_ptr<const render::Mesh> ball(int cells)
{
    return surfaceNet([](const glm::dvec3& p) { return glm::length(p - middle) - radius; },
                      {middle - radius, middle + radius}, cells, "ball");
}

double volumeOf(const render::Mesh& mesh)
{
    double six = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        six += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    return six / 6;
}

TEST(SurfaceNet, OfASphereLiesOnItWithItsNormals)
{
    const auto mesh = ball(16);
    ASSERT_GT(mesh->vertices.size(), 500U);
    for (const render::Vertex& v : mesh->vertices) {
        const glm::dvec3 out = glm::dvec3(v.position) - middle;
        EXPECT_NEAR(glm::length(out), radius, 1e-5);
        EXPECT_GT(glm::dot(glm::dvec3(v.normal), glm::normalize(out)), 0.999999);
    }
}

TEST(SurfaceNet, IsClosedAndFacesOutward)
{
    const auto mesh = ball(16);
    // Every edge belongs to two triangles, which contain it in opposite directions.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh->indices[i + k], mesh->indices[i + (k + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_GT(volumeOf(*mesh), 0);
}

TEST(SurfaceNet, HoldsTheVolumeOfTheSphereTheBetterTheFinerItIs)
{
    const double whole = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    const double coarse = whole - volumeOf(*ball(16));
    const double fine = whole - volumeOf(*ball(32));
    // Flat facets between points of the sphere miss a slice whose height is proportional to the square of the cell.
    EXPECT_GT(coarse, 0);
    EXPECT_NEAR(coarse / fine, 4, 0.5);
}

}  // namespace
}  // namespace vitrine
