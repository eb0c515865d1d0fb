#include "exhibits/printing/optics.h"

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

const Sheet twenty{"20 LPI", 20, 0, 1.1487179487179487, 3.2, 1.56, 0};
const Sheet& seventyFive = knownSheet("75-measured");

TEST(LenticularOptics, AgreesWithIndependentlyComputedRays)
{
    // Hits in millimeters from a separate ray tracer, for theta 0, 10, 20 and 40 degrees.
    const std::array<std::pair<double, std::array<double, 4>>, 5> rays{
        {{-0.6, {0.040159898, -0.262222986, -0.526831919, -0.915702141}},
         {-0.3, {0.004377570, -0.336583347, -0.660716671, -1.241824859}},
         {0, {0, -0.358428881, -0.719074775, -1.447092212}},
         {0.3, {-0.004377570, -0.362912701, -0.742227305, -1.581832363}},
         {0.6, {-0.040159898, -0.379376562, -0.759140616, -1.678323072}}}};
    const std::array<double, 4> degrees{0, 10, 20, 40};
    for (const auto& [x0, expected] : rays)
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            const auto landing = trace(twenty, x0, degrees.at(i) * radiansPerDegree);
            ASSERT_TRUE(landing);
            EXPECT_NEAR(landing->x, expected.at(i), 1e-9) << x0 << " at " << degrees.at(i);
        }
}

TEST(LenticularOptics, IsAntisymmetricAndTheChiefRayIsExact)
{
    for (double theta = -0.6; theta <= 0.6; theta += 0.05) {
        for (double x0 = -0.6; x0 <= 0.6; x0 += 0.1)
            EXPECT_NEAR(trace(twenty, x0, theta)->x, -trace(twenty, -x0, -theta)->x, 1e-14);
        const double through = twenty.radius * std::sin(theta);
        if (std::abs(through) < twenty.pitch() / 2) {
            const double chief = (twenty.radius - twenty.thickness) * std::tan(theta);
            EXPECT_NEAR(trace(twenty, through, theta)->x, chief, 1e-13);
        }
    }
    EXPECT_NEAR(trace(twenty, 1e-5, 1e-5)->x, paraxial(twenty, 1e-5, 1e-5), 1e-13);
}

TEST(LenticularOptics, TheEllipseHasOneFocus)
{
    Sheet ellipse = twenty;
    ellipse.conic = -1 / (ellipse.index * ellipse.index);
    ellipse.thickness = ellipse.index * ellipse.radius / (ellipse.index - 1);
    for (double x0 = -0.63; x0 <= 0.63; x0 += 0.01) EXPECT_NEAR(trace(ellipse, x0, 0)->x, 0, 1e-12);
}

TEST(LenticularOptics, TheEffectiveIndexIsVectorRefraction)
{
    EXPECT_NEAR(effectiveIndex(1.56, 15 * radiansPerDegree), 1.593, 5e-4);
    EXPECT_NEAR(effectiveIndex(1.56, 30 * radiansPerDegree), 1.706, 5e-4);
    EXPECT_NEAR(effectiveIndex(1.56, 45 * radiansPerDegree), 1.967, 5e-4);
    const double n = 1.56;
    for (double beta = 0; beta < 0.9; beta += 0.1)
        for (double theta = -0.7; theta < 0.7; theta += 0.1)
            for (double phi = -0.5; phi < 0.5; phi += 0.1) {
                // Incoming direction (toward the sheet) and the surface's normal.
                const std::array<double, 3> d{-std::sin(theta) * std::cos(beta), -std::sin(beta),
                                              -std::cos(theta) * std::cos(beta)};
                const std::array<double, 3> normal{std::sin(phi), 0, std::cos(phi)};
                const double c = -(d[0] * normal[0] + d[2] * normal[2]);
                if (c <= 0) continue;
                const double eta = 1 / n;
                const double k = eta * c - std::sqrt(1 - eta * eta * (1 - c * c));
                const double tx = eta * d[0] + k * normal[0];
                const double tz = eta * d[2] + k * normal[2];
                const double psi = phi + std::asin(std::sin(theta - phi) / effectiveIndex(n, beta));
                EXPECT_NEAR(std::tan(psi), tx / tz, 1e-9);
            }
}

TEST(LenticularOptics, TheMeasuredSheetShowsItsViewsOver64Degrees)
{
    EXPECT_NEAR(zoneByChiefRay(seventyFive) / radiansPerDegree, 64.55, 0.02);
    EXPECT_NEAR(zoneByAperture(seventyFive) / radiansPerDegree, 67.2, 0.2);
}

TEST(LenticularOptics, MeanAndSpotOverTheLensAreThePublishedOnes)
{
    const std::array<std::array<double, 3>, 4> expected{
        {{10, -45.3, 8.2}, {20, -93.1, 12.0}, {30, -146.8, 16.9}, {40, -209.4, 24.5}}};
    for (const auto& [degrees, mean, rms] : expected) {
        const Aperture seen = aperture(seventyFive, degrees * radiansPerDegree);
        EXPECT_NEAR(1000 * seen.mean, mean, 0.3) << degrees;
        EXPECT_NEAR(1000 * seen.rms, rms, 0.3) << degrees;
    }
    EXPECT_NEAR(1000 * aperture(twenty, 20 * radiansPerDegree).mean, -699.6, 1);
    EXPECT_NEAR(1000 * aperture(twenty, 0, 30 * radiansPerDegree).rms, 74, 2);
}

std::string refusal(const Sheet& sheet)
{
    try {
        check(sheet);
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::usage);
        return failure.what();
    }
    return {};
}

TEST(LenticularSheet, RefusesWhatCannotBe)
{
    const double nan = std::nan("");
    Sheet s = twenty;
    EXPECT_EQ(refusal(s), "");
    s.radius = 0.6;  // The pitch is 1.27.
    EXPECT_NE(refusal(s).find("above 0.635 mm"), std::string::npos) << refusal(s);
    for (const double index : {1.0, 0.5, -1.5, nan}) {
        s = twenty;
        s.index = index;
        EXPECT_NE(refusal(s).find("index"), std::string::npos);
    }
    for (double Sheet::*member : {&Sheet::nominalLpi, &Sheet::radius, &Sheet::thickness})
        for (const double value : {0.0, -1.0, nan, HUGE_VAL}) {
            s = twenty;
            s.*member = value;
            EXPECT_NE(refusal(s), "") << value;
        }
    s = twenty;
    s.thickness = 0.1;
    EXPECT_NE(refusal(s).find("deep"), std::string::npos);
    EXPECT_THROW((void)derivedSheet("wide", 60, 59), Failure);
    EXPECT_THROW((void)knownSheet("no such sheet"), Failure);
    for (const Sheet& known : knownSheets()) EXPECT_EQ(refusal(known), "") << known.name;
}

TEST(LenticularSheet, DerivedSheetsHaveTheirZone)
{
    const Sheet sheet = derivedSheet("60", 60, 30);
    EXPECT_NEAR(sheet.thickness, 1.23, 0.005);
    EXPECT_NEAR(sheet.radius, 0.442, 0.0005);
    EXPECT_NEAR(zoneByChiefRay(sheet) / radiansPerDegree, 30, 1e-9);
}

TEST(LenticularSheet, ThePrintPitchFollowsFromTheDistance)
{
    const auto printLpi = [](double lpi, double thickness, double distance) {
        const Sheet sheet{"", lpi, 0, thickness * 0.56 / 1.56, thickness, 1.56, 0};
        return 25.4 / printPitch(sheet, distance);
    };
    EXPECT_NEAR(printLpi(20, 3.2, 300), 19.8647, 1e-4);
    EXPECT_NEAR(printLpi(20, 3.2, 1000), 19.9591, 1e-4);
    EXPECT_NEAR(printLpi(40, 2.1, 500), 39.8928, 1e-4);
    EXPECT_NEAR(printLpi(60, 1.2, 3000), 59.9846, 1e-4);
    EXPECT_DOUBLE_EQ(printLpi(60, 1.2, HUGE_VAL), 60);
}

}  // namespace
}  // namespace vitrine::printing
