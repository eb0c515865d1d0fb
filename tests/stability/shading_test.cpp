// Soft shadows and ambient occlusion compared with brute force at float64.

#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vitrine {
namespace {

using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;

/// Returns the distance to a ball and a bar over a floor.
double scene(const dvec3& p)
{
    return std::min({p.y, f64::sdfSphere(p - dvec3(0, 0.9, 0), 0.35),
                     f64::sdfCapsule(p, dvec3(-1, 0.6, 0.6), dvec3(1, 0.6, 0.6), 0.06)});
}

TEST(Shadows, TheSignedMethodComesNearestToALightWithExtentAndCostsNoMore)
{
    int calls = 0;
    f64::Tracer tracer{[&](const dvec3& p) {
        ++calls;
        return scene(p);
    }};
    const dvec3 toLight = glm::normalize(dvec3(0.3, 1, 0.1));
    const double tanRadius = 0.08;
    double square[5] = {};
    double evaluations[5] = {};
    int penumbra = 0;
    for (int y = -30; y < 30; ++y) {
        for (int x = -30; x < 30; ++x) {
            const dvec3 p(x * 0.04, 1e-3, y * 0.04);
            const double truth = tracer.shadowArea(p, toLight, tanRadius, 1e-3, 4, 400, 300, 0).visibility;
            if (truth <= 0 || truth >= 1) continue;
            ++penumbra;
            calls = 0;
            const decltype(tracer.shadowHard(p, toLight, 0, 0, 0)) found[] = {
                tracer.shadowHard(p, toLight, 1e-3, 4, 400), tracer.shadowClassic(p, toLight, tanRadius, 1e-3, 4, 400),
                tracer.shadowAaltonen(p, toLight, tanRadius, 1e-3, 4, 400),
                tracer.shadowSigned(p, toLight, tanRadius, 1e-3, 4, 400),
                tracer.shadowArea(p, toLight, tanRadius, 1e-3, 4, 400, 16, 1)};
            int counted = 0;
            for (int i = 0; i < 5; ++i) {
                ASSERT_GE(found[i].visibility, 0);
                ASSERT_LE(found[i].visibility, 1);
                square[i] += (found[i].visibility - truth) * (found[i].visibility - truth);
                evaluations[i] += found[i].evaluations;
                counted += found[i].evaluations;
            }
            ASSERT_EQ(counted, calls);
        }
    }
    ASSERT_GT(penumbra, 100);
    const auto rmse = [&](int i) { return std::sqrt(square[i] / penumbra); };
    EXPECT_LT(rmse(3), 0.12);
    EXPECT_LT(rmse(3), rmse(0) / 2);
    EXPECT_LT(rmse(3), rmse(1) / 2);
    EXPECT_LT(rmse(3), rmse(2) / 2);
    EXPECT_LT(rmse(4), rmse(3));
    EXPECT_LT(evaluations[3], evaluations[0] * 1.25);
}

TEST(Shadows, APointHalfBehindAStraightEdgeSeesHalfTheLight)
{
    // Closed form: a half-space whose edge passes through the center of the light's disk.
    f64::Tracer tracer{[](const dvec3& p) { return f64::sdfBox(p - dvec3(-5, 1.15, 0), dvec3(5, 0.15, 5)); }};
    const dvec3 up(0, 1, 0);
    EXPECT_NEAR(tracer.shadowSigned(dvec3(0), up, 0.1, 0.01, 5, 400).visibility, 0.5, 0.02);
    EXPECT_NEAR(tracer.shadowSigned(dvec3(-0.14, 0, 0), up, 0.1, 0.01, 5, 400).visibility, 0, 0.02);
    EXPECT_NEAR(tracer.shadowSigned(dvec3(0.14, 0, 0), up, 0.1, 0.01, 5, 400).visibility, 1, 0.02);
    EXPECT_NEAR(tracer.shadowArea(dvec3(0), up, 0.1, 0.01, 5, 400, 64, 0).visibility, 0.5, 0.05);
    // Documented limit of the method: a sheet much thinner than the light lets half of it through.
    f64::Tracer sheet{[](const dvec3& p) { return f64::sdfBox(p - dvec3(-5, 1, 0), dvec3(5, 0.001, 5)); }};
    EXPECT_NEAR(sheet.shadowSigned(dvec3(-1, 0, 0), up, 0.1, 0.01, 5, 400).visibility, 0.5, 0.05);
    EXPECT_EQ(sheet.shadowArea(dvec3(-1, 0, 0), up, 0.1, 0.01, 5, 400, 16, 0).visibility, 0);
}

TEST(Shadows, StartsAtZeroAndLightsWithoutExtentGiveNumbers)
{
    f32::Tracer tracer{[](const vec3& p) { return float(scene(glm::dvec3(p))); }};
    EXPECT_TRUE(std::isnan(0.0F / (0.06F * 0.0F)));  // The quotient h / (w t) at the start.
    test::Random random(3);
    for (int i = 0; i < 3000; ++i) {
        const vec3 p(random.point(1));
        const vec3 l(i % 7 == 0 ? dvec3(0, 0, -1) : random.direction());
        for (const float width : {0.0F, 0.05F, 1e6F}) {
            for (const float visibility :
                 {tracer.shadowHard(p, l, 0, 3, 64).visibility, tracer.shadowClassic(p, l, width, 0, 3, 64).visibility,
                  tracer.shadowAaltonen(p, l, width, 0, 3, 64).visibility,
                  tracer.shadowSigned(p, l, width, 0, 3, 64).visibility,
                  tracer.shadowArea(p, l, width, 0, 3, 64, 3, 0).visibility}) {
                ASSERT_GE(visibility, 0);
                ASSERT_LE(visibility, 1);
            }
        }
    }
    EXPECT_EQ(tracer.shadowArea(vec3(0), vec3(0, 1, 0), 0.1F, 0.01F, 3, 64, 0, 0).visibility, 1);
    EXPECT_EQ(tracer.shadowSigned(vec3(0, 5, 0), vec3(0, 1, 0), 0.1F, 0.01F, 0, 64).evaluations,
              0);  // Nothing is between p and the light.
}

TEST(Occlusion, IsOneWithoutARadiusAndStaysBetweenZeroAndOne)
{
    f32::Tracer tracer{[](const vec3& p) { return float(scene(glm::dvec3(p))); }};
    test::Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const vec3 p(random.point(1));
        const vec3 n(random.direction());
        EXPECT_EQ(tracer.fieldOcclusion(p, n, 0), 1);
        EXPECT_EQ(tracer.fieldOcclusion(p, n, -1), 1);
        for (const float radius : {1e-6F, 0.3F, 1e6F}) {
            ASSERT_GE(tracer.fieldOcclusion(p, n, radius), 0);
            ASSERT_LE(tracer.fieldOcclusion(p, n, radius), 1);
        }
    }
}

TEST(Occlusion, AnOpenFloorIsOpenAndADeepSlotIsDark)
{
    int calls = 0;
    f64::Tracer floor{[&](const dvec3& p) {
        ++calls;
        return p.y;
    }};
    EXPECT_DOUBLE_EQ(floor.fieldOcclusion(dvec3(0), dvec3(0, 1, 0), 1), 1);
    EXPECT_EQ(calls, 5);
    f64::Tracer slot{[](const dvec3& p) { return std::min(p.y, 0.02 - std::abs(p.x)); }};
    EXPECT_LT(slot.fieldOcclusion(dvec3(0), dvec3(0, 1, 0), 1), 0.35);
}

}  // namespace
}  // namespace vitrine
