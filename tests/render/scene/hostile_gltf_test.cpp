#include "render/scene/gltf.h"

#include "tests/render/scene/gltf_builder.h"
#include "tests/support/failures.h"
#include "tests/support/image_bytes.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace {

using namespace vitrine;
using namespace vitrine::render;
using namespace test;

/// Returns the error message for a valid file after `breakIt` has changed its JSON.
template <typename Break> std::string refusalOf(const Break& breakIt)
{
    GltfBuilder builder;
    builder.node({{"name", "thing"}, {"mesh", builder.triangle()}});
    builder.json["materials"] = Json::parse(R"([{"name": "paint"}])");
    breakIt(builder.json);
    return test::failureOf([&] { (void)parseGltf(builder.glb(), "model.glb"); });
}

#define EXPECT_REFUSED(statement, part)                                                                                \
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, part, refusalOf([](Json& json) { statement; }))

TEST(HostileGltf, WithABrokenContainerIsRefused)
{
    const std::string asset = R"({"asset":{"version":"2.0"}})";
    const std::string good = glbOf(asset, "12345678");
    EXPECT_NO_THROW((void)parseGltf(good, "a.glb"));
    EXPECT_FAILURE(parseGltf("glTF", "a.glb"), "too short");
    EXPECT_FAILURE(parseGltf(good + "more", "a.glb"), "another length");
    EXPECT_FAILURE(parseGltf(good.substr(0, good.size() - 1), "a.glb"), "another length");

    // Heap over-read of tinygltf 2.7.0: BIN claims the rest of the file, including its own header.
    std::string bin = good;
    const std::size_t at = good.size() - 16;
    bin.replace(at, 4, littleEndian32(16));
    EXPECT_FAILURE(parseGltf(bin, "a.glb"), "BIN chunk does not fit");
    bin.replace(at, 4, littleEndian32(0xFFFFFFF8));
    EXPECT_FAILURE(parseGltf(bin, "a.glb"), "BIN chunk does not fit");
    bin.replace(at, 4, littleEndian32(4));
    EXPECT_FAILURE(parseGltf(bin, "a.glb"), "something follows its BIN chunk that is no chunk");
    EXPECT_FAILURE(parseGltf(test::glbOf(asset, "12345678", {{"JSON", "{}  "}}), "a.glb"), "two JSON chunks");
    EXPECT_FAILURE(parseGltf(test::glbOf(asset, "12345678", {{std::string("BIN\0", 4), "1234"}}), "a.glb"),
                   "not the second");

    std::string json = good;
    json.replace(12, 4, littleEndian32(0xFFFFFFFC));
    EXPECT_FAILURE(parseGltf(json, "a.glb"), "JSON chunk does not fit");
    std::string version = good;
    version[4] = 1;
    EXPECT_FAILURE(parseGltf(version, "a.glb"), "version 2");
}

/// Some exporters pad JSON with zeros in place of blanks. Zero bytes beyond the length of a padding are invalid.
TEST(HostileGltf, MayPadItsJsonWithZerosAndHoldNoOthers)
{
    test::GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    const std::string whole = builder.glb();
    std::string json = whole.substr(20, whole.find("BIN", 20) - 24);
    json.erase(json.find_last_not_of(' ') + 1);
    while (json.size() % 4 != 3) json.insert(1, 1, ' ');
    const auto container = [&](std::string text) { return test::glbOf(std::move(text), builder.bin, {}); };
    const auto zeros = [](std::size_t count) { return std::string(count, '\0'); };
    EXPECT_NO_THROW((void)parseGltf(container(json + zeros(1)), "a.glb"));
    EXPECT_FAILURE(parseGltf(container(json + zeros(5)), "a.glb"), "here is a zero byte");
    EXPECT_FAILURE(parseGltf(container(json + zeros(1) + "}{  " + zeros(3)), "a.glb"), "here is a zero byte");
}

TEST(HostileGltf, WithBrokenJsonIsRefusedWithItsLine)
{
    EXPECT_FAILURE(parseGltf("{\n\"asset\": {\"version\": \"2.0\"},\n\"asset\": {}}", "a.gltf"), "a.gltf, line 3");
    EXPECT_FAILURE(parseGltf("{", "a.gltf"), "not valid JSON");
    EXPECT_FAILURE(parseGltf("[]", "a.gltf"), "not an object");
    EXPECT_FAILURE(parseGltf("", "a.gltf"), "empty");
    EXPECT_FAILURE(parseGltf("\x9F\x01\x7F{}", "a.glb"), "Cannot read a.glb: this is not a glTF file");
    EXPECT_FAILURE(parseGltf(std::string("\x12\0\x03", 3), "a.gltf"), "Cannot read a.gltf: this is not a glTF file");
    EXPECT_FAILURE(parseGltf("{}", "a.gltf"), "a.gltf, line 1, asset: this is required and missing");
    EXPECT_FAILURE(parseGltf(R"({"asset":{"version":"1.0"}})", "a.gltf"), "asset.version: this is glTF 1.0");
    std::string deep;
    for (int i = 0; i < 200'000; ++i) deep += "{\"a\":";
    EXPECT_FAILURE(parseGltf("{\"extras\":" + deep, "a.gltf"), "more than 64 deep");
    EXPECT_FAILURE(parseGltf(R"({"asset":{"version":"2.0"},"nodes":[{"translation":[1e400,0,0]}]})", "a.gltf"),
                   "too large");
}

TEST(HostileGltf, WithEmptyOrLyingBuffersIsRefused)
{
    EXPECT_REFUSED(json["buffers"] = Json::parse(R"([{"byteLength": 0}])"),
                   "buffers[0].byteLength: a buffer cannot be empty");
    EXPECT_REFUSED(json["buffers"] = Json::parse(R"([{"byteLength": 4000000000}])"), "larger than");
    EXPECT_REFUSED(json["buffers"] = Json::parse(R"([{"byteLength": 500}])"), "model.glb");
    EXPECT_REFUSED(json["buffers"] = Json::parse(R"([{"byteLength": -1}])"), "whole number");
    EXPECT_REFUSED(json["bufferViews"][0]["buffer"] = 7, "bufferViews[0].buffer: there is no such buffer");
    EXPECT_REFUSED(json["bufferViews"][0]["byteLength"] = 999'999'999, "reaches beyond its buffer");
    EXPECT_REFUSED(json["bufferViews"][0]["byteOffset"] = 18'446'744'073'709'551'615U, "reaches beyond its buffer");
    EXPECT_REFUSED(json["bufferViews"][0]["byteLength"] = 0, "cannot be empty");
    EXPECT_REFUSED(json["bufferViews"][0]["byteStride"] = 2, "tride");
    EXPECT_REFUSED(json["bufferViews"][0]["byteStride"] = 4, "stride is smaller");
}

TEST(HostileGltf, WithPicturesBeyondTheirBufferIsRefused)
{
    EXPECT_REFUSED((json["images"] = Json::parse(R"([{"bufferView": 0, "mimeType": "image/png"}])"),
                    json["bufferViews"][0]["byteOffset"] = 100'000'000),
                   "reaches beyond its buffer");
    EXPECT_REFUSED(json["images"] = Json::parse(R"([{"bufferView": 99, "mimeType": "image/png"}])"), "bufferView");
}

TEST(HostileGltf, WithAccessorsOutOfRangeIsRefused)
{
    EXPECT_REFUSED(json["accessors"][0]["bufferView"] = 99, "accessors[0].bufferView: 99 names nothing");
    EXPECT_REFUSED(json["accessors"][0]["count"] = 4, "accessors[0].count: its elements reach beyond");
    EXPECT_REFUSED(json["accessors"][0]["count"] = 0, "accessors[0].count");
    EXPECT_REFUSED(json["accessors"][0]["count"] = 1'000'000'000'000, "accessors[0].count");
    EXPECT_REFUSED(json["accessors"][0]["byteOffset"] = 4, "reach beyond");
    EXPECT_REFUSED(json["accessors"][0]["byteOffset"] = 18'446'744'073'709'551'608U, "reach beyond");
    EXPECT_REFUSED(json["accessors"][0]["componentType"] = 5130, "none of glTF's");
    EXPECT_REFUSED(json["accessors"][0]["type"] = "VEC2", "this must have 3 components");
    EXPECT_REFUSED(json["accessors"][2]["componentType"] = 5126, "model.glb");
    EXPECT_REFUSED(json["accessors"][2]["type"] = "VEC2", "model.glb");
    EXPECT_REFUSED(json["accessors"][1]["count"] = 2, "its count differs");
}

TEST(HostileGltf, WithBadSparseAccessorsIsRefused)
{
    const auto sparse = [](Json& json, int count, int indexView, const char* more) {
        json["accessors"][0]["sparse"] = {{"count", count},
                                          {"indices", {{"bufferView", indexView}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", 0}}}};
        json["accessors"][0]["sparse"].update(Json::parse(more));
    };
    // View 2 has the 16-bit indices 0, 1, 2, which rise and are below the count of 3.
    GltfBuilder good;
    good.node({{"mesh", good.triangle()}});
    sparse(good.json, 3, 2, "{}");
    EXPECT_NO_THROW((void)parseGltf(good.glb(), "model.glb"));
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "sparse.count",
                        refusalOf([&](Json& json) { sparse(json, 4, 2, "{}"); }));
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "sparse.count",
                        refusalOf([&](Json& json) { sparse(json, -1, 2, "{}"); }));
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "names nothing",
                        refusalOf([&](Json& json) { sparse(json, 3, 77, "{}"); }));
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "must rise", refusalOf([&](Json& json) { sparse(json, 3, 0, "{}"); }));
    EXPECT_PRED_FORMAT2(
        ::testing::IsSubstring, "values.byteOffset: this must be a whole number",
        refusalOf([&](Json& json) { sparse(json, 3, 2, R"({"values": {"bufferView": 0, "byteOffset": -4}})"); }));
}

// A few bytes of JSON must not allocate gigabytes of zeros.
TEST(HostileGltf, WithMoreZerosThanAllowedIsRefused)
{
    EXPECT_REFUSED((json["accessors"][0].erase("bufferView"), json["accessors"][0]["count"] = 50'000'000),
                   "accessors without data have more than 1048576");
    EXPECT_FAILURE(parseGltf(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":100000000}]})", "a.gltf"),
                   "buffers[0].byteLength: the buffers without data are larger than 67108864");
}

TEST(HostileGltf, WithMembersOfAnotherTypeIsRefusedWithTheirPath)
{
    EXPECT_REFUSED(json["accessors"][1]["bufferView"] = -1, "accessors[1].bufferView: this must be a whole number");
    EXPECT_REFUSED(json["accessors"][1]["bufferView"] = 1.5, "accessors[1].bufferView: this must be a whole number");
    EXPECT_REFUSED(json["accessors"][1].erase("count"), "accessors[1].count: this is required and missing");
    EXPECT_REFUSED(json["accessors"][1]["type"] = "VEC9",
                   "accessors[1].componentType: its type or component type is none");
    EXPECT_REFUSED(json["meshes"][0]["primitives"] = 3, "meshes[0].primitives: this must be an array");
    EXPECT_REFUSED(json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = "x",
                   "attributes.NORMAL: this must be a whole number");
    EXPECT_REFUSED(json["nodes"][0]["mesh"] = 4294967296U,
                   "nodes[0].mesh: this must be a whole number from 0 to 2147483647");
    EXPECT_REFUSED(json["nodes"][0]["translation"] = Json::parse(R"([0, "x", 0])"),
                   "nodes[0].translation[1]: this must be a number");
    EXPECT_REFUSED(json["bufferViews"][0]["byteStride"] = 6, "bufferViews[0].byteStride: a stride is a multiple of 4");
    EXPECT_REFUSED(json["images"] = Json::parse(R"([{"name": "x"}])"),
                   "images[0].uri: a picture has either a uri or a bufferView");
}

TEST(HostileGltf, WithABrokenOrShortDataUriIsRefused)
{
    const auto read = [](const char* uri) {
        const Json file{{"asset", {{"version", "2.0"}}},
                        {"buffers", Json::array({Json{{"byteLength", 6U}, {"uri", uri}}})}};
        (void)parseGltf(file.dump(), "a.gltf");
    };
    const auto refused = [&](const char* uri) { return test::failureOf([&] { read(uri); }); };
    EXPECT_NO_THROW(read("data:;base64,AAAAAAAA"));
    EXPECT_NE(
        refused("data:;base64,AAAA").find("buffers[0].uri: the buffer has 3 bytes, fewer than its byteLength of 6"),
        std::string::npos);
    EXPECT_NE(refused("data:;base64,AA!AAAAA").find("buffers[0].uri: this data: URI is not base 64"),
              std::string::npos);
    EXPECT_NE(refused("data:;base64,AAAAA").find("not base 64"), std::string::npos);
    EXPECT_NE(refused("data:;base64").find("has a comma"), std::string::npos);
}

TEST(HostileGltf, WithIndicesBeyondItsVerticesIsRefused)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.indices({0, 1, 3});
    EXPECT_FAILURE(parseGltf(builder.glb(), "model.glb"), "names a vertex beyond the 3");
}

TEST(HostileGltf, WithNumbersThatAreNotFiniteIsRefused)
{
    GltfBuilder builder;
    builder.node({{"mesh", builder.triangle()}});
    builder.bin.replace(0, 4, littleEndian32(0x7FC00000));
    EXPECT_FAILURE(parseGltf(builder.glb(), "model.glb"), "POSITION: one of its values is not a finite number");
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "overflows", refusalOf([](Json& json) {
                            json["nodes"][0]["scale"] = {1e308, 1e308, 1e308};
                            json["nodes"][0]["children"] = Json::array({1});
                            json["nodes"].push_back(Json::parse(R"({"scale": [1e308, 1, 1]})"));
                        }));
}

TEST(HostileGltf, WithReferencesToNothingIsRefused)
{
    EXPECT_REFUSED(json["nodes"][0]["mesh"] = 5, "nodes[0].mesh: 5 names nothing");
    EXPECT_REFUSED(json["nodes"][0]["children"] = Json::array({-1}), "children");
    EXPECT_REFUSED(json["nodes"][0]["children"] = Json::array({88}), "children");
    EXPECT_REFUSED(json["scene"] = 3, "scene: 3 names nothing");
    EXPECT_REFUSED(json["scenes"][0]["nodes"] = Json::array({4}), "scenes[0].nodes");
    EXPECT_REFUSED(json["meshes"][0]["primitives"][0]["material"] = 9, "material: 9 names nothing");
    EXPECT_REFUSED(json["meshes"][0]["primitives"][0]["indices"] = 9, "model.glb");
    EXPECT_REFUSED(json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 9,
                   "attributes.NORMAL: 9 names nothing");
    EXPECT_REFUSED(json["materials"][0]["normalTexture"] = Json::parse(R"({"index": 2})"),
                   "normalTexture.index: 2 names nothing");
    EXPECT_REFUSED(json["textures"] = Json::parse(R"([{"source": 3}])"), "textures[0].source: 3 names nothing");
    EXPECT_REFUSED(json["nodes"][0]["matrix"] = Json::array({1, 2, 3}), "model.glb");
}

TEST(HostileGltf, WhoseNodesAreNoTreeIsRefused)
{
    EXPECT_REFUSED(json["nodes"][0]["children"] = Json::array({0}), "nodes");
    EXPECT_REFUSED(
        (json["nodes"][0]["children"] = Json::array({1}), json["nodes"].push_back(Json::parse(R"({"children": [0]})"))),
        "nodes");
    EXPECT_REFUSED((json["nodes"][0]["children"] = Json::parse("[1, 1]"),
                    json["nodes"].push_back(Json::parse(R"({"name": "x"})"))),
                   "two parents");
    EXPECT_REFUSED(json["scenes"][0]["nodes"] = Json::array({0, 0}), "named twice");
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, "nested more than 256 deep", refusalOf([](Json& json) {
                            for (int i = 1; i <= 300; ++i) {
                                json["nodes"][static_cast<std::size_t>(i - 1)]["children"] = Json::array({i});
                                json["nodes"].push_back(Json::parse(R"({"name": "x"})"));
                            }
                        }));
}

TEST(HostileGltf, ThatReachesForOtherFilesIsRefused)
{
    for (const char* uri : {"/etc/passwd", "../../../etc/passwd", "%2e%2e/%2e%2e/etc/passwd", "%2Fetc/passwd",
                            "file:///etc/passwd", "http://example.com/a", "~/a", "C:\\a", "..\\..\\a"}) {
        const std::string buffer =
            Json{{"asset", {{"version", "2.0"}}}, {"buffers", Json::array({Json{{"byteLength", 10U}, {"uri", uri}}})}}
                .dump();
        EXPECT_FAILURE(parseGltf(buffer, "a.gltf"), "buffers[0].uri: this reference is refused");
        GltfBuilder builder;
        builder.node({{"mesh", builder.triangle()}});
        builder.json["images"] = Json::array({Json{{"uri", uri}}});
        const Model model = parseGltf(builder.text(), "a.gltf");
        std::string all;
        for (const Message& warning : model.warnings) all += warning.english();
        EXPECT_PRED_FORMAT2(::testing::IsSubstring, "is not followed: ", all) << uri;
    }
}

TEST(HostileGltf, ThatRequiresWhatIsNotThereIsRefused)
{
    EXPECT_REFUSED(json["extensionsRequired"] = Json::array({"EXT_mesh_gpu_instancing"}),
                   "EXT_mesh_gpu_instancing, which is not supported");
}

TEST(HostileGltf, BeyondTheLimitsIsRefused)
{
    GltfBuilder builder;
    for (int i = 0; i < 10; ++i) builder.node({{"mesh", builder.triangle()}});
    const std::string glb = builder.glb();
    const auto with = [&](auto member, std::uint64_t limit) {
        GltfLimits limits;
        limits.*member = limit;
        return test::failureOf([&] { (void)parseGltf(glb, "model.glb", limits); });
    };
    EXPECT_NE(with(&GltfLimits::nodes, 9).find("more than the 9"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::primitives, 9).find("more than 9 primitives"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::vertices, 29).find("more than 29 vertices"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::indices, 29).find("more than 29 indices"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::bufferBytes, 100).find("larger than 100"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::fileBytes, 100).find("too large"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::stringBytes, 4).find("longer than 4"), std::string::npos);
    EXPECT_NE(with(&GltfLimits::jsonBytes, 100).find("more than the 100"), std::string::npos);
}

constexpr int damagedFiles = test::isSanitized ? 500 : 5'000;

// Random changes of numbers and characters in a valid file: it is read or refused without a crash.
TEST(LongHostileGltf, NeverCrashesWhenDamaged)
{
    GltfBuilder builder;
    builder.node({{"name", "thing"}, {"mesh", builder.triangle()}, {"children", Json::array({1})}});
    builder.json["nodes"].push_back(Json::parse(R"({"name": "child", "translation": [1, 2, 3], "mesh": 0})"));
    builder.json["images"] = Json::array({Json{{"uri", "data:image/jpeg;base64," + test::base64(test::jpegBytes())}}});
    builder.json["textures"] = Json::parse(R"([{"source": 0}])");
    builder.json["materials"] = Json::parse(R"([{"normalTexture": {"index": 0}}])");
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    const std::string good = builder.glb();
    std::mt19937 generator(6);
    const auto random = [&generator] { return static_cast<unsigned>(generator()); };
    int accepted = 0;
    for (int i = 0; i < damagedFiles; ++i) {
        std::string bytes = good;
        for (unsigned n = random() % 3 + 1; n > 0; --n) {
            char& c = bytes[random() % bytes.size()];
            c = c >= '0' && c <= '9' ? static_cast<char>('0' + random() % 10)
                : random() % 4 == 0  ? static_cast<char>(random())
                                     : c;
        }
        try {
            (void)parseGltf(bytes, "model.glb");
            ++accepted;
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find("model.glb"), std::string::npos);
        }
    }
    EXPECT_GT(accepted, damagedFiles / 50);
    EXPECT_LT(accepted, damagedFiles - damagedFiles / 500);
}

}  // namespace
