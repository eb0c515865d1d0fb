#include "render/scene/gltf.h"

#include "render/image/image_io.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using namespace test;

Model modelOf(const GltfBuilder& builder)
{
    return parseGltf(builder.glb(), "model.glb");
}

bool warnsOf(const Model& model, const std::string& part)
{
    return std::any_of(model.warnings.begin(), model.warnings.end(),
                       [&](const Message& w) { return w.english().find(part) != std::string::npos; });
}

std::string smallPng()
{
    const TemporaryFolder folder;
    Image image(2, 2, 3, 1);
    writePicture(folder / "a.png", image, PictureFormat::png8);
    return test::bytesOf(folder / "a.png");
}

/// Returns a triangle whose material uses `picture` (an image object) as base color and as normal map.
GltfBuilder textured(const Json& picture)
{
    GltfBuilder builder;
    builder.json["images"] = Json::array({picture});
    builder.json["textures"] = Json::parse(R"([{"source": 0}])");
    builder.json["materials"] = Json::parse(
        R"([{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "normalTexture": {"index": 0}}])");
    builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.node({{"name", "thing"}, {"mesh", 0}});
    return builder;
}

TEST(Gltf, ReadsATriangleFromBothKindsOfFile)
{
    GltfBuilder builder;
    builder.node({{"name", "thing"}, {"mesh", builder.triangle()}});
    for (const std::string& bytes : {builder.glb(), builder.text()}) {
        const Model model = parseGltf(bytes, "model");
        ASSERT_EQ(model.parts.size(), 1U);
        EXPECT_EQ(model.parts[0].name, "thing");
        const Mesh& mesh = *model.parts[0].mesh;
        EXPECT_EQ(mesh.name, "triangle");
        EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
        EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
        EXPECT_EQ(mesh.vertices[2].uv, glm::vec2(0, 0));
        EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1)) << "flat, counter-clockwise is the front";
        EXPECT_EQ(model.bounds.high, glm::dvec3(1, 1, 0));
        EXPECT_EQ(model.parts[0].material->metalness, 1);
        EXPECT_TRUE(model.warnings.empty());
    }
}

TEST(Gltf, FlattensTheNodeTree)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    builder.node(Json::parse(
        R"({"name": "parent", "translation": [1, 2, 3], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "children": [1]})"));
    builder.json["nodes"].push_back({{"name", "child"}, {"mesh", mesh}, {"scale", {2, -2, 2}}});
    const Model model = modelOf(builder);
    ASSERT_EQ(model.markers.size(), 1U);
    EXPECT_EQ(model.markers[0].name, "parent");
    ASSERT_EQ(model.parts.size(), 1U);
    EXPECT_TRUE(model.parts[0].mirrored);
    // (1, 0, 0) is scaled to (2, 0, 0), rotated by 90 degrees to (0, 2, 0), and moved.
    const glm::dvec4 corner = model.parts[0].modelFromPart * glm::dvec4(1, 0, 0, 1);
    EXPECT_NEAR(corner.x, 1, 1e-12);
    EXPECT_NEAR(corner.y, 4, 1e-12);
    EXPECT_NEAR(corner.z, 3, 1e-12);
}

TEST(Gltf, TakesMatricesByColumns)
{
    GltfBuilder builder;
    builder.node({{"name", "marker"}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1}}});
    EXPECT_EQ(modelOf(builder).markers.at(0).modelFromMarker[3], glm::dvec4(7, 8, 9, 1));
}

TEST(Gltf, SharesAMeshAmongNodes)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    builder.node({{"mesh", mesh}});
    builder.node({{"mesh", mesh}});
    const Model model = modelOf(builder);
    EXPECT_EQ(model.parts.at(0).mesh, model.parts.at(1).mesh);
    EXPECT_EQ(model.parts.at(0).material, model.parts.at(1).material);
}

TEST(Gltf, ReadsMaterials)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["materials"] =
        Json::parse(R"([{"name": "glow", "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
        "emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_unlit": {}, "KHR_materials_emissive_strength": {"emissiveStrength": 4}},
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.75}}])");
    builder.json["extensionsUsed"] = Json::array({"KHR_materials_emissive_strength", "KHR_materials_clearcoat"});
    builder.json["extensionsRequired"] =
        Json::array({"KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_texture_transform"});
    const Model model = modelOf(builder);
    const Material& material = *model.parts.at(0).material;
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.baseColor, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    EXPECT_EQ(material.metalness, 0.5F);
    EXPECT_EQ(material.roughness, 0.75F);
    EXPECT_EQ(material.emissive, glm::vec3(4, 2, 0));
    EXPECT_EQ(material.alphaMode, AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.25F);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(model.warnings.size(), 1U);
    EXPECT_TRUE(warnsOf(model, "KHR_materials_clearcoat"));
}

/// The format requires a list of all extensions, which some exporters leave out.
TEST(Gltf, NamesExtensionsThatItsListLeavesOut)
{
    GltfBuilder builder;
    const int node = builder.node({{"mesh", builder.triangle()}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["materials"] = Json::parse(
        R"([{"extensions": {"KHR_materials_sheen": {}}, "extras": {"extensions": {"EXT_of_others": {}}},
             "emissiveTexture": {"index": 0, "extensions": {"EXT_texture_of_others": {"scale": [2, 2]}}}}])");
    builder.json["textures"] = Json::parse(R"([{"extensions": {"EXT_texture_webp": {"source": 0}}}])");
    builder.json["nodes"][static_cast<std::size_t>(node)]["extensions"] =
        Json{{"EXT_mesh_gpu_instancing", Json::object()}};
    const Model model = modelOf(builder);
    for (const char* name :
         {"KHR_materials_sheen", "EXT_texture_of_others", "EXT_texture_webp", "EXT_mesh_gpu_instancing"})
        EXPECT_TRUE(warnsOf(model, "The extension " + std::string(name) + " is not supported and was ignored."))
            << name;
    EXPECT_FALSE(warnsOf(model, "EXT_of_others"));
}

TEST(Gltf, DecodesPicturesWithItsOwnReader)
{
    GltfBuilder packed = textured({{"bufferView", 0}, {"mimeType", "image/png"}});
    GltfBuilder withView;
    const std::string png = smallPng();
    // View 0 must be the picture, so it is added first.
    withView.view(png);
    withView.json["images"] = packed.json["images"];
    withView.json["textures"] = packed.json["textures"];
    withView.json["materials"] = packed.json["materials"];
    withView.triangle();
    withView.json["meshes"][0]["primitives"][0]["material"] = 0;
    withView.node({{"mesh", 0}});
    const TemporaryFolder folder;
    test::writeBytes(folder / "pictures/a b.png", png);
    test::writeBytes(folder / "view.glb", withView.glb());
    test::writeBytes(folder / "data.gltf", textured({{"uri", "data:image/png;base64," + test::base64(png)}}).text());
    test::writeBytes(folder / "file.gltf", textured({{"uri", "pictures/a%20b.png"}}).text());
    test::writeBytes(folder / "jpeg.gltf",
                     textured({{"uri", "data:image/jpeg;base64," + test::base64(test::jpegBytes())}}).text());
    for (const char* name : {"view.glb", "data.gltf", "file.gltf", "jpeg.gltf"}) {
        const Model model = loadGltf(folder / name);
        EXPECT_TRUE(model.warnings.empty()) << name << ": " << (model.warnings.empty() ? "" : model.warnings[0]);
        const Material& material = *model.parts.at(0).material;
        ASSERT_TRUE(material.baseColorMap && material.normalMap) << name;
        EXPECT_TRUE(material.baseColorMap->sRgb);
        EXPECT_FALSE(material.normalMap->sRgb);
        EXPECT_FALSE(material.baseColorMap->bytes.empty());
    }
}

TEST(Gltf, TakesPicturesFromTheFolderBesideItsOwn)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "pack/textures/a.png", smallPng());
    test::writeBytes(folder / "outside.png", smallPng());
    for (const char* uri : {"../textures/a.png", "..\\textures\\a.png", "sub/../../textures/a.png"}) {
        test::writeBytes(folder / "pack/models/a.gltf", textured({{"uri", uri}}).text());
        const Model model = loadGltf(folder / "pack/models/a.gltf");
        EXPECT_TRUE(model.warnings.empty()) << uri;
        EXPECT_TRUE(model.parts.at(0).material->baseColorMap) << uri;
    }
    test::writeBytes(folder / "pack/models/a.gltf", textured({{"uri", "../../outside.png"}}).text());
    const Model outside = loadGltf(folder / "pack/models/a.gltf");
    EXPECT_FALSE(outside.parts.at(0).material->baseColorMap);
    EXPECT_TRUE(warnsOf(outside, "../../outside.png is not followed: it leaves its folder"));
}

// glTF 2.0, 5.19: color space information of pictures is ignored; texture coordinates count rows as they are stored.
TEST(Gltf, TakesThePixelsOfPicturesAsStored)
{
    const TemporaryFolder folder;
    Image image(1, 2, 3);
    image.pixels = {1, 0, 0, 0, 0, 0.25F};
    writePicture(folder / "plain.png", image, PictureFormat::png8);
    const std::string plain = test::bytesOf(folder / "plain.png");
    std::string marked = plain;
    marked.insert(plain.find("IDAT") - 4, test::pngChunk("eXIf", test::exifBlock(3)));
    const std::size_t sRgb = marked.find("sRGB") - 4;
    marked.erase(sRgb, 13);
    const std::size_t gamma = marked.find("gAMA") - 4;
    marked.replace(gamma, 16, test::pngChunk("gAMA", test::bigEndian32(100000)));
    const auto mapOf = [](const std::string& png) {
        const std::string uri = "data:image/png;base64," + test::base64(png);
        return parseGltf(textured({{"uri", uri}}).text(), "model.gltf").parts.at(0).material->baseColorMap;
    };
    EXPECT_EQ(mapOf(marked)->bytes, mapOf(plain)->bytes);
    test::writeBytes(folder / "a.png", marked);
    EXPECT_NE(loadTexture(folder / "a.png", true, true)->bytes, mapOf(plain)->bytes) << "the control: others obey";
}

TEST(Gltf, LeavesOutPicturesThatCannotBeRead)
{
    const Model missing = parseGltf(textured({{"uri", "none.png"}}).text(), "model.gltf");
    EXPECT_FALSE(missing.parts.at(0).material->baseColorMap);
    EXPECT_TRUE(warnsOf(missing, "none.png"));
    const std::string bomb = test::base64(test::pngClaiming(16'000, 16'000, 8, 2, "x"));
    const Model hostile = parseGltf(textured({{"uri", "data:image/png;base64," + bomb}}).text(), "model.gltf");
    EXPECT_FALSE(hostile.parts.at(0).material->baseColorMap);
    EXPECT_TRUE(warnsOf(hostile, "times its size"));
}

TEST(Gltf, CountsUnpackedPicturesBeforeUnpackingThem)
{
    GltfLimits limits;
    limits.textureBytes = 11;
    const Model model = parseGltf(textured({{"uri", "data:image/png;base64," + test::base64(smallPng())}}).text(),
                                  "model.gltf", limits);
    EXPECT_FALSE(model.parts.at(0).material->baseColorMap) << "2 x 2 x 3 is 12 bytes";
    EXPECT_TRUE(warnsOf(model, "bytes once unpacked"));
}

// The picture's right is +x, its up is +y, and the triangle faces +z.
TEST(Gltf, MakesTangentsWhereANormalMapNeedsThem)
{
    const Model model =
        parseGltf(textured({{"uri", "data:image/png;base64," + test::base64(smallPng())}}).text(), "model.gltf");
    for (const Vertex& vertex : model.parts.at(0).mesh->vertices) EXPECT_EQ(vertex.tangent, glm::vec4(1, 0, 0, 1));
}

TEST(Gltf, AppliesSparseAccessorsAndNormalizedIntegers)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    const int positions = builder.view(std::string("\1", 1));
    const float moved[3] = {5, 6, 7};
    const int values = builder.view(std::string_view(reinterpret_cast<const char*>(moved), sizeof moved));
    builder.json["accessors"][0]["sparse"] = {{"count", 1},
                                              {"indices", {{"bufferView", positions}, {"componentType", 5121}}},
                                              {"values", {{"bufferView", values}}}};
    const int coordinates = builder.view(std::string("\xff\x00\x00\x00\x80\xff\x00\x00\x33\x00\x00\x00", 12));
    builder.json["bufferViews"][static_cast<std::size_t>(coordinates)]["byteStride"] = 4U;
    builder.json["accessors"][1] = {
        {"bufferView", coordinates}, {"componentType", 5121}, {"normalized", true}, {"count", 3}, {"type", "VEC2"}};
    builder.node({{"mesh", mesh}});
    const Model model = modelOf(builder);
    EXPECT_EQ(model.parts.at(0).mesh->vertices[1].position, glm::vec3(5, 6, 7));
    EXPECT_EQ(model.parts.at(0).mesh->vertices[0].uv, glm::vec2(1, 0));
    EXPECT_EQ(model.parts.at(0).mesh->vertices[2].uv.x, 0.2F);
}

TEST(Gltf, TurnsStripsAndFansIntoTriangles)
{
    for (const auto& [mode, expected] : {std::pair(5, std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}),
                                         std::pair(6, std::vector<std::uint32_t>{1, 2, 0, 2, 3, 0})}) {
        GltfBuilder builder;
        Json primitive;
        primitive["attributes"]["POSITION"] = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
        primitive["attributes"]["NORMAL"] = builder.floats({0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 1}, "VEC3");
        primitive["mode"] = mode;
        builder.json["meshes"].push_back({{"primitives", Json::array({primitive})}});
        builder.node({{"mesh", 0}});
        const Model model = modelOf(builder);
        EXPECT_EQ(model.parts.at(0).mesh->indices, expected);
        EXPECT_EQ(model.parts.at(0).mesh->vertices[2].normal, glm::vec3(0, 0, 1)) << "made unit length";
    }
}

TEST(Gltf, ListsWhatItDoesNotSupport)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = Json::parse(R"([{"POSITION": 0}])");
    builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_1"] = 0;
    builder.json["meshes"][0]["primitives"].push_back(Json::parse(R"({"mode": 1, "attributes": {"POSITION": 0}})"));
    builder.json["skins"] = Json::parse(R"([{"joints": [0]}])");
    builder.json["animations"] = Json::parse(
        R"([{"channels": [{"sampler": 0, "target": {"node": 0, "path": "scale"}}], "samplers": [{"input": 0, "output": 0}]}])");
    builder.node({{"mesh", mesh}});
    const Model model = modelOf(builder);
    EXPECT_EQ(model.parts.size(), 1U);
    for (const char* what : {"Morph targets", "COLOR_1", "Lines and points", "Skins", "Animations"})
        EXPECT_TRUE(warnsOf(model, what)) << what;
}

TEST(Gltf, SamplesPicturesAsItsSamplersSay)
{
    const auto textureOf = [](const char* sampler) {
        GltfBuilder builder = textured({{"uri", "data:image/png;base64," + test::base64(smallPng())}});
        if (sampler) {
            builder.json["samplers"] = Json::array({Json::parse(sampler)});
            builder.json["textures"][0]["sampler"] = 0;
        }
        return modelOf(builder).parts.at(0).material->baseColorMap;
    };
    const auto plain = textureOf(nullptr);
    EXPECT_TRUE(plain->mipmaps && !plain->magnifyNearest && !plain->minifyNearest && !plain->nearestLevel);
    const auto pixels = textureOf(R"({"magFilter": 9728, "minFilter": 9728})");
    EXPECT_TRUE(!pixels->mipmaps && pixels->magnifyNearest && pixels->minifyNearest);
    const auto mixed = textureOf(R"({"magFilter": 9728, "minFilter": 9987})");
    EXPECT_TRUE(mixed->mipmaps && mixed->magnifyNearest && !mixed->minifyNearest && !mixed->nearestLevel);
    const auto levels = textureOf(R"({"magFilter": 9729, "minFilter": 9984})");
    EXPECT_TRUE(levels->mipmaps && !levels->magnifyNearest && levels->minifyNearest && levels->nearestLevel);
}

TEST(Gltf, StopsWhenCanceled)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    EXPECT_FAILURE(parseGltf(builder.glb(), "model.glb", {}, [] { return true; }), "canceled");
}

TEST(Gltf, ReadsExternalBuffersBelowItsFolder)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    builder.json["buffers"] = Json::array({Json{{"byteLength", builder.bin.size()}, {"uri", "data/mesh.bin"}}});
    const TemporaryFolder folder;
    test::writeBytes(folder / "model.gltf", builder.json.dump());
    EXPECT_FAILURE(loadGltf(folder / "model.gltf"), "mesh.bin");
    test::writeBytes(folder / "data/mesh.bin", builder.bin);
    EXPECT_EQ(loadGltf(folder / "model.gltf").parts.size(), 1U);
    std::filesystem::rename(folder / "data/mesh.bin", folder / "elsewhere");
    std::filesystem::create_symlink("../elsewhere", folder / "data/mesh.bin");
    EXPECT_FAILURE(loadGltf(folder / "model.gltf"), "symbolic link");
}

// glTF 2.0, 3.6.2.1: an accessor without a view contains zeros; 3.6.2.3: sparse values may replace some.
TEST(Gltf, TakesAccessorsWithoutAViewForZeros)
{
    GltfBuilder builder;
    const int mesh = builder.triangle();
    const int places = builder.view(std::string("\1\2", 2));
    const float moved[6] = {1, 0, 0, 0, 1, 0};
    const int values = builder.view(std::string_view(reinterpret_cast<const char*>(moved), sizeof moved));
    Json& positions = builder.json["accessors"][0];
    positions.erase("bufferView");
    positions["sparse"] = {{"count", 2},
                           {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                           {"values", {{"bufferView", values}}}};
    builder.json["accessors"][1].erase("bufferView");
    builder.node({{"mesh", mesh}});
    const Model model = modelOf(builder);
    EXPECT_TRUE(model.warnings.empty());
    const Mesh& read = *model.parts.at(0).mesh;
    EXPECT_EQ(read.vertices[0].position, glm::vec3(0));
    EXPECT_EQ(read.vertices[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(read.vertices[2].position, glm::vec3(0, 1, 0));
    for (const Vertex& vertex : read.vertices) EXPECT_EQ(vertex.uv, glm::vec2(0));

    builder.json["accessors"][2].erase("bufferView");  // Also without indices: three times the first vertex.
    const Model point = modelOf(builder);
    for (const Vertex& vertex : point.parts.at(0).mesh->vertices) EXPECT_EQ(vertex.position, glm::vec3(0));
}

TEST(Gltf, TakesABufferWithoutAUriForTheChunkOrZeros)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    // A second buffer without data, with a view in place of the texture coordinates.
    builder.json["buffers"] = Json::array({Json{{"byteLength", builder.bin.size()}}, Json{{"byteLength", 24U}}});
    builder.json["bufferViews"].push_back({{"buffer", 1U}, {"byteLength", 24U}});
    builder.json["accessors"][1]["bufferView"] = builder.json["bufferViews"].size() - 1;
    const Model model = modelOf(builder);
    EXPECT_EQ(model.parts.at(0).mesh->vertices[1].position, glm::vec3(1, 0, 0)) << "from the chunk";
    EXPECT_EQ(model.parts.at(0).mesh->vertices[1].uv, glm::vec2(0));
    EXPECT_TRUE(warnsOf(model, "Buffer 1 names no data"));
    const Model text = parseGltf(builder.json.dump(), "model.gltf");
    EXPECT_EQ(text.parts.at(0).mesh->vertices[1].position, glm::vec3(0)) << "a .gltf has no chunk";
    EXPECT_TRUE(warnsOf(text, "Buffer 0 names no data"));
}

TEST(Gltf, ReadsBuffersWithUrisInsideAContainer)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    const TemporaryFolder folder;
    test::writeBytes(folder / "more data/mesh+1.bin", builder.bin + "the file may be longer");
    for (const std::string& uri : {"data:application/octet-stream;base64," + test::base64(builder.bin),
                                   "data:application/gltf-buffer;base64," + test::base64(builder.bin),
                                   "data:;base64," + test::base64(builder.bin), std::string("more%20data/mesh+1.bin"),
                                   std::string("./more%20data/mesh%2B1.bin")}) {
        Json file = builder.json;
        file["buffers"] = Json::array({Json{{"byteLength", builder.bin.size()}, {"uri", uri}}});
        test::writeBytes(folder / "model.glb", test::glbOf(file.dump(), "none of this is meant"));
        const Model model = loadGltf(folder / "model.glb");
        EXPECT_EQ(model.parts.at(0).mesh->vertices[2].position, glm::vec3(0, 1, 0)) << uri;
        EXPECT_TRUE(model.warnings.empty()) << uri;
    }
}

// JSON does not distinguish 4.0 and 4, and some exporters write every number with a point.
TEST(Gltf, ReadsWholeNumbersWrittenWithAPoint)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    std::string text = builder.text();
    const auto withPoint = [&](const std::string& key) {
        std::size_t count = 0;
        for (std::size_t at = text.find("\"" + key + "\": "); at != std::string::npos;
             at = text.find("\"" + key + "\": ", at + 1)) {
            const std::size_t end = text.find_first_not_of("0123456789", at + key.size() + 4);
            text.insert(end, ".0");
            ++count;
        }
        EXPECT_GT(count, 0U) << key;
    };
    for (const char* key : {"scene", "mesh", "bufferView", "byteOffset", "byteLength", "componentType", "count",
                            "buffer", "indices", "POSITION"})
        withPoint(key);
    const Model model = parseGltf(text, "model.gltf");
    EXPECT_EQ(model.parts.at(0).mesh->indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(model.parts.at(0).mesh->vertices[1].position, glm::vec3(1, 0, 0));
}

// glTF 2.0, 4.4.1: chunks of unknown types are ignored; an empty BIN chunk is omitted.
TEST(Gltf, PassesOverFurtherChunks)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    Json file = builder.json;
    file["buffers"] = Json::array({Json{{"byteLength", builder.bin.size()}}});
    const Model model =
        parseGltf(test::glbOf(file.dump(), builder.bin, {{"XTRA", "12345678"}, {"MORE", ""}}), "model.glb");
    EXPECT_EQ(model.parts.at(0).mesh->vertices[1].position, glm::vec3(1, 0, 0));
    file["buffers"][0]["uri"] = "data:;base64," + test::base64(builder.bin);
    EXPECT_EQ(parseGltf(test::glbOf(file.dump(), "", {{"XTRA", "1234"}}), "model.glb").parts.size(), 1U)
        << "no BIN chunk";
}

// Padding is required (4.4.3.1), but some exporters of otherwise valid files omit it.
TEST(Gltf, TakesChunksWithoutPadding)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    Json file = builder.json;
    file["buffers"] = Json::array({Json{{"byteLength", builder.bin.size()}}});
    std::string text = file.dump();
    while (text.size() % 4 != 1) text += ' ';
    std::string glb = "glTF" + test::littleEndian32(2);
    glb += test::littleEndian32(static_cast<std::uint32_t>(28 + text.size() + builder.bin.size()));
    glb += test::littleEndian32(static_cast<std::uint32_t>(text.size())) + "JSON" + text;
    glb += test::littleEndian32(static_cast<std::uint32_t>(builder.bin.size())) + std::string("BIN\0", 4) + builder.bin;
    EXPECT_EQ(parseGltf(glb, "model.glb").parts.at(0).mesh->vertices[1].position, glm::vec3(1, 0, 0));
}

}  // namespace
