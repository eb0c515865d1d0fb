// Vertex data of glTF files, and cases in which it has no effect.

#include "render/scene/gltf.h"
#include "tests/render/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::render {
namespace {

using test::GltfBuilder;

TEST(GltfVertices, ReadsColorsOfVerticesOfEveryType)
{
    constexpr int byte = 5121, word = 5123, real = 5126;
    struct Case {
        int type;
        const char* shape;
        bool normalized;
        std::string bytes;
        int stride;
    };
    const auto words = [](const std::vector<std::uint16_t>& all) {
        return std::string(reinterpret_cast<const char*>(all.data()), 2 * all.size());
    };
    const auto reals = [](const std::vector<float>& all) {
        return std::string(reinterpret_cast<const char*>(all.data()), 4 * all.size());
    };
    using namespace std::string_literals;
    // Three vertices of color (1, 0.2, 0), with and without an opacity of 0.6.
    const std::vector<Case> cases{
        {byte, "VEC3", true, "\xff\x33\0 \xff\x33\0 \xff\x33\0 "s, 4},
        {byte, "VEC4", true, "\xff\x33\0\x99\xff\x33\0\x99\xff\x33\0\x99"s, 0},
        {byte, "VEC4", false, "\xff\x33\0\x99\xff\x33\0\x99\xff\x33\0\x99"s, 0},
        {word, "VEC3", true, words({65535, 13107, 0, 9, 65535, 13107, 0, 9, 65535, 13107, 0, 9}), 8},
        {word, "VEC4", true, words({65535, 13107, 0, 39321, 65535, 13107, 0, 39321, 65535, 13107, 0, 39321}), 0},
        {real, "VEC3", false, reals({1, 0.2F, 0, 1, 0.2F, 0, 1, 0.2F, 0}), 0},
        {real, "VEC4", false, reals({1, 0.2F, 0, 0.6F, 1, 0.2F, 0, 0.6F, 1, 0.2F, 0, 0.6F}), 0}};
    for (const bool flat : {false, true})
        for (const Case& c : cases) {
            GltfBuilder builder;
            const int mesh = builder.triangle();
            Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
            if (!flat) attributes["NORMAL"] = builder.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
            const int view = builder.view(c.bytes);
            if (c.stride > 0) builder.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = c.stride;
            attributes["COLOR_0"] = builder.json["accessors"].size();
            builder.json["accessors"].push_back({{"bufferView", view},
                                                 {"componentType", c.type},
                                                 {"normalized", c.normalized},
                                                 {"count", 3U},
                                                 {"type", c.shape}});
            builder.node({{"mesh", mesh}});
            const Model model = parseGltf(builder.glb(), "model.glb");
            EXPECT_TRUE(model.warnings.empty());
            const Mesh& drawn = *model.parts.at(0).mesh;
            ASSERT_EQ(drawn.colors.size(), drawn.vertices.size());
            const float opacity = c.shape[3] == '4' ? 0.6F : 1.0F;
            for (const glm::vec4& color : drawn.colors)
                EXPECT_LT(glm::distance(color, glm::vec4(1, 0.2F, 0, opacity)), 1e-5F) << c.type << c.shape;
        }
}

TEST(GltfVertices, DropsVerticesThatNoTriangleHas)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["attributes"].erase("TEXCOORD_0");
    primitive["attributes"]["POSITION"] = builder.floats({90, 0, 0, 0, 0, 0, 0, 80, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    primitive["indices"] = builder.indices({1, 3, 4});
    builder.node({{"mesh", mesh}});
    const Model model = parseGltf(builder.glb(), "model.glb");
    EXPECT_EQ(model.parts.at(0).mesh->vertices.size(), 3U);
    EXPECT_EQ(model.bounds.high, glm::dvec3(1, 1, 0));
}

TEST(GltfVertices, SaysWhereNothingOfItIsSeen)
{
    EXPECT_NE(whyNothingIsSeen("a.glb", {}).english().find("a.glb"), std::string::npos);
    EXPECT_NE(whyNothingIsSeen("a.glb", {}).english().find("no triangles"), std::string::npos);
    EXPECT_NE(whyNothingIsSeen("a.glb", {{1, 1, 1}, {1, 1, 1}}).english().find("point"), std::string::npos);
    EXPECT_NE(whyNothingIsSeen("a.glb", {{1, 1, 1}, {1, 2, 1}}).english().find("line"), std::string::npos);
    EXPECT_EQ(whyNothingIsSeen("a.glb", {{1, 1, 1}, {1, 2, 3}}), "");
}

}  // namespace
}  // namespace vitrine::render
