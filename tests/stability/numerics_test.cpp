#include "render/glsl/cpu.h"
#include "render/glsl/cpu32.h"
#include "tests/stability/fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vitrine {
namespace {

using glm::vec3;
namespace f64 = glsl;
namespace f32 = glsl32;

TEST(Numerics, FresnelSurvivesACosineAboveOne)
{
    // GPUs compute pow(x, y) as exp2(y log2 x), which is NaN for every negative x.
    const auto naive = [](float cosine, float f0) { return f0 + (1 - f0) * std::exp2(5 * std::log2(1 - cosine)); };
    const float above = 1.0000001F;
    EXPECT_TRUE(std::isnan(naive(above, 0.04F)));
    EXPECT_FLOAT_EQ(f32::schlick(above, 0.04F), 0.04F);
    EXPECT_FLOAT_EQ(f32::schlick(-1, 0.04F), 1);
    for (int i = 0; i <= 100; ++i) {
        const double cosine = i / 100.0;
        EXPECT_NEAR(f64::schlick(cosine, 0.04), 0.04 + 0.96 * std::pow(1 - cosine, 5), 1e-15);
    }
}

TEST(Numerics, FresnelOfClearSurfacesIsThatOfTheTwoPolarizations)
{
    for (const double index : {1.0, 1.33, 1.5, 2.4, 1 / 1.33, 1 / 1.5, 1 / 2.4}) {
        for (int i = 1; i <= 1000; ++i) {
            const double cosine = i / 1000.0;
            const double sineBehind = std::sqrt(1 - cosine * cosine) / index;
            double expected = 1;  // Total internal reflection.
            if (sineBehind < 1) {
                // Amplitudes of both polarizations (Fresnel 1823).
                const double behind = std::sqrt(1 - sineBehind * sineBehind);
                const double s = (cosine - index * behind) / (cosine + index * behind);
                const double p = (index * cosine - behind) / (index * cosine + behind);
                expected = 0.5 * (s * s + p * p);
            }
            EXPECT_NEAR(f64::fresnelDielectric(cosine, index), expected, 1e-9) << index << ' ' << cosine;
            EXPECT_NEAR(f32::fresnelDielectric(static_cast<float>(cosine), static_cast<float>(index)), expected, 2e-3)
                << index << ' ' << cosine;
        }
        EXPECT_EQ(f64::fresnelDielectric(0, index), index == 1 ? 0 : 1);
    }
    for (const float cosine : {0.0F, 1e-20F, 0.3F, 1.0F})
        EXPECT_NEAR(f32::fresnelDielectric(cosine, 1), 0, 1e-10) << cosine;  // H93
}

TEST(Numerics, AnglesOfCosinesBeyondOneAreDefinedAndAccurate)
{
    // acos is NaN beyond 1, which rounding of the product of two unit vectors can reach.
    EXPECT_EQ(f32::safeAcos(1.0000001F), 0);
    EXPECT_FLOAT_EQ(f32::safeAcos(-1.0000001F), float(M_PI));
    for (int i = -1000; i <= 1000; ++i) {
        const float c = float(i) / 1000;
        EXPECT_NEAR(f32::safeAcos(c), std::acos(double(c)), 4e-7);
    }
}

TEST(Numerics, TheAngleOfTheOriginIsZero)
{
    EXPECT_EQ(f32::angleOf(0, 0), 0);
    EXPECT_EQ(f32::angleOf(-0.0F, -0.0F), 0);  // Standard C returns -pi.
    EXPECT_FLOAT_EQ(f32::angleOf(1, 0), float(M_PI) / 2);
    EXPECT_FLOAT_EQ(f32::angleOf(0, -1), float(M_PI));
}

TEST(Numerics, FractionsNeverReachOne)
{
    EXPECT_EQ(-1e-9F - std::floor(-1e-9F), 1.0F);  // One past the end of a table.
    for (float x = -1e-6F; x < 0; x = std::nextafter(x, 1.0F) * 0.99999F) {
        const float f = f32::fractBelowOne(x);
        ASSERT_GE(f, 0);
        ASSERT_LT(f, 1);
    }
    EXPECT_FLOAT_EQ(f32::fractBelowOne(-0.25F), 0.75F);
    EXPECT_EQ(f32::fractBelowOne(-0.0F), 0);
}

TEST(Numerics, PowersOfZeroAreDefined)
{
    const auto onDriver = [](float x, float y) { return std::exp2(y * std::log2(x)); };
    EXPECT_TRUE(std::isnan(onDriver(0, 0)));
    EXPECT_EQ(f32::powPositive(0, 0), 1);
    EXPECT_EQ(f32::powPositive(0, 2.2F), 0);
    EXPECT_EQ(f32::powPositive(-1, 2), 0);
    EXPECT_FLOAT_EQ(f32::powPositive(0.5F, 2.2F), std::pow(0.5F, 2.2F));
}

TEST(Numerics, AStepBetweenEqualEdgesIsAHardStep)
{
    // GLSL leaves smoothstep between equal edges undefined: drivers return 0, 1 or NaN.
    EXPECT_EQ(f32::smoothStep(0.5F, 0.5F, 0.49F), 0);
    EXPECT_EQ(f32::smoothStep(0.5F, 0.5F, 0.5F), 1);
    for (int i = -10; i <= 20; ++i)
        EXPECT_NEAR(f64::smoothStep(0, 1, i / 10.0), glm::smoothstep(0.0, 1.0, i / 10.0), 1e-15);
}

TEST(Numerics, VectorsWithoutLengthTakeTheFallback)
{
    // normalize() of a zero vector and sqrt() of a negative number are NaN.
    EXPECT_EQ(f32::safeNormalize(vec3(0), vec3(0, 1, 0)), vec3(0, 1, 0));
    EXPECT_EQ(f32::safeNormalize(vec3(1e-25F), vec3(0, 1, 0)), vec3(0, 1, 0));  // The square underflows.
    EXPECT_FLOAT_EQ(glm::length(f32::safeNormalize(vec3(1e-10F, 2e-10F, 0), vec3(0))), 1);
    EXPECT_EQ(f32::safeSqrt(-1e-7F), 0);
}

TEST(Numerics, DirectionsSurviveTheOctahedron)
{
    double most = 0;
    for (int z = -7; z <= 7; ++z) {
        for (int y = -7; y <= 7; ++y) {
            for (int x = -7; x <= 7; ++x) {
                if (x == 0 && y == 0 && z == 0) continue;
                // Near the axes and the fold (z = 0), too.
                const vec3 n = glm::normalize(vec3(x, y, z) + vec3(1e-7F * static_cast<float>(x * y), 0, 1e-8F));
                const glm::vec2 point = f32::octahedronPoint(n);
                ASSERT_LE(std::max(std::abs(point.x), std::abs(point.y)), 1.0F);
                most = std::max(most, double(glm::distance(f32::octahedronDirection(point), n)));
            }
        }
    }
    EXPECT_LT(most, 4e-7) << "some roundings of float32";
    // Control: without the fold, directions below the plane come back above it.
    const vec3 down = glm::normalize(vec3(0.3F, -0.2F, -0.9F));
    const float sum = std::abs(down.x) + std::abs(down.y) + std::abs(down.z);
    EXPECT_GT(glm::distance(f32::octahedronDirection(glm::vec2(down) / sum), down), 1);
}

TEST(Numerics, ValuesThatAreNotNumbersAreReplaced)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(f32::finiteOr(nan, 7), 7);
    EXPECT_EQ(f32::finiteOr(inf, 7), 7);
    EXPECT_EQ(f32::finiteOr(-inf, 7), 7);
    EXPECT_EQ(f32::finiteOr(1e38F, 7), 1e38F);
}

TEST(Hash, LatticePointsFarFromTheOriginStayDistinct)
{
    // Commonly copied hash that uses sin.
    const auto sine = [](float x, float y) {
        const float s = std::sin(x * 12.9898F + y * 78.233F) * 43758.5453F;
        return s - std::floor(s);
    };
    std::set<float> fromSine;
    std::set<unsigned> fromPcg;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            fromSine.insert(sine(float(1000000 + x), float(1000000 + y)));
            fromPcg.insert(f32::hashCell(glm::ivec3(1000000 + x, 1000000 + y, -5), 1).x);
        }
    EXPECT_LT(fromSine.size(), 2000U);
    EXPECT_GE(fromPcg.size(), 4095U);  // Two of 4096 draws of 32 bits are equal once in 500 tries.
}

TEST(Hash, NeighborsAreDistinctBeyondTheIntegersOfAFloat)
{
    const int far = (1 << 24) + 1;
    EXPECT_EQ(float(far), float(far - 1));  // Rounded to float they are the same cell.
    EXPECT_NE(f32::hashCell(glm::ivec3(far, 0, 0), 0), f32::hashCell(glm::ivec3(far - 1, 0, 0), 0));
    EXPECT_NE(f32::hashCell(glm::ivec3(-1, 0, 0), 0), f32::hashCell(glm::ivec3(0, 0, 0), 0));
}

TEST(Hash, PcgIsTheGeneratorOfItsPaper)
{
    // pcg(v) is one step of PCG RXS-M-XS-32, computed here from its definition in 64-bit arithmetic.
    for (std::uint64_t v : {0ULL, 1ULL, 12345ULL, 0xffffffffULL}) {
        const std::uint64_t state = (v * 747796405ULL + 2891336453ULL) % 4294967296ULL;
        const std::uint64_t word = (((state >> ((state >> 28) + 4)) ^ state) * 277803737ULL) % 4294967296ULL;
        EXPECT_EQ(f64::pcg(std::uint32_t(v)), std::uint32_t((word >> 22) ^ word));
    }
}

TEST(Hash, BitsBecomeEvenlySpreadNumbersBelowOne)
{
    EXPECT_LT(f32::unitFromBits(0xffffffffU), 1);
    EXPECT_EQ(float(0xffffffffU) / 4294967296.0F, 1.0F);  // The naive division reaches 1.
    int bins[16] = {};
    for (std::uint32_t i = 0; i < 160000; ++i) ++bins[int(f32::unitFromBits(f32::pcg(i)) * 16)];
    double chiSquare = 0;
    for (const int count : bins) chiSquare += (count - 10000.0) * (count - 10000.0) / 10000.0;
    EXPECT_LT(chiSquare, 37.7);  // 15 degrees of freedom, probability 1/1000.
}

}  // namespace
}  // namespace vitrine
