#include "exhibits/sdf_morph/torus_mug_cpu.h"
#include "exhibits/sdf_morph/torus_mug_cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;
using Field = std::function<double(const dvec3&)>;
using Field32 = std::function<float(const vec3&)>;

constexpr double pixelCone = 0.5 / 180 * 0.9;  // For pictures about 180 lines high.

f64::TorusMug mug()
{
    return {1, 0.35, 0.12, 0.28, 0.66, 0.045, 0.165, 0.09, 0.06};
}

struct Scene {
    const char* name;
    Field32 field;
    Field exact;
};

/// Returns a field at both precisions from one generic lambda, whose point type decides.
template <typename Make> Scene scene(const char* name, Make make)
{
    return {name, [make](const vec3& p) { return float(make(p)); }, [make](const dvec3& p) { return double(make(p)); }};
}

/// Fields with thin parts, creases, grazing planes and inexact bounds.
std::vector<Scene> scenes()
{
    const auto shape64 = f64::torusMugShape(mug());
    const auto shape32 = f32::torusMugShape({1, 0.35F, 0.12F, 0.28F, 0.66F, 0.045F, 0.165F, 0.09F, 0.06F});
    return {
        {"mug", [=](const vec3& p) { return f32::sdfTorusMug(p, shape32); },
         [=](const dvec3& p) { return f64::sdfTorusMug(p, shape64); }},
        scene("floor and frame",
              [](const auto& p) {
                  if constexpr (sizeof(p.x) == 4)
                      return std::min(p.y + 0.45F, f32::sdfBoxFrame(p, vec3(0.4F), 0.04F));
                  else
                      return std::min(p.y + 0.45, f64::sdfBoxFrame(p, dvec3(0.4), 0.04));
              }),
        scene("cut box",
              [](const auto& p) {
                  if constexpr (sizeof(p.x) == 4)
                      return f32::sdfSubtraction(f32::sdfBox(p, vec3(0.4F)), f32::sdfSphere(p, 0.5F));
                  else
                      return f64::sdfSubtraction(f64::sdfBox(p, dvec3(0.4)), f64::sdfSphere(p, 0.5));
              }),
        scene("a third of the distance",
              [](const auto& p) {
                  if constexpr (sizeof(p.x) == 4)
                      return 0.3F * f32::sdfTorus(p, 0.4F, 0.1F);
                  else
                      return 0.3 * f64::sdfTorus(p, 0.4, 0.1);
              }),
    };
}

struct Camera {
    dvec3 eye;
    dvec3 forward, right, up;
    Camera(const dvec3& from, const dvec3& at) : eye(from), forward(glm::normalize(at - from))
    {
        right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0)));
        up = glm::cross(right, forward);
    }
    [[nodiscard]] dvec3 ray(double x, double y, int size) const
    {
        return glm::normalize(forward + right * ((2 * x / size - 1) * 0.45) + up * ((1 - 2 * y / size) * 0.45));
    }
};

f64::Tracer<Field> exactTracer(const Field& field)
{
    return {field};
}

/// Returns whether a ray hits, by Hart's method with a tolerance far below a pixel.
bool trulyHits(const Field& field, const dvec3& origin, const dvec3& direction, double end)
{
    auto tracer = exactTracer(field);
    auto settings = tracer.marchSettings(0, end, 0);
    settings.toleranceFloor = 1e-8;
    settings.stepLimit = 20000;
    settings.relaxation = tracer.RELAXATION_NONE;
    return tracer.sphereTrace(origin, direction, settings).hit;
}

TEST(SphereTracing, NoRelaxationEverMissesAHitAndCountersAreExact)
{
    for (const Scene& s : scenes()) {
        SCOPED_TRACE(s.name);
        int calls = 0;
        f32::Tracer tracer{[&](const vec3& p) {
            ++calls;
            return s.field(p);
        }};
        const Camera camera({1.3, 0.7, 1.6}, {0, 0, 0});
        int hits = 0;
        std::vector<int> missed(4);
        std::vector<int> evaluations(4);
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 100; ++x) {
                const dvec3 ray = camera.ray(x + 0.5, y + 0.5, 100);
                const bool truth = trulyHits(s.exact, camera.eye, ray, 20);
                hits += truth;
                for (int variant = 0; variant < 4; ++variant) {
                    auto settings = tracer.marchSettings(0, 20, 0.45F / 100);
                    settings.stepLimit = 400;
                    settings.relaxation = std::min(variant, 2);
                    settings.omega = 1.6F;
                    if (variant == 3) settings.stepLimit = 64;
                    calls = 0;
                    const auto march = tracer.sphereTrace(vec3(camera.eye), vec3(ray), settings);
                    ASSERT_EQ(calls, march.evaluations);
                    ASSERT_LE(march.steps, march.evaluations);
                    ASSERT_TRUE(std::isfinite(march.t));
                    missed[std::size_t(variant)] += truth && !march.hit;
                    evaluations[std::size_t(variant)] += march.evaluations;
                }
            }
        }
        EXPECT_GT(hits, 500);
        EXPECT_EQ(missed, std::vector<int>(4));
        EXPECT_LT(evaluations[2], evaluations[0]) << "automatic relaxation costs more than none";
    }
}

TEST(SphereTracing, HitsLieWithinTheToleranceOfTheSurface)
{
    for (const Scene& s : scenes()) {
        SCOPED_TRACE(s.name);
        f32::Tracer tracer{s.field};
        test::Random random(4);
        for (int i = 0; i < 5000; ++i) {
            const dvec3 origin = random.direction() * 2.0;
            if (s.exact(origin) < 0.1) continue;
            const vec3 ray(glm::normalize(random.point(0.5) - origin));
            const auto settings = tracer.marchSettings(0, 20, float(pixelCone));
            const auto march = tracer.sphereTrace(vec3(origin), ray, settings);
            if (!march.hit || march.exhausted) continue;
            EXPECT_LE(std::abs(s.exact(origin + dvec3(ray) * double(march.t))),
                      tracer.hitTolerance(march.t, settings) + 1e-6);
        }
    }
}

TEST(RayBox, StartsWhereTheRayIsInsideWhereverTheCameraIs)
{
    auto tracer = exactTracer([](const dvec3&) { return 1.0; });
    const dvec3 low(-1, -2, -3);
    const dvec3 high(1, 2, 3);
    const auto expectSpan = [&](const dvec3& origin, const dvec3& direction, double from, double to) {
        const dvec2 span = glsl::rayBox(origin, direction, low, high);
        EXPECT_DOUBLE_EQ(span.x, from);
        EXPECT_DOUBLE_EQ(span.y, to);
    };
    const auto misses = [&](const dvec3& origin, const dvec3& direction) {
        const dvec2 span = glsl::rayBox(origin, direction, low, high);
        return span.x > span.y;
    };
    expectSpan({0, 0, 10}, {0, 0, -1}, 7, 13);
    expectSpan({0, 0, 0}, {0, 0, -1}, 0, 3);
    expectSpan({0, 0, 3}, {0, 0, -1}, 0, 6);           // On the face.
    expectSpan({0.999, 0, 10}, {0, 0, -1}, 7, 13);     // Along a face, inside.
    EXPECT_TRUE(misses({0, 0, 10}, {0, 0, 1}));        // Behind the camera.
    EXPECT_TRUE(misses({1.001, 0, 10}, {0, 0, -1}));   // Along a face, outside.
    EXPECT_TRUE(std::isnan((1.0 - 1.0) * (1 / 0.0)));  // The plain slab test fails exactly on a face.
    for (const double x : {-1.0, 1.0}) {
        const dvec2 span = glsl::rayBox({x, 0, 10}, {0, 0, -1}, low, high);
        EXPECT_TRUE(test::isFinite(span.x) && test::isFinite(span.y));
    }

    // Compared with brute force: points along the ray that are inside.
    test::Random random(8);
    for (int i = 0; i < 2000; ++i) {
        const dvec3 origin = random.point(5);
        const dvec3 direction = random.direction();
        const dvec2 span = glsl::rayBox(origin, direction, low, high);
        for (int k = 0; k < 60; ++k) {
            const double t = k * 0.25 + 0.01;
            const dvec3 p = origin + direction * t;
            const bool inside = glm::all(glm::lessThan(low, p)) && glm::all(glm::lessThan(p, high));
            ASSERT_EQ(inside, span.x < t && t < span.y);
        }
    }
}

/// H1: the area of the mug in the picture while the camera moves through its bounding box.
TEST(RayBox, TheSilhouetteGrowsSteadilyWhileTheCameraPassesThroughTheBox)
{
    const auto shape = f64::torusMugShape(mug());
    auto tracer = exactTracer([&](const dvec3& p) { return f64::sdfTorusMug(p, shape); });
    const auto box = f64::torusMugBox(shape);
    const dvec3 low = box.center - box.halfSize;
    const dvec3 high = box.center + box.halfSize;
    constexpr int size = 80;
    const auto covered = [&](double z, bool frontFaces) {
        const Camera camera({0.12, -0.1, z}, {0.12, -0.1, 0});
        int count = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const dvec3 ray = camera.ray(x + 0.5, y + 0.5, size);
                const dvec2 span = glsl::rayBox(camera.eye, ray, low, high);
                // A rasterized front face is missing once the camera has passed it.
                if (span.x > span.y || (frontFaces && span.x == 0)) continue;
                count += tracer.sphereTrace(camera.eye, ray, tracer.marchSettings(span.x, span.y, 0.45 / size)).hit;
            }
        return count;
    };
    const double face = high.z;
    EXPECT_GT(covered(face + 0.001, true), 0);
    EXPECT_EQ(covered(face - 0.001, true), 0);  // The object disappears.
    int previous = covered(face + 0.02, false);
    for (double z = face + 0.0175; z > face - 0.02; z -= 0.0025) {
        const int now = covered(z, false);
        EXPECT_LT(std::abs(now - previous), size * size / 100) << "camera at " << z;
        previous = now;
    }
}

TEST(RayBox, TheNearPlaneMakesNoDifference)
{
    // A ray that starts on the rasterized hull cannot start before the near plane. The analytic start has no such
    // limit.
    auto tracer = exactTracer([](const dvec3& p) { return f64::sdfSphere(p, 0.5); });
    const dvec3 eye(0, 0, 0.8);
    const dvec3 ray(0, 0, -1);
    const auto fromHull = [&](double nearPlane) {
        const double hull = eye.z - 0.55;
        if (hull < nearPlane) return false;  // Clipped: no fragment, and a hole in the picture.
        return tracer.sphereTrace(eye, ray, tracer.marchSettings(hull, 5, 1e-3)).hit;
    };
    EXPECT_TRUE(fromHull(0.01));
    EXPECT_FALSE(fromHull(0.5));
    const dvec2 span = glsl::rayBox(eye, ray, dvec3(-0.55), dvec3(0.55));
    EXPECT_TRUE(tracer.sphereTrace(eye, ray, tracer.marchSettings(span.x, span.y, 1e-3)).hit);
}

TEST(SphereTracing, ACameraInsideTheSolidSeesItsInside)
{
    const Field sphere = [](const dvec3& p) { return f64::sdfSphere(p, 0.5); };
    // The plain loop walks backwards without an end.
    double t = 0;
    int steps = 0;
    for (; steps < 1000 && t > -100; ++steps) {
        const double d = sphere(dvec3(0.1, 0, 0) + dvec3(1, 0, 0) * t);
        if (std::abs(d) < 1e-4) break;
        t += d;
    }
    EXPECT_LT(t, 0);

    auto tracer = exactTracer(sphere);
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const dvec3 origin = random.direction() * random.number(0, 0.45);
        const dvec3 ray = random.direction();
        const auto march = tracer.sphereTrace(origin, ray, tracer.marchSettings(0, 10, 1e-3));
        ASSERT_TRUE(march.hit);
        ASSERT_EQ(march.side, -1);
        ASSERT_NEAR(glm::length(origin + ray * march.t), 0.5, 2e-3);
        ASSERT_LT(march.evaluations, 60);
    }
    // A box that cuts the solid shows the cut, and not the far wall.
    const auto cut = tracer.sphereTrace(dvec3(0, 0, 3), dvec3(0, 0, -1), tracer.marchSettings(2.8, 6, 1e-3));
    EXPECT_TRUE(cut.hit);
    EXPECT_DOUBLE_EQ(cut.t, 2.8);
}

TEST(SphereTracing, ARayThatStartsOnTheSurfaceDoesNotHitItsOwnStart)
{
    auto tracer = exactTracer(
        [](const dvec3& p) { return std::min(f64::sdfSphere(p, 0.5), f64::sdfSphere(p - dvec3(0, 2, 0), 0.5)); });
    test::Random random(6);
    int toOther = 0;
    for (int i = 0; i < 5000; ++i) {
        const dvec3 normal = random.direction();
        const dvec3 origin = normal * 0.5;
        const dvec3 ray = random.direction();
        if (std::abs(glm::dot(ray, normal)) < 0.05) continue;  // Grazing rays may have either result.
        const auto march = tracer.sphereTrace(origin, ray, tracer.marchSettings(0, 10, 1e-3));
        const bool outward = glm::dot(ray, normal) > 0;
        if (!outward) {
            EXPECT_TRUE(march.hit);
        } else if (march.hit) {
            EXPECT_GT(march.t, 0.9);
            ++toOther;
        }
        EXPECT_TRUE(test::isFinite(tracer.fieldNormal(origin + ray * march.t, 3e-4, 2, -ray)));
    }
    EXPECT_GT(toOther, 20);
    // The naive loop stops at once, because its first distance is 0.
    EXPECT_LE(tracer.fieldDistance(dvec3(0.5, 0, 0)), 0);
}

TEST(SphereTracing, GrazingFloorsGetNoHolesFromTheStepLimit)
{
    // From the horizon to the foreground over a floor with wires on it, at most 64 steps.
    const Field32 field = [](const vec3& p) {
        return std::min(p.y, f32::sdfCapsule(p, vec3(-20, 0.3F, -15), vec3(20, 0.3F, -15), 0.05F));
    };
    f32::Tracer tracer{field};
    const vec3 eye(0, 0.25F, 0);
    constexpr int lines = 200;
    const float cone = 0.3F / lines;
    int naive = 0;
    int missed = 0;
    int invented = 0;
    for (int y = 0; y < lines; ++y) {
        for (int x = 0; x < 60; ++x) {
            const vec3 ray =
                glm::normalize(vec3((float(x) - 30) * cone * 2, (lines * 0.5F - float(y) - 0.5F) * cone * 2, -1));
            const bool floor = ray.y < 0 && eye.y / -ray.y < 100;
            auto settings = tracer.marchSettings(0, 100, cone);
            settings.stepLimit = 64;
            settings.relaxation = tracer.RELAXATION_NONE;
            const auto march = tracer.sphereTrace(eye, ray, settings);
            naive += floor && (!march.hit || march.exhausted);
            missed += floor && !march.hit;
            const double wire = std::abs(ray.y * (15 / -ray.z) + eye.y - 0.3);
            invented += ray.y > 0.01F && wire > 0.3 && march.hit;
        }
    }
    EXPECT_GT(naive, 20);
    EXPECT_EQ(missed, 0);
    EXPECT_EQ(invented, 0);
}

TEST(SphereTracing, ThinWiresFarAwayAreNotLost)
{
    // A wire of 1 cm at 30 m, far from the origin, where float32 positions are coarse.
    const vec3 offset(3000, 1.5F, -4000);
    constexpr float cone = 0.4F / 600;
    int naive = 0;
    int found = 0;
    int truth = 0;
    for (int k = 0; k < 20; ++k) {
        const float away = 30 + float(k) * 0.0317F;
        f32::Tracer tracer{[=](const vec3& p) {
            return f32::sdfInfiniteCylinder(vec3(p.x - offset.x, p.y, p.z - offset.z + away), 0.01F);
        }};
        for (int x = -40; x <= 40; ++x) {
            const vec3 ray = glm::normalize(vec3(float(x) * cone * 0.05F, 0.013F, -1));
            const double passes = std::abs(ray.x) / std::hypot(ray.x, ray.z) * away;  // Closest distance to the axis.
            if (passes >= 0.009) continue;
            ++truth;
            auto settings = tracer.marchSettings(0, 60, cone);
            found += tracer.sphereTrace(offset, ray, settings).hit;
            // The usual loop: because of rounding, distances never become this small.
            float t = 0;
            for (int i = 0; i < 128 && t < 60; ++i) {
                const float d = tracer.fieldDistance(offset + ray * t);
                if (std::abs(d) < 1e-5F) {
                    ++naive;
                    break;
                }
                t += d;
            }
        }
    }
    EXPECT_GT(truth, 200);
    EXPECT_LT(naive, truth / 2);
    EXPECT_EQ(found, truth);
}

TEST(SphereTracing, RaysThatTouchASphereCostABoundedNumberOfSteps)
{
    int naive = 0;
    int longest = 0;
    auto tracer = exactTracer([](const dvec3& p) { return f64::sdfSphere(p, 1); });
    for (double past = -1e-6; past <= 1e-6; past += 1e-8) {
        const dvec3 origin(-5, 1 + past, 0);
        auto settings = tracer.marchSettings(0, 20, pixelCone);
        settings.stepLimit = 2000;
        longest = std::max(longest, tracer.sphereTrace(origin, dvec3(1, 0, 0), settings).evaluations);
        settings.pixelCone = 0;
        settings.toleranceFloor = 1e-12;
        settings.relaxation = tracer.RELAXATION_NONE;
        naive = std::max(naive, tracer.sphereTrace(origin, dvec3(1, 0, 0), settings).evaluations);
    }
    EXPECT_GT(naive, 1500);
    EXPECT_LT(longest, 40);
}

TEST(SphereTracing, NothingOfABundleIsHitBeforeWhereItsConeStops)
{
    for (const Scene& s : scenes()) {
        SCOPED_TRACE(s.name);
        int calls = 0;
        f32::Tracer tracer{[&](const vec3& p) {
            ++calls;
            return s.field(p);
        }};
        test::Random random(12);
        int useful = 0;
        int empty = 0;
        for (int i = 0; i < 1500; ++i) {
            const dvec3 eye = random.direction() * random.number(0.8, 4);
            if (s.exact(eye) < 0.05) continue;
            const dvec3 axis = glm::normalize(random.point(0.8) - eye);
            const double chord = std::pow(10.0, random.number(-3, -1));
            const auto settings = tracer.marchSettings(0, 12, float(pixelCone));
            calls = 0;
            const auto cone = tracer.coneMarch(vec3(eye), vec3(axis), float(chord) * 1.0001F, settings);
            ASSERT_EQ(calls, cone.evaluations);
            ASSERT_LE(cone.evaluations, 64);
            useful += !cone.empty && cone.t > 0.5;
            empty += cone.empty;
            const double end = cone.empty ? 12 : double(cone.t);
            for (int k = 0; k < 12; ++k) {
                const dvec3 ray =
                    glm::normalize(axis + random.direction() * chord * 0.99 * (k < 4 ? 1.0 : random.number(0, 1)));
                if (glm::length(ray - axis) > chord) continue;
                for (int j = 0; j < 200; ++j) {
                    const double t = end * j / 200.0;
                    ASSERT_GT(s.exact(eye + ray * t), -1e-6) << "t " << t << " of " << end;
                }
            }
        }
        EXPECT_GT(useful, 50);
        if (std::string(s.name) != "floor and frame") {
            EXPECT_GT(empty, 50);
        }
    }
}

TEST(SphereTracing, ABundleAndABoxMeetWhereAnyOfItsRaysDoes)
{
    auto tracer = exactTracer([](const dvec3&) { return 1.0; });
    const dvec3 low(-0.5, -0.3, -0.4);
    const dvec3 high(0.4, 0.6, 0.5);
    test::Random random(13);
    for (int i = 0; i < 3000; ++i) {
        const dvec3 eye = random.point(3);
        const dvec3 axis = random.direction();
        const double chord = random.number(0, 0.2);
        const dvec2 bundle = tracer.coneBox(eye, axis, chord, low, high);
        for (int k = 0; k < 10; ++k) {
            const dvec3 ray = glm::normalize(axis + random.direction() * chord * random.number(0, 1));
            if (glm::length(ray - axis) > chord) continue;
            const dvec2 span = glsl::rayBox(eye, ray, low, high);
            if (span.x > span.y) continue;
            ASSERT_LE(bundle.x, span.x + 1e-12);
            ASSERT_GE(bundle.y, span.y - 1e-12);
        }
    }
}

}  // namespace
}  // namespace vitrine
