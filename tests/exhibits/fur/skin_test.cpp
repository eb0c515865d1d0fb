// Skins: closed, facing outward, and repaired if a visitor's model is broken.

#include "exhibits/fur/coat.h"
#include "exhibits/fur/coat_mesh.h"
#include "tests/support/failures.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::fur {
namespace {

using render::Mesh;

double volume(const Mesh& m)
{
    double sum = 0;
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return glm::dvec3(m.vertices[m.indices[i + k]].position); };
        sum += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    return sum;
}

TEST(Skins, EncloseWhatTheirFormulaSays)
{
    constexpr double pi = 3.14159265358979;
    // Inscribed polyhedra are a few percent smaller.
    const double ball = 4 * pi / 3 * 0.33 * 0.33 * 0.33;
    EXPECT_NEAR(volume(*ballSkin(0.33, 8)) / ball, 0.98, 0.02);
    const double roll = pi * 0.22 * 0.22 * 0.52 + 4 * pi / 3 * 0.22 * 0.22 * 0.22;
    EXPECT_NEAR(volume(*rollSkin(0.22, 0.26, 26)) / roll, 0.98, 0.02);
    const double ring = 2 * pi * pi * 0.35 * 0.15 * 0.15;
    EXPECT_NEAR(volume(*ringSkin(0.35, 0.15, 40)) / ring, 0.97, 0.03);
}

TEST(Skins, FaceOutwardsWithUnitNormals)
{
    for (const auto& skin : {ballSkin(0.33, 8), rollSkin(0.22, 0.26, 26), ringSkin(0.35, 0.15, 40)}) {
        for (std::size_t i = 0; i + 2 < skin->indices.size(); i += 3) {
            const auto& a = skin->vertices[skin->indices[i]];
            const auto& b = skin->vertices[skin->indices[i + 1]];
            const auto& c = skin->vertices[skin->indices[i + 2]];
            const glm::dvec3 across =
                glm::cross(glm::dvec3(b.position - a.position), glm::dvec3(c.position - a.position));
            EXPECT_NEAR(glm::length(glm::dvec3(a.normal)), 1, 1e-6);
            if (glm::length(across) > 1e-9) {
                EXPECT_GT(glm::dot(glm::normalize(across), glm::dvec3(a.normal)), 0.7) << skin->name;
            }
        }
    }
}

render::Model modelOf(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
                      const glm::dmat4& transform = glm::dmat4(1))
{
    auto mesh = std::make_shared<Mesh>();
    for (const glm::vec3& p : positions) mesh->vertices.push_back({p, glm::vec3(0), {}, {}, {}});
    mesh->indices = std::move(indices);
    render::Model model;
    for (const glm::vec3& p : positions) {
        mesh->bounds.include(glm::dvec3(p));
        model.bounds.include(glm::dvec3(transform * glm::dvec4(p, 1)));
    }
    model.parts.push_back({"part", mesh, nullptr, transform, glm::determinant(glm::dmat3(transform)) < 0});
    return model;
}

const std::vector<glm::vec3> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
const std::vector<std::uint32_t> tetrahedron{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};

TEST(ModelSkin, LeavesOutTrianglesWithoutAreaAndSaysSo)
{
    std::vector<std::uint32_t> indices = tetrahedron;
    indices.insert(indices.end(), {0, 0, 1, 2, 2, 2});
    std::vector<std::string> notes;
    const auto skin = modelSkin(modelOf(corners, indices), "x.glb", 0.5, notes);
    EXPECT_EQ(skin->indices.size(), 12U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0], "2 triangles without area were left out");
}

TEST(ModelSkin, FitsItsSphereAndHasFiniteUnitNormals)
{
    std::vector<std::string> notes;
    for (const glm::dmat4& m :
         {glm::dmat4(1), glm::scale(glm::dmat4(1), glm::dvec3(1e6)), glm::scale(glm::dmat4(1), glm::dvec3(3, 0.2, 1)),
          glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1))}) {
        const auto skin = modelSkin(modelOf(corners, tetrahedron, m), "x.glb", 0.5, notes);
        EXPECT_GT(volume(*skin), 0) << "mirrored parts must be turned back";
        for (const auto& v : skin->vertices) {
            EXPECT_LE(glm::length(v.position), 0.5001F);
            EXPECT_NEAR(glm::length(v.normal), 1, 1e-5);
            EXPECT_GT(glm::dot(v.normal, v.position), 0);
        }
    }
    EXPECT_TRUE(notes.empty());
}

TEST(ModelSkin, GivesBothSidesOfASheetAnOutwardSide)
{
    std::vector<std::string> notes;
    const auto skin = modelSkin(modelOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 1}), "x.glb", 0.5, notes);
    ASSERT_EQ(notes.size(), 1U);
    for (const auto& v : skin->vertices) EXPECT_NEAR(glm::length(v.normal), 1, 1e-5);
}

render::Model modelOf(const Mesh& mesh)
{
    std::vector<glm::vec3> positions;
    for (const auto& v : mesh.vertices) positions.push_back(v.position);
    return modelOf(std::move(positions), mesh.indices);
}

TEST(ModelSkin, OfABallBendsAsOneOverItsRadiusEverywhere)
{
    std::vector<std::string> notes;
    const auto skin = modelSkin(modelOf(*ballSkin(7, 8)), "ball.glb", 0.5, notes);
    // The radius is that of the sphere around its bounding box.
    const double radius = glm::length(skin->vertices[0].position);
    for (const auto& v : skin->vertices) EXPECT_NEAR(v.extra.x * radius, 1, 0.02);
}

TEST(ModelSkin, BendsAsTheFormulasOfRollAndRingSay)
{
    std::vector<std::string> notes;
    for (const auto& known : {rollSkin(0.22, 0.26, 26), ringSkin(0.35, 0.15, 40)}) {
        const auto skin = modelSkin(modelOf(*known), "known.glb", 1.0, notes);
        double reach = 0;
        for (const auto& v : skin->vertices) reach = std::max(reach, static_cast<double>(v.position.x));
        double knownReach = 0;
        for (const auto& v : known->vertices) knownReach = std::max(knownReach, static_cast<double>(v.position.x));
        const double scale = reach / knownReach;
        int compared = 0;
        for (const auto& v : skin->vertices) {
            const auto same = std::find_if(known->vertices.begin(), known->vertices.end(), [&](const auto& k) {
                return glm::length(glm::dvec3(v.position) - scale * glm::dvec3(k.position)) < 1e-4;
            });
            if (same == known->vertices.end()) continue;
            // The curvature jumps at the end of the cap; a mesh bridges this by one edge.
            if (known->name == "roll" && std::abs(std::abs(same->position.x) - 0.26) < 0.08) continue;
            EXPECT_NEAR(v.extra.x * scale, same->extra.x, 0.06 * same->extra.x + 0.06)
                << known->name << " at " << same->position.x << ", " << same->position.y;
            ++compared;
        }
        EXPECT_GT(compared, 300) << known->name;
    }
}

TEST(ModelSkin, DoesNotBendWhereItIsFlatOrHollow)
{
    std::vector<std::string> notes;
    const auto sheet =
        modelSkin(modelOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}), "sheet.glb", 0.5, notes);
    for (const auto& v : sheet->vertices) EXPECT_NEAR(v.extra.x, 0, 1e-5);
    Mesh hollow = *ballSkin(1, 6);
    for (std::size_t i = 0; i + 2 < hollow.indices.size(); i += 3)
        std::swap(hollow.indices[i + 1], hollow.indices[i + 2]);
    for (const auto& v : modelSkin(modelOf(hollow), "hollow.glb", 0.5, notes)->vertices) EXPECT_EQ(v.extra.x, 0);
}

TEST(Fins, HaveFewerRowsWhereThereAreManyEdges)
{
    const auto ball = ballSkin(0.33, 8);
    // A single surface: equal positions are one point.
    std::vector<std::string> notes;
    const auto closed = modelSkin(modelOf(*ball), "ball.glb", 0.5, notes);
    const std::size_t edges = closed->indices.size() / 2;
    EXPECT_EQ(finRows(*closed), 6);
    EXPECT_EQ(finsOf(*closed, 6)->indices.size(), edges * 6 * 6);
    Mesh large;
    large.indices.resize(3 * 60000);
    EXPECT_EQ(finRows(large), 3);
    large.indices.resize(3 * 300000);
    EXPECT_EQ(finRows(large), 0);
}

TEST(ModelSkin, OfNothingNamesTheFile)
{
    std::vector<std::string> notes;
    for (const render::Model& model : {render::Model{}, modelOf({{0, 0, 0}, {1, 0, 0}}, {0, 1, 1})})
        EXPECT_FAILURE(modelSkin(model, "bare.glb", 0.5, notes), "bare.glb");
}

TEST(Fins, StandOnEveryEdgeOnce)
{
    const auto skin = ballSkin(0.3, 4);
    const auto fins = finsOf(*skin, 3);
    std::map<float, int> heights;
    for (const auto& v : fins->vertices) ++heights[v.extra.y];
    EXPECT_EQ(heights.size(), 4U);
    // Each face of the cube has 40 edges of cells and 16 diagonals.
    EXPECT_EQ(fins->indices.size(), 6U * (40 + 16) * 3 * 2 * 3);
}

TEST(LevelOfDetail, FallsContinuouslyWithDistance)
{
    double last = shellsAtDistance(64, 0.2, 0.1, 0.002);
    EXPECT_EQ(last, 64);
    for (double d = 0.1; d < 50; d *= 1.01) {
        const double now = shellsAtDistance(64, 0.2, d, 0.002);
        EXPECT_LE(now, last);
        EXPECT_LT(last - now, 0.02 * last + 1e-9) << "a pop at " << d;
        last = now;
    }
    EXPECT_EQ(last, 5);
    EXPECT_EQ(shellsAtDistance(1, 0.2, 100, 0.002), 1);
    EXPECT_EQ(shellsAtDistance(3, 0, 1, 0.002), 3);
}

}  // namespace
}  // namespace vitrine::fur
