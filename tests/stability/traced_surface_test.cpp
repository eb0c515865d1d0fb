// Normals of traced surfaces, and rays that start on them.

#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace vitrine {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;
using Field = std::function<double(const dvec3&)>;

TEST(Normals, StayAccurateFarAway)
{
    // A sphere at 200 m: rounding of positions exceeds a step of 1e-5 m.
    const vec3 center(0, 0, -200);
    f32::Tracer tracer{[=](const vec3& p) { return f32::sdfSphere(p - center, 20); }};
    const auto settings = tracer.marchSettings(0, 400, 0.4F / 600);
    std::vector<double> naive;
    std::vector<double> ours;
    test::Random random(14);
    for (int i = 0; i < 2000; ++i) {
        const vec3 ray = glm::normalize(center + vec3(random.point(12)));
        const auto march = tracer.sphereTrace(vec3(0), ray, settings);
        if (!march.hit) continue;
        const vec3 p = ray * march.t;
        const dvec3 truth = glm::normalize(dvec3(p - center));
        const auto off = [&](float h) {
            return glm::degrees(
                f64::safeAcos(glm::dot(truth, dvec3(tracer.fieldNormal(p, h, tracer.NORMAL_CENTRAL, -ray)))));
        };
        naive.push_back(off(1e-5F));
        ours.push_back(off(tracer.normalStep(march.t, settings)));
    }
    ASSERT_GT(ours.size(), 1000U);
    std::sort(naive.begin(), naive.end());
    std::sort(ours.begin(), ours.end());
    EXPECT_GT(naive[naive.size() * 95 / 100], 10);
    EXPECT_LT(ours[ours.size() * 95 / 100], 0.1);
}

TEST(Normals, AllMethodsAgreeOnSmoothFieldsAndCentralOnesLeanLeastAtCreases)
{
    auto ball = f64::Tracer<Field>{[](const dvec3& p) { return f64::sdfSphere(p, 0.7); }};
    auto box = f64::Tracer<Field>{[](const dvec3& p) { return f64::sdfBox(p, dvec3(0.5)); }};
    test::Random random(15);
    for (int i = 0; i < 500; ++i) {
        const dvec3 p = random.direction() * 0.7;
        for (int method = 0; method < 3; ++method)
            EXPECT_GT(glm::dot(ball.fieldNormal(p, 1e-4, method, dvec3(0, 0, 1)), p / 0.7), 1 - 1e-7);
    }
    // On a face near an edge. Differences along the axes ignore an edge that is farther away than the step. Nearer to
    // it they tilt, central ones the least.
    const dvec3 up(0, 0, 1);
    const double h = 1e-4;
    double lean[3] = {};
    for (int i = 0; i < 400; ++i) {
        const dvec3 p(0.5, 0.5 - h * random.number(0, 1), random.number(-0.4, 0.4));
        for (int method = 0; method < 3; ++method)
            lean[method] += glm::degrees(f64::safeAcos(box.fieldNormal(p, h, method, up).x)) / 400;
    }
    EXPECT_LT(lean[box.NORMAL_CENTRAL], lean[box.NORMAL_TETRAHEDRON]);
    EXPECT_LT(lean[box.NORMAL_CENTRAL], lean[box.NORMAL_FORWARD]);
    EXPECT_NEAR(box.fieldNormal(dvec3(0.5, 0.5 - 1.1 * h, 0), h, box.NORMAL_CENTRAL, up).x, 1, 1e-9);
}

TEST(Reflection, APlaneInAConstantSceneReflectsWithoutAcne)
{
    // Mirror floor under a white sky: each reflected ray must leave the floor.
    f32::Tracer tracer{[](const vec3& p) { return p.y; }};
    int acne = 0;
    int naive = 0;
    test::Random random(16);
    for (int i = 0; i < 5000; ++i) {
        const vec3 eye(float(random.number(-50, 50)), float(random.number(0.1, 3)), float(random.number(-50, 50)));
        vec3 ray(random.direction());
        ray.y = -std::abs(ray.y) - 0.005F;
        ray = glm::normalize(ray);
        auto settings = tracer.marchSettings(0, 1000, 1e-3F);
        settings.stepLimit = 500;
        const auto march = tracer.sphereTrace(eye, ray, settings);
        if (!march.hit) continue;
        const vec3 p = eye + ray * march.t;
        const vec3 reflected(ray.x, -ray.y, ray.z);
        auto again = tracer.marchSettings(0, 1000, 1e-3F);
        again.traveled = march.t;
        again.stepLimit = 500;
        acne += tracer.sphereTrace(p, reflected, again).hit;
        naive += tracer.fieldDistance(p) < tracer.hitTolerance(march.t, settings);  // The ray hits at its start.
    }
    EXPECT_GT(naive, 4000);
    EXPECT_EQ(acne, 0);
}

TEST(Reflection, ACorridorOfMirrorsAddsNoEnergy)
{
    // Two facing mirrors with a white sky at the open ends. With reflectance 1 the light is 1 after any number of
    // bounces; with Schlick's it is at most 1.
    f32::Tracer tracer{[](const vec3& p) { return 1 - std::abs(p.x); }};
    test::Random random(17);
    for (int i = 0; i < 300; ++i) {
        vec3 p(float(random.number(-0.5, 0.5)), float(random.number(-1, 1)), 0);
        vec3 ray(random.direction());
        float weight = 1;
        float metal = 1;
        float light = 0;
        float metalLight = 0;
        float traveled = 0;
        for (int bounce = 0; bounce <= 4; ++bounce) {
            auto settings = tracer.marchSettings(0, 50, 1e-3F);
            settings.traveled = traveled;
            const auto march = tracer.sphereTrace(p, ray, settings);
            if (!march.hit || bounce == 4) {
                light += weight;
                metalLight += metal;
                break;
            }
            p = p + ray * march.t;
            traveled += march.t;
            const vec3 n = tracer.fieldNormal(p, tracer.normalStep(march.t, settings), tracer.NORMAL_CENTRAL, -ray);
            EXPECT_LT(glm::dot(n, ray), 0.01F);
            weight *= f32::schlick(-glm::dot(ray, n), 0.9F);
            ray = glm::normalize(glm::reflect(ray, n));
        }
        EXPECT_LE(light, 1 + 1e-5F);
        EXPECT_FLOAT_EQ(metalLight, 1);
    }
}

}  // namespace
}  // namespace vitrine
