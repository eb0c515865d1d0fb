// Compressed models, which compressed/make.mjs made with gltf-transform, Google's draco3d and gltfpack, against the
// same objects without compression.

#include "render/scene/gltf.h"
#include "render/scene/gltf_animation.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/support/failures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace vitrine::render {
namespace {

std::string compressedFile(const std::string& name)
{
    std::ifstream file(std::filesystem::path(VITRINE_SOURCE_DIR) / "tests/render/scene/compressed" / name,
                       std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Corner {
    glm::dvec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
    glm::vec4 color;
};
using Triangle = std::array<Corner, 3>;

std::vector<Triangle> trianglesOf(const Model& model)
{
    std::vector<Triangle> all;
    for (const MeshInstance& part : model.parts)
        for (std::size_t i = 0; i + 2 < part.mesh->indices.size(); i += 3) {
            Triangle& triangle = all.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t index = part.mesh->indices[i + k];
                const Vertex& v = part.mesh->vertices.at(index);
                triangle[k] = {glm::dvec3(part.modelFromPart * glm::dvec4(v.position, 1)), v.normal, v.uv,
                               part.mesh->colors.empty() ? glm::vec4(1) : part.mesh->colors.at(index)};
            }
        }
    return all;
}

/// Returns the largest distance between corners of two triangles, in the best of three rotations, which turns `b`.
double distanceOf(const Triangle& a, Triangle& b)
{
    Triangle best = b;
    double least = 1e9;
    for (int turn = 0; turn < 3; ++turn) {
        double most = 0;
        for (std::size_t k = 0; k < 3; ++k) most = std::max(most, glm::distance(a[k].position, b[k].position));
        if (most < least) {
            least = most;
            best = b;
        }
        std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    b = best;
    return least;
}

struct Compressed {
    const char* name;
    const char* plain;
    double position;  ///< Half a step of the quantization along each axis.
    float normal;     ///< Largest distance of unit vectors.
    float uv;         ///< Zero: no coordinates are compared.
    float color;
};

/// gltfpack stores texture coordinates without a texture in whole numbers of any scale, so they are not compared.
constexpr std::array<Compressed, 6> compressedModels{{
    // 14 bits for 1.4 m; 10 bits for an octahedral coordinate from -1 to 1; 12 bits for 1; 8 bits.
    {"draco_edgebreaker.glb", "torus.glb", 1.4 / 16383 / 2, 0.004F, 0.5F / 4095, 0.5F / 255},
    {"draco_sequential.glb", "torus.glb", 1.4 / 16383 / 2, 0.004F, 0.5F / 4095, 0.5F / 255},
    // Only normals go through a filter, of 8 bits.
    {"meshopt_filter.glb", "torus_ribbon.glb", 0, 0.02F, 1e-6F, 0},
    // Its 12 bits of a coordinate are rounded again, to 16 bits.
    {"meshopt_quantize.glb", "torus_ribbon.glb", 1.4 / 16383, 0.004F, 0.5F / 4095 + 0.5F / 65535, 0},
    {"gltfpack.glb", "torus.glb", 1.4 / 16383 / 2, 0.02F, 0, 1.0F / 255},
    // A mantissa of 14 bits and sign, for numbers below 1.
    {"gltfpack_float.glb", "torus.glb", 1.0 / 16384, 0.02F, 0, 1.0F / 255},
}};

class CompressedGltf : public testing::TestWithParam<Compressed> {};

TEST_P(CompressedGltf, HasTheTrianglesOfThePlainModelWithinTheQuantization)
{
    const Compressed& c = GetParam();
    const Model model = parseGltf(compressedFile(c.name), c.name);
    const Model original = parseGltf(compressedFile(c.plain), c.plain);
    EXPECT_EQ(model.warnings.size(), original.warnings.size());
    const std::vector<Triangle> plain = trianglesOf(original);
    std::vector<Triangle> decoded = trianglesOf(model);
    ASSERT_EQ(decoded.size(), plain.size());
    ASSERT_GE(plain.size(), 576U);
    constexpr double rounding = 1e-6;  // Error of single precision, at a distance of 1 m.
    double furthest = 0;
    float normal = 0, uv = 0, color = 0;
    for (const Triangle& triangle : plain) {
        std::size_t nearest = 0;
        double least = 1e9;
        for (std::size_t i = 0; i < decoded.size(); ++i)
            if (const double d = distanceOf(triangle, decoded[i]); d < least) {
                least = d;
                nearest = i;
            }
        furthest = std::max(furthest, least);
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner& is = decoded[nearest][k];
            normal = std::max(normal, glm::distance(is.normal, triangle[k].normal));
            uv = std::max({uv, std::abs(is.uv.x - triangle[k].uv.x), std::abs(is.uv.y - triangle[k].uv.y)});
            for (int i = 0; i < 4; ++i) color = std::max(color, std::abs(is.color[i] - triangle[k].color[i]));
        }
        decoded.erase(decoded.begin() + static_cast<std::ptrdiff_t>(nearest));  // Each belongs to one triangle.
    }
    EXPECT_LE(furthest, std::sqrt(3.0) * c.position + rounding);
    EXPECT_LE(normal, c.normal);
    EXPECT_LE(c.uv > 0 ? uv : 0, c.uv + rounding);
    EXPECT_LE(color, c.color + rounding);
    EXPECT_EQ(furthest > 0, c.position > 0) << "a quantized model differs from the plain one";
}

TEST_P(CompressedGltf, MovesAsThePlainModelDoes)
{
    const Compressed& c = GetParam();
    const AnimatedModel plain = AnimatedModel::parse(compressedFile(c.plain), c.plain);
    const AnimatedModel packed = AnimatedModel::parse(compressedFile(c.name), c.name);
    for (const double time : {0.0, 0.4, 1.5}) {
        const Box expected = plain.posed(0, time).bounds, is = packed.posed(0, time).bounds;
        // 12 bits of a quaternion turn a point at 0.7 m by less than 1 mm.
        EXPECT_LT(glm::distance(is.low, expected.low) + glm::distance(is.high, expected.high), 2e-3) << time;
    }
    EXPECT_GT(glm::distance(plain.posed(0, 0.4).bounds.low, plain.posed(0, 1.5).bounds.low), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Files, CompressedGltf, testing::ValuesIn(compressedModels), [](const auto& p) {
    const std::string name = p.param.name;
    return name.substr(0, name.find('.'));
});

/// A .glb file as its JSON and its BIN chunk, to be changed.
struct Opened {
    Json json;
    std::string bin;
};

/// Returns the sentence with which a compressed file is refused after a change.
std::string refusalOfChanged(const char* name, const std::function<void(Opened&)>& change,
                             const GltfLimits& limits = {})
{
    const std::string bytes = compressedFile(name);
    const auto sizeAt = [&](std::size_t at) {
        std::uint32_t size = 0;
        std::copy_n(bytes.data() + at, sizeof size, reinterpret_cast<char*>(&size));
        return size;
    };
    const std::uint32_t length = sizeAt(12);
    Opened opened{Json::parse(bytes.substr(20, length)), bytes.substr(28 + length, sizeAt(20 + length))};
    change(opened);
    return test::failureOf([&] { (void)parseGltf(test::glbOf(opened.json.dump(), opened.bin), name, limits); });
}

TEST(BrokenCompression, OfBufferViewsIsRefusedWithItsPlace)
{
    struct Case {
        const char* key;
        Json value;
        const char* reason;
    };
    const std::vector<Case> cases{
        {"mode", "POINTS", "its mode or filter is none of EXT_meshopt_compression's"},
        {"filter", "COLOR", "its mode or filter is none of EXT_meshopt_compression's"},
        {"filter", "QUATERNION", "its byteStride does not fit its mode and filter"},
        {"byteStride", 0U, "its byteStride does not fit its mode and filter"},
        {"byteStride", 260U, "its byteStride does not fit its mode and filter"},
        {"buffer", 9U, "its compressed data reaches beyond the buffer"},
        {"byteOffset", 18446744073709551615U, "its compressed data reaches beyond the buffer"},
        {"byteLength", 99999U, "its compressed data reaches beyond the buffer"},
        {"count", 324U, "its count and byteStride do not make the byteLength of the view"},
        {"count", 18446744073709551615U, "its count and byteStride do not make the byteLength of the view"},
        {"byteLength", 40U, "its compressed data is broken"},
        {"mode", 3U, "this must be text"},
        {"count", nullptr, "this must be a whole number"}};
    for (const Case& c : cases) {
        const std::string refusal = refusalOfChanged("meshopt_filter.glb", [&](Opened& file) {
            file.json["bufferViews"][3]["extensions"]["EXT_meshopt_compression"][c.key] = c.value;
        });
        EXPECT_PRED_FORMAT2(testing::IsSubstring, c.reason, refusal) << c.key;
        EXPECT_PRED_FORMAT2(testing::IsSubstring, "bufferViews[3]", refusal);
    }
    GltfLimits limits;
    limits.bufferBytes = 23'072;  // As large as the buffers of the file, of which 14736 bytes are decoded.
    const auto twice = [](Opened& file) {
        Json& views = file.json["bufferViews"];
        for (int i = 0; i < 8; ++i) views.push_back(views[3]);
    };
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "the decoded data is larger than 23072 bytes",
                        refusalOfChanged("meshopt_filter.glb", twice, limits));
}

TEST(BrokenCompression, OfAViewInAFallbackBufferWithoutDataIsRefused)
{
    const std::string refusal =
        refusalOfChanged("meshopt_filter.glb", [](Opened& file) { file.json["bufferViews"][3].erase("extensions"); });
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "this view reaches beyond its buffer, which has 0 bytes", refusal);
}

TEST(BrokenCompression, OfPrimitivesIsRefusedWithItsPlace)
{
    for (const char* name : {"draco_edgebreaker.glb", "draco_sequential.glb"}) {
        const auto refusal = [&](const std::function<void(Json & primitive, Opened&)>& change,
                                 const GltfLimits& limits = {}) {
            return refusalOfChanged(
                name, [&](Opened& file) { change(file.json["meshes"][0]["primitives"][0], file); }, limits);
        };
        const auto expect = [&](const char* reason, const std::string& is) {
            EXPECT_PRED_FORMAT2(testing::IsSubstring, reason, is) << name;
            EXPECT_PRED_FORMAT2(testing::IsSubstring, "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression",
                                is);
        };
        const auto extension = [](Json& primitive) -> Json& {
            return primitive["extensions"]["KHR_draco_mesh_compression"];
        };
        expect("its buffer view does not exist", refusal([&](Json& p, Opened&) { extension(p)["bufferView"] = 77U; }));
        expect("it compresses TANGENT, which the primitive does not have",
               refusal([&](Json& p, Opened&) { extension(p)["attributes"]["TANGENT"] = 0U; }));
        expect("its compressed data has not the attributes that the primitive names",
               refusal([&](Json& p, Opened&) { extension(p)["attributes"]["NORMAL"] = 55U; }));
        expect("an accessor of it does not exist",
               refusal([](Json& p, Opened&) { p["attributes"]["NORMAL"] = 4000U; }));
        expect("compressed primitives consist of triangles", refusal([](Json& p, Opened&) { p["mode"] = 0U; }));
        expect("it has 325 vertices, and an accessor of it has 324",
               refusal([](Json&, Opened& file) { file.json["accessors"][1]["count"] = 324U; }));
        expect("this must be an object", refusal([&](Json& p, Opened&) { extension(p)["attributes"] = 1U; }));
        const auto draco = [](Opened& file) {
            return file.bin.begin() + file.json["bufferViews"][1]["byteOffset"].get<std::ptrdiff_t>();
        };
        expect("its compressed data is broken", refusal([&](Json&, Opened& file) { *draco(file) = 'X'; }));
        expect("its compressed data is not of version 2.2 of Draco",
               refusal([&](Json&, Opened& file) { *(draco(file) + 5) = 1; }));
        expect("its compressed data is broken",
               refusal([](Json&, Opened& file) { file.json["bufferViews"][1]["byteLength"] = 200U; }));
        // The number of faces in the header of Draco is compared before memory is allocated.
        GltfLimits limits;
        limits.indices = 3 * 575;
        expect("the decoded mesh is too large", refusal([](Json&, Opened&) {}, limits));
    }
}

}  // namespace
}  // namespace vitrine::render
