// Illegal values in files. Each test first shows their effect if they were accepted.

#include "exhibits/exhibits.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/kit/surface_draw.h"
#include "exhibits/sdf_morph/sdf_morph_table.h"
#include "render/files/strict_json.h"
#include "render/glsl/cpu32.h"
#include "render/scene/gltf.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/stability/fields.h"
#include "tests/support/failures.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

namespace vitrine {
namespace {

using glm::vec3;
namespace f32 = glsl32;

const sdf_morph::SdfMorphTable table;

Preset read(const std::string& values)
{
    return parsePreset(
        "{\"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"sdf_morph\", \"name\": \"x\",\n\"values\": {" +
            values + "}}",
        "x.json", "sdf_morph", table);
}

TEST(HardCases, ANegativeSizeInAPresetIsBroughtIntoRangeAndSaid)
{
    // Inverted sizes: a distant point is inside of a box of negative size.
    EXPECT_GT(f32::sdfTorus(vec3(0.35F, 0, 0), 0.35F, -0.12F), 0);                     // No surface is left ...
    EXPECT_LT(f32::sdfBox(vec3(9, 0, 0), vec3(10, -1, -1)) + f32::sdfOnion(2, 5), 9);  // ... and bounds are wrong.
    int sizes = 0;
    for (const ParameterInfo& parameter : table.rows()) {
        if (parameter.unit != Unit::meter) continue;
        ++sizes;
        for (const char* bad : {"-0.1", "-1e300", "-0.0"}) {
            const Preset preset = read('"' + std::string(parameter.name) + "\": " + bad);
            const double kept = std::get<double>(preset.values.row(*table.find(parameter.name)));
            EXPECT_GE(kept, parameter.range.low) << parameter.name;
            EXPECT_GE(kept, 0) << parameter.name;
            if (kept != 0) {
                ASSERT_EQ(preset.notes.size(), 1U) << parameter.name << ' ' << bad;
                EXPECT_NE(preset.notes[0].find(parameter.name), std::string::npos);
            }
        }
    }
    EXPECT_GE(sizes, 8);
}

TEST(HardCases, NumbersThatAreNoneAreRefusedForEveryParameterOfEveryExhibit)
{
    // A clamp alone would accept NaN.
    const double infinity = std::numeric_limits<double>::infinity();
    const auto exhibits = allExhibits();
    int rows = 0;
    for (const auto& exhibit : exhibits) {
        const Parameters& of = exhibit->parameters();
        for (std::size_t i = 0; i < of.rows().size(); ++i) {
            const ParameterInfo& row = of.rows()[i];
            if (row.isWritten() || row.kind == Kind::toggle || row.kind == Kind::choice) continue;
            ++rows;
            SCOPED_TRACE(std::string(exhibit->name()) + '.' + std::string(row.name));
            const bool one = row.kind == Kind::real || row.kind == Kind::count;
            const auto with = [&](const std::string& value) {
                return parsePreset("{\"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"" +
                                       std::string(exhibit->name()) + "\", \"values\": {\n\"" + std::string(row.name) +
                                       "\": " + value + "}}",
                                   "x.json", exhibit->name(), of);
            };
            for (const char* bad : {"NaN", "Infinity", "-Infinity", "1e400", "null", "\"1\""})
                EXPECT_FAILURE(with(one ? bad : "[0, " + std::string(bad) + ", 1]"), "x.json, line 2");
            for (const double hostile : {std::nan(""), infinity, -infinity, -1e308}) {
                ParameterValues values = of.initial();
                if (one)
                    values.setParameter(i, hostile);
                else
                    values.setParameter(i, glm::dvec3(0, hostile, 1));
                EXPECT_EQ(nearestLegal(row, values.row(i)), values.row(i));
            }
        }
    }
    EXPECT_GT(rows, 20);
}

TEST(HardCases, ARefractiveIndexThatNoGlassHasIsRefusedOrBroughtIntoRange)
{
    // The inverse of an index of 0 is infinite, and refracted directions are NaN.
    for (const char* bad : {"0", "-1.5", "0.2", "1e300"}) {
        const Preset preset = read("\"refractiveIndex\": " + std::string(bad));
        const double index = preset.values[table.refractiveIndex];
        EXPECT_GE(index, 1) << bad;
        EXPECT_LE(index, 3) << bad;
        EXPECT_EQ(preset.notes.size(), 1U) << bad;
        EXPECT_TRUE(std::isfinite(f32::fresnelDielectric(0.5F, static_cast<float>(index))));
    }
    for (const char* bad : {"NaN", "null", "\"1.5\"", "1e400", "Infinity", "[1.5]", "true"})
        EXPECT_FAILURE(read("\"refractiveIndex\": " + std::string(bad)), "x.json, line 2");
    // The same for every number of the table, without knowing its meaning.
    ParameterValues values = table.initial();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const Value before = values.row(i);
        EXPECT_FALSE(values.setParameter(i, nan));
        EXPECT_EQ(values.row(i), before) << table.rows()[i].name;
    }
}

TEST(HardCases, AScaleOfZeroLeavesNormalsThatAreNumbers)
{
    const auto finite = [](const glm::dmat3& m) {
        return std::isfinite(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
    };
    for (const glm::dvec3 scale : {glm::dvec3(0), glm::dvec3(1, 0, 1), glm::dvec3(0, 0, 3), glm::dvec3(1, 1e-40, 1),
                                   glm::dvec3(1e-30), glm::dvec3(1e30)}) {
        glm::dmat3 m(0);
        for (int i = 0; i < 3; ++i) m[i][i] = scale[i];
        const glm::mat3 naive(glm::inverseTranspose(m));
        const bool broken = !finite(glm::dmat3(naive)) || !std::isfinite(glm::length(naive * vec3(1)));
        EXPECT_TRUE(broken || scale == glm::dvec3(1e30)) << scale.x;
        const glm::dmat3 ours(glm::mat3(normalMatrix(m)));
        EXPECT_TRUE(finite(ours));
        EXPECT_NEAR(std::max({glm::length(ours[0]), glm::length(ours[1]), glm::length(ours[2])}), 1, 1e-6);
    }
    // A surface that is flat along y has its normal along y. Others use the inverse transpose.
    EXPECT_EQ(glm::normalize(normalMatrix(glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 1)) * glm::dvec3(0.6, 0.8, 0)),
              glm::dvec3(0, 1, 0));
    test::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const glm::dmat3 m(random.point(2), random.point(2), random.point(2));
        const glm::dvec3 n = random.direction();
        EXPECT_GT(glm::dot(glm::normalize(normalMatrix(m) * n), glm::normalize(glm::inverseTranspose(m) * n)),
                  1 - 1e-9);
    }
    // NaN is refused while reading.
    EXPECT_FAILURE(read("\"boxSize\": NaN"), "x.json, line 2");
    test::GltfBuilder builder;
    builder.node(
        {{"name", "huge"}, {"mesh", builder.triangle()}, {"scale", render::Json::parse("[1e300, 1e300, 1e300]")}});
    builder.node({{"name", "inside"}, {"mesh", 0}, {"scale", render::Json::parse("[1e300, 1e300, 1e300]")}});
    builder.json["nodes"][0]["children"] = {1};
    builder.json["scenes"][0]["nodes"] = {0};
    EXPECT_FAILURE(render::parseGltf(builder.glb(), "model.glb"), "model.glb");
}

TEST(HardCases, AChainOfTenThousandIsRefusedWithoutAStack)
{
    const auto nested = [](int depth) {
        std::string text;
        for (int i = 0; i < depth; ++i) text += R"({"left":)";
        text += '1';
        return text.append(static_cast<std::size_t>(depth), '}');
    };
    // Stack use of a recursive reader: some hundred bytes for each level.
    const std::function<int(const std::string&, std::size_t)> naive = [&naive](const std::string& text,
                                                                               std::size_t at) -> int {
        return at < text.size() && text[at] == '{' ? 1 + naive(text, at + 8) : 0;
    };
    EXPECT_EQ(naive(nested(10'000), 0), 10'000);
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(std::exit(naive(nested(3'000'000), 0) == 0 ? 0 : 1), "");

    EXPECT_NO_THROW((void)render::parseJson(nested(63), "scene.json"));
    for (const int depth : {10'000, 3'000'000})
        EXPECT_FAILURE(render::parseJson(nested(depth), "scene.json", {.bytes = 1U << 30U}), "scene.json, line 1");
    EXPECT_FAILURE(render::parseGltf("{\"extras\":" + nested(10'000) + "}", "model.gltf"), "model.gltf, line 1");
    EXPECT_FAILURE(parsePreset(nested(10'000), "x.json", "sdf_morph", table), "x.json, line 1");
}

}  // namespace
}  // namespace vitrine
