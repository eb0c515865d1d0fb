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

/// PNG of one pixel.
constexpr const char* onePixel = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJ"
                                 "RU5ErkJggg==";

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

/// Returns a triangle with the two sets of texture coordinates `first` and `second` at its second corner, and the given
/// material. `picture` is what all its textures show.
Model placed(const glm::vec2& first, const glm::vec2& second, const char* material)
{
    test::GltfBuilder builder;
    builder.json["images"] = Json::array({Json{{"uri", "data:image/png;base64," + std::string(onePixel)}}});
    builder.json["textures"] = Json::parse(R"([{"source": 0}])");
    builder.json["materials"] = Json::array({Json::parse(material)});
    const int mesh = builder.triangle();
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_0"] = builder.floats({0, 0, first.x, first.y, 0, 1}, "VEC2");
    primitive["attributes"]["TEXCOORD_1"] = builder.floats({0, 0, second.x, second.y, 0, 1}, "VEC2");
    builder.node({{"mesh", mesh}});
    return parseGltf(builder.glb(), "model.glb");
}

TEST(GltfVertices, PlacesPicturesAsTheExtensionDoesInItsExamples)
{
    const auto uvOf = [](const glm::vec2& uv, const std::string& transform) {
        const Model model =
            placed(uv, {},
                   (R"({"emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform": )" + transform + "}}}")
                       .c_str());
        EXPECT_TRUE(model.warnings.empty());
        return model.parts.at(0).mesh->vertices.at(1).uv;
    };
    // The lower left quadrant of the picture, turned clockwise by 90 degrees (the extension's first example). The upper
    // left corner of the surface shows the lower left corner of the picture, and its upper right corner the upper left
    // corner of the quadrant.
    const std::string quadrant = R"({"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]})";
    EXPECT_LT(glm::distance(uvOf({0, 0}, quadrant), glm::vec2(0, 1)), 1e-6F);
    EXPECT_LT(glm::distance(uvOf({1, 0}, quadrant), glm::vec2(0, 0.5)), 1e-6F);
    EXPECT_LT(glm::distance(uvOf({1, 1}, quadrant), glm::vec2(0.5, 0.5)), 1e-6F);
    // An inverted T axis (its second example).
    EXPECT_EQ(uvOf({0.25, 0.25}, R"({"offset": [0, 1], "scale": [1, -1]})"), glm::vec2(0.25, 0.75));
    // Scaled first, then turned.
    EXPECT_LT(glm::distance(uvOf({1, 0}, R"({"rotation": 1.57079632679, "scale": [4, 2]})"), glm::vec2(0, -4)), 1e-6F);
    // Members of a wrong type count as left out.
    EXPECT_EQ(uvOf({0.25, 0.5}, R"({"offset": "no", "rotation": [], "scale": [1, 2, 3]})"), glm::vec2(0.25, 0.5));
}

TEST(GltfVertices, KeepsTwoPlacesOfPicturesAndNamesAThird)
{
    const glm::vec2 first(0.1, 0.2), second(0.3, 0.4);
    const auto check = [&](const char* material, const glm::vec2& uv, const glm::vec2& extra, bool base,
                           bool occlusion) {
        const Model model = placed(first, second, material);
        EXPECT_EQ(model.parts.at(0).mesh->vertices.at(1).uv, uv) << material;
        EXPECT_EQ(model.parts.at(0).mesh->vertices.at(1).extra, extra) << material;
        EXPECT_EQ(model.parts.at(0).material->onExtra.baseColor, base) << material;
        EXPECT_EQ(model.parts.at(0).material->onExtra.occlusion, occlusion) << material;
        return model.warnings;
    };
    EXPECT_TRUE(
        check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})", first, second, false, false).empty());
    EXPECT_TRUE(check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}})", second, second,
                      false, false)
                    .empty());
    EXPECT_TRUE(check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                          "occlusionTexture": {"index": 0, "texCoord": 1}})",
                      first, second, false, true)
                    .empty());
    // Tangents belong to the coordinates of the normal map.
    EXPECT_TRUE(check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                          "normalTexture": {"index": 0, "texCoord": 1}})",
                      second, first, true, false)
                    .empty());
    // The extension's set counts, if it has one.
    EXPECT_TRUE(check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
                          {"KHR_texture_transform": {"texCoord": 1, "offset": [1, 1]}}}}})",
                      second + 1.0F, second, false, false)
                    .empty());
    const auto warnings = check(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                                    "occlusionTexture": {"index": 0, "texCoord": 1},
                                    "emissiveTexture": {"index": 0, "texCoord": 7, "extensions":
                                    {"KHR_texture_transform": {"offset": [1, 1]}}}})",
                                first, second, false, true);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings.at(0).english().find("after the second set"), std::string::npos);
    EXPECT_NE(warnings.at(1).english().find("more than two different transforms"), std::string::npos);
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
