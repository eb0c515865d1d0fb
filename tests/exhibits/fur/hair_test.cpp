// Light on hair: no lobe adds energy, and parts hidden by a coat take its color and are never black. The shaders' own
// code at float64.

#include "exhibits/fur/strand_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace vitrine::fur {
namespace {

using glm::dvec3;
using glsl::HairLobes;

using std::numbers::pi;

dvec3 towards(double theta, double phi)
{
    // The hair is along y.
    return {std::cos(theta) * std::cos(phi), std::sin(theta), std::cos(theta) * std::sin(phi)};
}

/// Returns the light that a hair sends to an eye at `thetaO` if radiance 1 arrives from all sides.
dvec3 furnace(double thetaO, const dvec3& color, double roughness)
{
    constexpr int rows = 240, columns = 480;
    const dvec3 hair(0, 1, 0);
    const dvec3 toEye = towards(thetaO, 0);
    dvec3 sum(0);
    for (int j = 0; j < rows; ++j) {
        const double theta = pi * ((j + 0.5) / rows - 0.5);
        for (int i = 0; i < columns; ++i) {
            const dvec3 l = towards(theta, 2 * pi * (i + 0.5) / columns);
            const HairLobes lobes = glsl::hairLobes(glsl::hairAngles(hair, l, toEye), color, roughness);
            sum += (dvec3(lobes.r) + lobes.tt + lobes.trt) * std::cos(theta);
        }
    }
    return sum * (pi / rows * 2 * pi / columns);
}

TEST(HairLobes, SendOnNoMoreLightThanArrivesAndMostOfItWhereTheHairIsWhite)
{
    for (const double roughness : {0.2, 0.4, 0.7}) {
        for (const double thetaO : {0.0, 0.3, -0.3, 0.8, -0.8, 1.2}) {
            const double white = furnace(thetaO, dvec3(1), roughness).x;
            EXPECT_LE(white, 1) << roughness << ' ' << thetaO;
            if (std::abs(thetaO) < 1) {
                EXPECT_GT(white, 0.7) << roughness << ' ' << thetaO;
            }
        }
    }
    // Control: twice the light would exceed 1.
    EXPECT_GT(2 * furnace(0, dvec3(1), 0.4).x, 1);
}

TEST(HairLobes, MirrorWhiteAndLetTheirColorThrough)
{
    const dvec3 brown(0.5, 0.2, 0.05);
    const dvec3 hair(0, 1, 0);
    const HairLobes front = glsl::hairLobes(glsl::hairAngles(hair, towards(0.05, 0.2), towards(0, 0)), brown, 0.4);
    const HairLobes behind = glsl::hairLobes(glsl::hairAngles(hair, towards(0.03, pi), towards(0, 0)), brown, 0.4);
    EXPECT_GT(front.r, behind.r);
    EXPECT_GT(behind.tt.x, 20 * front.tt.x);
    EXPECT_GT(front.trt.x, 20 * behind.trt.x);
    EXPECT_GT(behind.tt.x, 1.5 * behind.tt.z) << "what crosses it bears its color";
    EXPECT_GT(front.trt.x, 2 * front.trt.z);
    EXPECT_LT(furnace(0, brown, 0.4).z, furnace(0, brown, 0.4).x);
}

TEST(HairLobes, LieOnConesShiftedByTheScales)
{
    // The highlight of the surface is shifted toward the root, that from inside toward the tip (Marschner et al. 2003).
    const dvec3 hair(0, 1, 0);
    const auto peak = [&](const auto& lobe) {
        double best = 0, where = 0;
        for (double theta = -0.6; theta < 0.6; theta += 1e-3) {
            const double now =
                lobe(glsl::hairLobes(glsl::hairAngles(hair, towards(theta, 0), towards(0, 0)), dvec3(1), 0.3));
            if (now > best) best = now, where = theta;
        }
        return where;
    };
    EXPECT_NEAR(peak([](const HairLobes& l) { return l.r; }), -4 * 0.035, 0.01);
    EXPECT_NEAR(peak([](const HairLobes& l) { return l.trt.x; }), 4 * 0.035, 0.01);
}

TEST(HairLobes, AreFiniteForEveryDirection)
{
    const dvec3 hair(0, 1, 0);
    for (const double thetaI : {-pi / 2, -1.0, 0.0, 1.5, pi / 2})
        for (const double thetaO : {-pi / 2, -0.2, 0.0, pi / 2})
            for (const double phi : {0.0, 1.0, pi / 2, pi})
                for (const dvec3& color : {dvec3(0), dvec3(1), dvec3(0.3, 0, 1)}) {
                    const HairLobes l =
                        glsl::hairLobes(glsl::hairAngles(hair, towards(thetaI, phi), towards(thetaO, 0)), color, 0.4);
                    EXPECT_TRUE(std::isfinite(l.r) && std::isfinite(glm::length(l.tt)) &&
                                std::isfinite(glm::length(l.trt)));
                    EXPECT_GE(l.r, 0);
                }
}

TEST(CoatLight, IsScatteredOnInTheColorOfTheHairAndNeverLost)
{
    const dvec3 brown(0.5, 0.2, 0.05);
    EXPECT_LT(glm::length(glsl::scatteredOcclusion(1, brown) - dvec3(1)), 1e-12) << "nothing hidden, nothing taken";
    EXPECT_LT(glm::length(glsl::forwardScattered(0, brown) - dvec3(1)), 1e-12);
    double last = 0;
    for (const double open : {0.0, 0.2, 0.5, 1.0}) {
        const dvec3 light = glsl::scatteredOcclusion(open, brown);
        EXPECT_GT(light.x, last);
        EXPECT_GE(light.z, 0.1) << "the roots are black";
        EXPECT_GE(light.x, light.z);
        EXPECT_LE(light.x, 1);
        last = light.x;
    }
    for (const double crossed : {0.5, 2.0, 10.0}) {
        const dvec3 light = glsl::forwardScattered(crossed, brown);
        EXPECT_GT(light.x, std::exp(-crossed)) << "more arrives than what no hair has met";
        EXPECT_GT(light.x, light.z);
        EXPECT_LT(glsl::forwardScattered(crossed, dvec3(1)).x, 1);
    }
}

TEST(CoatLight, IsNotHiddenByACoatThatIsNotThere)
{
    EXPECT_EQ(glsl::coatCover(glsl::strandCellSize(60000), 0.00225, 0), 0);
    EXPECT_LT(glsl::coatCover(glsl::strandCellSize(100), 0.00225, 0.2), 0.1);
    EXPECT_GT(glsl::coatCover(glsl::strandCellSize(60000), 0.00225, 0.2), 0.999);
}

}  // namespace
}  // namespace vitrine::fur
