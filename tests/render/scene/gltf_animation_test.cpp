// Animations, skins and morph targets of glTF files, compared with values computed by hand.

#include "render/scene/gltf_animation.h"

#include "tests/render/scene/gltf_builder.h"
#include "tests/support/failures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using test::GltfBuilder;

AnimatedModel animatedModelOf(const GltfBuilder& builder)
{
    return AnimatedModel::parse(builder.glb(), "model.glb");
}

/// Adds a channel to animation 0.
/// Sampler of an animation.
struct Keys {
    std::vector<float> times, values;
    const char* type;
    const char* interpolation = "LINEAR";
};

void animate(GltfBuilder& b, int node, const char* path, const Keys& keys)
{
    Json sampler = {{"input", b.floats(keys.times, "SCALAR")},
                    {"output", b.floats(keys.values, keys.type)},
                    {"interpolation", keys.interpolation}};
    if (!b.json.contains("animations"))
        b.json["animations"] =
            Json::array({{{"name", "walk"}, {"channels", Json::array()}, {"samplers", Json::array()}}});
    Json& animation = b.json["animations"][0];
    animation["samplers"].push_back(sampler);
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", static_cast<unsigned>(node)}, {"path", path}}}});
}

glm::dvec3 corner(const Model& model, std::size_t i)
{
    const MeshInstance& part = model.parts.at(0);
    return glm::dvec3(part.modelFromPart * glm::dvec4(glm::dvec3(part.mesh->vertices.at(i).position), 1));
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b)
{
    EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' '
                                         << b.z;
}

TEST(GltfAnimation, MovesTurnsAndScalesNodesBetweenTheirKeys)
{
    GltfBuilder b;
    const int node = b.node({{"mesh", b.triangle()}});
    animate(b, node, "translation", {{0, 2}, {0, 0, 0, 4, 0, 0}, "VEC3"});
    const float half = static_cast<float>(std::sqrt(0.5));
    animate(b, node, "rotation", {{0, 2}, {0, 0, 0, 1, 0, 0, half, half}, "VEC4"});
    const AnimatedModel model = animatedModelOf(b);
    ASSERT_EQ(model.animations().size(), 1U);
    EXPECT_EQ(model.animations()[0].name, "walk");
    EXPECT_EQ(model.animations()[0].duration, 2);
    expectNear(corner(model.posed(-1, 1), 1), {1, 0, 0});
    expectNear(corner(model.posed(0, -5), 1), {1, 0, 0});
    const double c = std::cos(std::numbers::pi / 4);
    expectNear(corner(model.posed(0, 1), 1), {2 + c, c, 0});
    expectNear(corner(model.posed(0, 7), 1), {4, 1, 0});
}

TEST(GltfAnimation, StepsHoldAndCubicSplinesFollowHermite)
{
    GltfBuilder b;
    const int node = b.node({{"mesh", b.triangle()}});
    animate(b, node, "scale", {{0, 1}, {1, 1, 1, 3, 3, 3}, "VEC3", "STEP"});
    // In-tangent, value and out-tangent of each key.
    animate(b, node, "translation",
            {{0, 2}, {0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 6, 0, 1, 0, 0, 0, 0, 0}, "VEC3", "CUBICSPLINE"});
    const AnimatedModel model = animatedModelOf(b);
    expectNear(corner(model.posed(0, 0.99), 1) - corner(model.posed(0, 0.99), 0), {1, 0, 0});
    expectNear(corner(model.posed(0, 1), 1) - corner(model.posed(0, 1), 0), {3, 0, 0});
    // At t = 0.5: (p0 + p1) / 2 + span (m0 - m1) / 8.
    expectNear(corner(model.posed(0, 1), 0), {0.5 + 2 * 3.0 / 8, 2 * -6.0 / 8, 0});
}

/// Returns a triangle whose second corner follows a joint at (1, 0, 0), and whose third corner is influenced by two
/// joints.
GltfBuilder skinned()
{
    GltfBuilder b;
    const int mesh = b.triangle();
    Json& attributes = b.json["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0]["attributes"];
    const std::uint8_t joints[] = {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    b.json["accessors"].push_back({{"bufferView", b.view({reinterpret_cast<const char*>(joints), sizeof joints})},
                                   {"componentType", 5121},
                                   {"count", 3U},
                                   {"type", "VEC4"}});
    attributes["JOINTS_0"] = b.json["accessors"].size() - 1;
    attributes["WEIGHTS_0"] = b.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, "VEC4");
    std::vector<float> rest;
    for (const float x : {0.0F, -1.0F}) rest.insert(rest.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1});
    std::string bytes(rest.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), rest.data(), bytes.size());
    b.json["accessors"].push_back(
        {{"bufferView", b.view(bytes)}, {"componentType", 5126}, {"count", 2U}, {"type", "MAT4"}});
    const std::size_t inverse = b.json["accessors"].size() - 1;
    const int root = b.node({{"name", "root"}});
    const int tip = b.node({{"name", "tip"}, {"translation", {1, 0, 0}}});
    b.json["skins"] = Json::array(
        {{{"joints", {static_cast<unsigned>(root), static_cast<unsigned>(tip)}}, {"inverseBindMatrices", inverse}}});
    // The transform of the skinned node itself is ignored.
    b.node({{"mesh", mesh}, {"skin", 0U}, {"translation", {9, 9, 9}}});
    animate(b, tip, "translation", {{0, 1}, {1, 0, 0, 1, 0, 2}, "VEC3"});
    return b;
}

TEST(GltfAnimation, SkinsFollowTheirJointsAndNotTheirNode)
{
    const AnimatedModel model = animatedModelOf(skinned());
    for (std::size_t i = 0; i < 3; ++i)
        expectNear(corner(model.posed(-1, 0), i), std::array<glm::dvec3, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}.at(i));
    const Model bent = model.posed(0, 1);
    expectNear(corner(bent, 0), {0, 0, 0});
    expectNear(corner(bent, 1), {1, 0, 2});
    expectNear(corner(bent, 2), {0, 1, 1});
    for (const Vertex& v : bent.parts[0].mesh->vertices) EXPECT_NEAR(glm::length(v.normal), 1, 1e-5);
}

/// The second half of the third corner's weight is in the second set of joints.
TEST(GltfAnimation, SkinsHaveEightJointsAVertexAndNameWhatIsBeyond)
{
    GltfBuilder b = skinned();
    Json& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
    const std::uint8_t second[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    b.json["accessors"].push_back({{"bufferView", b.view({reinterpret_cast<const char*>(second), sizeof second})},
                                   {"componentType", 5121},
                                   {"count", 3U},
                                   {"type", "VEC4"}});
    const std::size_t joints = b.json["accessors"].size() - 1;
    attributes["WEIGHTS_0"] = b.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0, 0, 0}, "VEC4");
    attributes["JOINTS_1"] = joints;
    attributes["WEIGHTS_1"] = b.floats({0, 0, 0, 0, 0, 0, 0, 0, 0.5F, 0, 0, 0}, "VEC4");
    const Model bent = animatedModelOf(b).posed(0, 1);
    EXPECT_TRUE(bent.warnings.empty());
    expectNear(corner(bent, 1), {1, 0, 2});
    expectNear(corner(bent, 2), {0, 1, 1});
    attributes["JOINTS_2"] = joints;
    const Model more = animatedModelOf(b).posed(0, 1);
    ASSERT_EQ(more.warnings.size(), 1U);
    EXPECT_NE(more.warnings.front().english().find("JOINTS_2"), std::string::npos);
}

TEST(GltfAnimation, MorphTargetsAreAddedByTheirWeights)
{
    GltfBuilder b;
    const int mesh = b.triangle();
    Json& json = b.json["meshes"][static_cast<std::size_t>(mesh)];
    json["primitives"][0]["targets"] = Json::array({{{"POSITION", b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}},
                                                    {{"POSITION", b.floats({2, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3")}}});
    json["weights"] = {0.5, 0.0};
    const int node = b.node({{"mesh", mesh}});
    animate(b, node, "weights", {{0, 1}, {0, 0, 1, 1}, "SCALAR"});
    const AnimatedModel model = animatedModelOf(b);
    expectNear(corner(model.posed(-1, 0), 0), {0, 0, 0.5});
    expectNear(corner(model.posed(0, 0.5), 0), {1, 0, 0.5});
    expectNear(corner(model.posed(0, 1), 0), {2, 0, 1});
    // A file without normals gets flat ones, from the deformed shape: this one has turned over.
    EXPECT_LT(glm::distance(model.posed(0, 1).parts[0].mesh->vertices[0].normal, glm::vec3(0, 0, -1)), 1e-5);
}

TEST(GltfAnimation, WhatNamesNothingIsAFailureAndNotACrash)
{
    const auto posed = [](const auto& breakIt) {
        GltfBuilder b = skinned();
        breakIt(b.json);
        return animatedModelOf(b).posed(0, 0.5);
    };
    EXPECT_FAILURE(posed([](Json& j) { j["animations"][0]["channels"][0]["sampler"] = 7U; }), "sampler");
    EXPECT_FAILURE(posed([](Json& j) { j["animations"][0]["channels"][0]["target"]["node"] = 70U; }), "node");
    EXPECT_FAILURE(posed([](Json& j) { j["animations"][0]["samplers"][0]["output"] = 700U; }), "output");
    EXPECT_FAILURE(posed([](Json& j) { j["animations"][0]["samplers"][0]["input"] = 0U; }), "animations[0]");
    EXPECT_FAILURE(posed([](Json& j) { j["skins"][0]["joints"][0] = 99U; }), "joints");
    EXPECT_FAILURE(posed([](Json& j) { j["skins"][0]["inverseBindMatrices"] = 0U; }), "inverseBindMatrices");
    EXPECT_FAILURE(posed([](Json& j) { j["nodes"][2]["skin"] = 4U; }), "skin");
    EXPECT_FAILURE(posed([](Json& j) { j["animations"][0].erase("samplers"); }), "samplers");
    EXPECT_FAILURE(posed([](Json& j) { j["animations"] = 3; }), "animations");
    // A morph target without accessors moves nothing.
    const Model model = posed([](Json& j) {
        j["meshes"][0]["primitives"][0]["targets"] = Json::array({{{"POSITION", 900}}});
        j["meshes"][0]["weights"] = {1.0};
    });
    expectNear(corner(model, 0), {0, 0, 0});
}

}  // namespace
