// Sizes, blends and weights at the ends of their ranges. Each test first shows the failure of the plain formula.

#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace vitrine {
namespace {

using glm::dvec3;
using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;
using test::isFinite;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Commonly used formulas, as negative controls.
namespace naive {

float smoothUnion(float a, float b, float k)
{
    const float h = std::max(k - std::abs(a - b), 0.0F) / k;
    return std::min(a, b) - h * h * k * 0.25F;
}

float ellipsoid(vec3 p, vec3 r)
{
    const float k0 = glm::length(p / r);
    return k0 * (k0 - 1) / glm::length(p / (r * r));
}

float capsule(vec3 p, vec3 a, vec3 b, float r)
{
    const vec3 pa = p - a, ba = b - a;
    return glm::length(pa - ba * std::min(std::max(glm::dot(pa, ba) / glm::dot(ba, ba), 0.0F), 1.0F)) - r;
}

float cappedCone(vec3 p, float h, float r1, float r2)
{
    const glm::vec2 q(glm::length(glm::vec2(p.x, p.z)), p.y), k1(r2, h), k2(r2 - r1, 2 * h);
    const glm::vec2 cb = q - k1 + k2 * std::min(std::max(glm::dot(k1 - q, k2) / glm::dot(k2, k2), 0.0F), 1.0F);
    const glm::vec2 ca(q.x - std::min(q.x, q.y < 0 ? r1 : r2), std::abs(q.y) - h);
    return (cb.x < 0 && ca.y < 0 ? -1.0F : 1.0F) * std::sqrt(std::min(glm::dot(cb, cb), glm::dot(ca, ca)));
}

}  // namespace naive

/// Returns the largest number of evaluations of rays at a field of size zero; every ray must end.
int longestMarch(const std::function<float(const vec3&)>& field)
{
    f32::Tracer tracer{field};
    int longest = 0;
    test::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const vec3 origin(random.direction() * 3.0);
        const vec3 target(random.point(0.2));
        const auto march =
            tracer.sphereTrace(origin, glm::normalize(target - origin), tracer.marchSettings(0, 10, 0.002F));
        EXPECT_TRUE(std::isfinite(march.t) && std::isfinite(march.distance));
        longest = std::max(longest, march.evaluations);
    }
    return longest;
}

TEST(DegenerateInput, SolidsOfSizeZeroAreFiniteAndRaysPassThemQuickly)
{
    const std::function<float(const vec3&)> fields[] = {
        [](const vec3& p) { return f32::sdfSphere(p, 0); },
        [](const vec3& p) { return f32::sdfTorus(p, 0, 0); },
        [](const vec3& p) { return f32::sdfTorus(p, 0.5F, 0); },
        [](const vec3& p) { return f32::sdfBox(p, vec3(0)); },
        [](const vec3& p) { return f32::sdfRoundBox(p, vec3(0), 0.1F); },
        [](const vec3& p) { return f32::sdfBoxFrame(p, vec3(0.5F), 0); },
        [](const vec3& p) { return f32::sdfCylinder(p, 0, 0); },
        [](const vec3& p) { return f32::sdfCappedTorus(p, 0, 0.5F, 0); },
        [](const vec3& p) { return f32::sdfLink(p, 0, 0, 0); },
        [](const vec3& p) { return f32::sdfOctahedron(p, 0); },
        [](const vec3& p) { return f32::sdfHexPrism(p, 0, 0); },
        [](const vec3& p) { return f32::sdfTriangularPrism(p, 0, 0); },
        [](const vec3& p) { return f32::sdfSolidAngle(p, 0, 0); },
        [](const vec3& p) { return f32::sdfCutSphere(p, 0, 0); },
        [](const vec3& p) { return f32::sdfRoundCone(p, 0, 0, 0); },
        [](const vec3& p) { return f32::sdfTriangle(p, vec3(0), vec3(0), vec3(0)); },
        [](const vec3& p) { return f32::sdfTriangle(p, vec3(0), vec3(1, 0, 0), vec3(0.5F, 0, 0)); },
    };
    for (const auto& field : fields) {
        EXPECT_TRUE(std::isfinite(field(vec3(0))));
        EXPECT_TRUE(std::isfinite(field(vec3(0.3F, -0.2F, 0.1F))));
        EXPECT_LT(longestMarch(field), 100);
    }
}

TEST(DegenerateInput, TheEllipsoidIsDefinedAtItsCenterAndForFlatRadii)
{
    EXPECT_TRUE(std::isnan(naive::ellipsoid(vec3(0), vec3(1, 2, 3))));
    EXPECT_EQ(f32::sdfEllipsoid(vec3(0), vec3(1, 2, 3)), -1.0F);
    EXPECT_EQ(f64::sdfEllipsoid(dvec3(0), dvec3(1, 2, 0.5)), -0.5);

    EXPECT_TRUE(std::isnan(naive::ellipsoid(vec3(1, 0, 0), vec3(1, 0, 1))));
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const vec3 p(random.point(2));
        for (const vec3 r : {vec3(0), vec3(1, 0, 1), vec3(0, 0, 1)}) {
            EXPECT_TRUE(std::isfinite(f32::sdfEllipsoid(p, r)));
            EXPECT_TRUE(std::isfinite(f32::sdfEllipsoidBound(p, r)));
        }
    }
}

TEST(DegenerateInput, TheSteepEllipsoidCannotBeBlendedButItsBoundCan)
{
    // Along the flat direction, near the rim, the steep form changes by more than the true distance; the bound never
    // does.
    const vec3 radii(0.7F, 0.1F, 0.5F);
    float steep = 0;
    float bound = 0;
    test::Random random(5);
    for (int i = 0; i < 50000; ++i) {
        const dvec3 p = random.point(1);
        const dvec3 q = p + random.direction() * 0.01;
        steep =
            std::max(steep, std::abs(f32::sdfEllipsoid(vec3(p), radii) - f32::sdfEllipsoid(vec3(q), radii)) / 0.01F);
        bound = std::max(
            bound, std::abs(f32::sdfEllipsoidBound(vec3(p), radii) - f32::sdfEllipsoidBound(vec3(q), radii)) / 0.01F);
    }
    EXPECT_GT(steep, 3);
    EXPECT_LT(bound, 1.001);
}

TEST(DegenerateInput, ConesWithoutHeightOrWithoutEndAreFinite)
{
    EXPECT_TRUE(std::isnan(naive::cappedCone(vec3(1, 0, 0), 0, 0.5F, 0.5F)));
    EXPECT_FLOAT_EQ(f32::sdfCappedCone(vec3(1, 0, 0), 0, 0.5F, 0.5F), 0.5F);  // A disk remains.
    EXPECT_FLOAT_EQ(f32::sdfCappedCone(vec3(0.2F, 1, 0), 0, 0.5F, 0.5F), 1.0F);
    EXPECT_FALSE(std::isfinite(naive::cappedCone(vec3(1, 1, 1), 1e25F, 0.5F, 0.2F)));
    for (const float height : {0.0F, 1e-30F, 1e-6F, 1.0F, 1e6F, 1e25F, 3e38F})
        for (const float radius : {0.0F, 1e-30F, 0.5F, 1e25F})
            for (const vec3 p : {vec3(0), vec3(1, 1, 1), vec3(0, -3, 0)}) {
                EXPECT_TRUE(std::isfinite(f32::sdfCappedCone(p, height, radius, 0.2F))) << height << ' ' << radius;
                EXPECT_TRUE(std::isfinite(f32::sdfCone(p, radius, height)));
                EXPECT_TRUE(std::isfinite(f32::sdfRoundCone(p, radius, 0.2F, height)));
            }
}

TEST(DegenerateInput, ARoundConeWhoseBallsHoldOneAnotherIsTheLargerBall)
{
    EXPECT_DOUBLE_EQ(f64::sdfRoundCone(dvec3(2, 0, 0), 1, 0.2, 0.5), 1);
    EXPECT_DOUBLE_EQ(f64::sdfRoundCone(dvec3(2, 0.5, 0), 0.2, 1, 0.5), 1);
    EXPECT_DOUBLE_EQ(f64::sdfRoundCone(dvec3(2, 0, 0), 1, 1, 0), 1);
}

TEST(DegenerateInput, ACapsuleBetweenEqualPointsIsABall)
{
    const vec3 a(0.1F, 0.2F, 0.3F);
    EXPECT_TRUE(std::isnan(naive::capsule(vec3(1), a, a, 0.2F)));
    EXPECT_EQ(f32::sdfCapsule(vec3(1), a, a, 0.2F), f32::sdfSphere(vec3(1) - a, 0.2F));
    // So close that the square of their distance underflows.
    EXPECT_TRUE(std::isfinite(f32::sdfCapsule(vec3(1), vec3(0), vec3(1e-30F, 0, 0), 0.2F)));
}

TEST(DegenerateInput, ABlendOfZeroIsTheHardOperationBitwise)
{
    EXPECT_TRUE(std::isnan(naive::smoothUnion(1, 1, 0)));
    test::Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const float a = float(random.number(-2, 2));
        const float b = i % 10 == 0 ? a : float(random.number(-2, 2));
        for (const float k : {0.0F, -1.0F}) {
            EXPECT_EQ(f32::sdfSmoothUnion(a, b, k), std::min(a, b));
            EXPECT_EQ(f32::sdfSmoothUnionCubic(a, b, k), std::min(a, b));
            EXPECT_EQ(f32::sdfSmoothUnionExponential(a, b, k), std::min(a, b));
            EXPECT_EQ(f32::sdfSmoothSubtraction(a, b, k), std::max(a, -b));
        }
    }
}

TEST(DegenerateInput, BlendsStayWithinTheirBoundsForEveryWidth)
{
    EXPECT_LT(naive::smoothUnion(0.1F, 0.2F, 1e30F), -1e28F);  // The field has collapsed.
    for (const float k : {1e-38F, 1e-30F, 1e-10F, 1e-3F, 1.0F, 1e3F, 1e30F, infinity})
        for (const float a : {-1e9F, -1.0F, 0.0F, 1e-9F, 0.5F, 1e9F})
            for (const float b : {-1.0F, 0.0F, 0.5F, 1e9F}) {
                const float width = std::min(k, 1000.0F);
                const float hard = std::min(a, b);
                const float slack = 1e-6F * (std::abs(hard) + width);
                EXPECT_LE(f32::sdfSmoothUnion(a, b, k), hard);
                EXPECT_GE(f32::sdfSmoothUnion(a, b, k), hard - width / 4 - slack);
                EXPECT_LE(f32::sdfSmoothUnionCubic(a, b, k), hard);
                EXPECT_GE(f32::sdfSmoothUnionCubic(a, b, k), hard - width / 6 - slack);
                EXPECT_LE(f32::sdfSmoothUnionExponential(a, b, k), hard);
                EXPECT_GE(f32::sdfSmoothUnionExponential(a, b, k), hard - width - slack);
            }
}

TEST(DegenerateInput, TheExponentialBlendDoesNotOverflowFarAway)
{
    const auto naive = [](float a, float b, float k) { return -k * std::log2(std::exp2(-a / k) + std::exp2(-b / k)); };
    EXPECT_FALSE(std::isfinite(naive(-1e5F, -1e5F, 0.1F)));
    EXPECT_FALSE(std::isfinite(naive(1e5F, 1e5F, 0.1F)));
    EXPECT_FLOAT_EQ(f32::sdfSmoothUnionExponential(1e5F, 1e5F, 0.1F), 1e5F - 0.1F);
    EXPECT_FLOAT_EQ(f32::sdfSmoothUnionExponential(-1e5F, 1e5F, 0.1F), -1e5F);
}

TEST(DegenerateInput, UnevenlyScaledFieldsNeverOvershoot)
{
    const dvec3 scale(2, 0.5, 1);
    const auto plain = [&](const dvec3& p) { return f64::sdfSphere(p / scale, 0.4); };
    const auto corrected = [&](const dvec3& p) { return f64::sdfScaled(plain(p), 0.5); };
    // A step from outside that ends inside has passed a surface.
    const auto overshoots = [](const auto& field) {
        test::Random random(9);
        int count = 0;
        for (int i = 0; i < 20000; ++i) {
            const dvec3 p = random.point(2);
            const double d = field(p);
            if (d > 0) count += field(p + random.direction() * d) < -1e-12;
        }
        return count;
    };
    EXPECT_GT(overshoots(plain), 100);
    EXPECT_EQ(overshoots(corrected), 0);
}

TEST(DegenerateInput, MixedFieldsEndExactlyOnTheirEnds)
{
    const float a = 1e9F;
    const float b = 0.123456F;
    EXPECT_NE(a + (b - a) * 1.0F, b);  // Some drivers implement mix in this way.
    EXPECT_EQ(f32::sdfMix(a, b, 0), a);
    EXPECT_EQ(f32::sdfMix(a, b, 1), b);
    EXPECT_EQ(f32::sdfMix(infinity, b, 1), b);  // The product inf * 0 would be NaN.
    EXPECT_EQ(f32::lerpExact(a, b, 1), b);
}

TEST(DegenerateInput, SubtractingASolidFromItselfLeavesNothing)
{
    const auto sphere = [](const vec3& p) { return f32::sdfSphere(p, 0.5F); };
    f32::Tracer plain{[&](const vec3& p) { return f32::sdfSubtraction(sphere(p), sphere(p)); }};
    f32::Tracer clean{[&](const vec3& p) { return f32::sdfCleanSubtraction(sphere(p), sphere(p), 0.02F); }};
    f32::Tracer once{[&](const vec3& p) { return sphere(p); }};
    f32::Tracer twice{[&](const vec3& p) { return std::min(sphere(p), sphere(p)); }};
    int speckle = 0;
    for (int y = -20; y <= 20; ++y) {
        for (int x = -20; x <= 20; ++x) {
            const vec3 origin(0, 0, 3);
            const vec3 direction = glm::normalize(vec3(float(x) * 0.01F, float(y) * 0.01F, -1));
            const auto settings = clean.marchSettings(0, 6, 0.002F);
            speckle += plain.sphereTrace(origin, direction, plain.marchSettings(0, 6, 0.002F)).hit;
            EXPECT_FALSE(clean.sphereTrace(origin, direction, settings).hit);
            EXPECT_EQ(once.sphereTrace(origin, direction, once.marchSettings(0, 6, 0.002F)).t,
                      twice.sphereTrace(origin, direction, twice.marchSettings(0, 6, 0.002F)).t);
        }
    }
    EXPECT_GT(speckle, 100);
}

TEST(DegenerateInput, FieldsWithoutASurfaceGiveBackgroundInFewSteps)
{
    for (const float everywhere : {1e9F, infinity}) {
        f32::Tracer tracer{[=](const vec3&) { return everywhere; }};
        const auto march = tracer.sphereTrace(vec3(0), vec3(0, 0, 1), tracer.marchSettings(0, 100, 0.001F));
        EXPECT_FALSE(march.hit);
        EXPECT_EQ(march.evaluations, 1);
    }
    // Subtraction from an empty field.
    f32::Tracer hollow{[](const vec3& p) { return f32::sdfSubtraction(1e9F, f32::sdfSphere(p, 1)); }};
    EXPECT_FALSE(hollow.sphereTrace(vec3(0, 0, 3), vec3(0, 0, -1), hollow.marchSettings(0, 100, 0.001F)).hit);
    // A field that is NaN everywhere is background, and tracing it ends.
    f32::Tracer broken{[](const vec3&) { return std::numeric_limits<float>::quiet_NaN(); }};
    EXPECT_FALSE(broken.sphereTrace(vec3(0), vec3(0, 0, 1), broken.marchSettings(0, 100, 0.001F)).hit);
}

TEST(DegenerateInput, SolidsAtFloat32AgreeWithFloat64)
{
    test::Random random(21);
    float worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec3 p(random.point(3));
        const dvec3 q(p);
        const auto compare = [&](float a, double b) { worst = std::max(worst, float(std::abs(double(a) - b))); };
        compare(f32::sdfTorus(p, 0.35F, 0.12F), f64::sdfTorus(q, 0.35F, 0.12F));
        compare(f32::sdfRoundBox(p, vec3(0.5F), 0.25F), f64::sdfRoundBox(q, dvec3(0.5), 0.25));
        compare(f32::sdfOctahedron(p, 0.75F), f64::sdfOctahedron(q, 0.75));
        compare(f32::sdfCappedCone(p, 0.5F, 0.75F, 0.25F), f64::sdfCappedCone(q, 0.5, 0.75, 0.25));
        compare(f32::sdfHexPrism(p, 0.5F, 0.25F), f64::sdfHexPrism(q, 0.5, 0.25));
    }
    EXPECT_GT(worst, 0);  // The computation really uses float32.
    EXPECT_LT(worst, 1e-6F);
}

}  // namespace
}  // namespace vitrine
