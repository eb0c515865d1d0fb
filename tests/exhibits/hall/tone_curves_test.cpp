// Tone curves: properties that each curve must have, and published values.
#include "tests/support/tone_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine::hall {
namespace {

using glm::dvec3;
using test::toneCurves;

/// Returns the code of a display with the transfer function of sRGB, 0 to 255.
double codeOf(double linear)
{
    return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

/// Returns chroma and hue, in degrees, of linear light with the primaries of sRGB. Ottosson 2020, "A perceptual color
/// space for image processing".
std::pair<double, double> chromaAndHue(const dvec3& c)
{
    const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    const double a = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const double b = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return {std::hypot(a, b), std::atan2(b, a) * 180 / std::numbers::pi};
}

/// Returns the color of a hue from 0 to 6 and a saturation, with 1 in its highest channel.
dvec3 colorOf(double hue, double saturation)
{
    const auto channel = [&](double offset) {
        const double k = std::fmod(hue + offset, 6.0);
        return 1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    };
    return {channel(5), channel(3), channel(1)};
}

/// Returns the largest shift of hue by the curve, in degrees, over colors of these hues at all exposures that leave
/// them some chroma.
double largestHueShift(dvec3 (*curve)(dvec3), double firstHue, double lastHue)
{
    double largest = 0;
    for (double hue = firstHue; hue <= lastHue; hue += 0.05)
        for (const double saturation : {0.3, 0.5, 0.7, 0.9})
            for (double stops = -5; stops <= 4; stops += 0.5) {
                const dvec3 light = colorOf(hue, saturation) * std::exp2(stops);
                const auto [chroma, shown] = chromaAndHue(curve(light));
                if (chroma < 0.01) continue;
                largest = std::max(largest, std::abs(std::remainder(shown - chromaAndHue(light).second, 360.0)));
            }
    return largest;
}

TEST(ToneCurves, MapBlackToBlackAndNeverDarkenMoreLight)
{
    for (const auto& [name, curve] : toneCurves) {
        SCOPED_TRACE(name);
        EXPECT_NEAR(glm::length(curve(dvec3(0))), 0, 1e-9);
        for (const dvec3& color : {dvec3(1), dvec3(1, 0.5, 0.2), dvec3(0.1, 0.2, 1), dvec3(0.02, 1, 0.3)}) {
            double before = 0;
            for (double stops = -16; stops <= 16; stops += 0.125) {
                const dvec3 shown = curve(color * std::exp2(stops));
                const double brightness = shown.r + shown.g + shown.b;
                EXPECT_GE(brightness, before - 1e-9) << stops;
                before = brightness;
            }
        }
    }
}

TEST(ToneCurves, AreFiniteWhateverTheLight)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    const double lights[] = {0, 1e-30, 0.18, 1, 6e4, 1e30, infinite, -1, -1e30, -infinite, nan};
    for (const auto& [name, curve] : toneCurves) {
        SCOPED_TRACE(name);
        for (const double r : lights)
            for (const double g : lights)
                for (const double b : lights) {
                    const dvec3 shown = curve({r, g, b});
                    for (int c = 0; c < 3; ++c)
                        EXPECT_TRUE(shown[c] >= 0 && shown[c] <= 1) << r << ' ' << g << ' ' << b;
                }
        EXPECT_EQ(curve(dvec3(nan)), curve(dvec3(0)));
        EXPECT_EQ(curve(dvec3(-1)), curve(dvec3(0)));
    }
}

TEST(ToneCurves, KeepGraysGray)
{
    for (const auto& [name, curve] : toneCurves)
        for (double stops = -10; stops <= 10; ++stops) {
            const dvec3 shown = curve(dvec3(0.18 * std::exp2(stops)));
            EXPECT_NEAR(shown.r, shown.g, 2e-4) << name << ' ' << stops;
            EXPECT_NEAR(shown.b, shown.g, 2e-4) << name << ' ' << stops;
        }
}

TEST(ToneCurves, ShowMiddleGrayAtTheirPublishedCode)
{
    const auto code = [](int curve) { return codeOf(toneCurves[curve].map(dvec3(0.18)).g); };
    EXPECT_NEAR(code(0), codeOf(0.18), 0.1);                // 118: the curve leaves middle gray as it is.
    EXPECT_NEAR(code(1), codeOf(std::pow(0.5, 2.2)), 0.1);  // The sigmoid of AgX has its pivot there.
    EXPECT_NEAR(code(3), codeOf(0.18 - 0.04), 0.1);         // The reflection of a dielectric is taken off.
    EXPECT_NEAR(code(4), codeOf(0.18), 0.1);
    // The reference transforms of ACES show middle gray at a tenth of white (4.8 of 48 cd/m2).
    EXPECT_NEAR(glsl::toneAces(dvec3(0.6 * 0.18)).g, 0.1, 0.007);
}

TEST(ToneCurves, OfVitrineHaveContrastAToeAndALateShoulder)
{
    const auto slope = [](double light) {
        return std::log(glsl::toneVitrine(dvec3(light * 1.001)).g / glsl::toneVitrine(dvec3(light / 1.001)).g) /
               std::log(1.001 * 1.001);
    };
    EXPECT_NEAR(slope(0.18), 1.5 * (1 - 0.18),
                2e-3);  // The slope of a sigmoid is that of its logit times the rest to white.
    EXPECT_GT(slope(0.18 / 16), 1.3 * slope(0.18));
    const auto code = [](double light) { return codeOf(glsl::toneVitrine(dvec3(light)).g); };
    EXPECT_LT(code(0.18 / 32), 8);
    EXPECT_GT(code(1.0), 185);
    EXPECT_GT(code(4.0), 222);
    EXPECT_LT(code(18.0), 248) << "a hundred times middle gray is not white yet";
    EXPECT_GT(code(36.0) - code(9.0), 8) << "and is told from half and twice as much";
}

TEST(ToneCurves, OfVitrineKeepHue)
{
    EXPECT_LT(largestHueShift(glsl::toneVitrine, 0, 6), 12);
    EXPECT_LT(largestHueShift(glsl::toneVitrine, 0, 1), 7) << "warm colors, from red to yellow";
    // Control: curves for each channel turn orange to yellow.
    EXPECT_GT(largestHueShift(glsl::toneAces, 0, 1), 20);
    EXPECT_GT(largestHueShift(glsl::toneNone, 0, 1), 20);
}

/// Polynomial that approximates the sigmoid of AgX. Wrensch 2023, "Minimal AgX implementation".
double agxPolynomial(double light)
{
    const double x = std::clamp((std::log2(light) + 12.47393) / (12.47393 + 4.026069), 0.0, 1.0);
    double sum = 0;
    for (const double k : {15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232}) sum = sum * x + k;
    return sum;
}

TEST(ToneCurves, OfAgxIsItsPublishedApproximation)
{
    for (double stops = -9; stops <= 6; stops += 0.25) {
        const double light = 0.18 * std::exp2(stops);
        EXPECT_NEAR(std::pow(glsl::toneAgx(dvec3(light)).g, 1 / 2.2), agxPolynomial(light), 0.006) << stops;
    }
    // A saturated blue becomes paler towards white, and is no pure blue at any exposure.
    const dvec3 blue = glsl::toneAgx(dvec3(0, 0, 8));
    EXPECT_GT(blue.r, 0.2);
    EXPECT_GT(blue.b, blue.r);
}

/// The specification of Khronos, in its own symbols.
dvec3 neutralBySpecification(const dvec3& in)
{
    constexpr double f90 = 0.04, ks = 0.8 - f90, kd = 0.15;
    const double x = std::min({in.r, in.g, in.b});
    const double f = x <= 2 * f90 ? x - x * x / (4 * f90) : f90;
    const double p = std::max({in.r, in.g, in.b}) - f;
    if (p <= ks) return in - f;
    const double pn = 1 - (1 - ks) * (1 - ks) / (p + 1 - 2 * ks);
    const double g = 1 / (kd * (p - pn) + 1);
    return (in - f) * (pn / p) * g + pn * (1 - g);
}

TEST(ToneCurves, OfKhronosIsItsSpecification)
{
    for (double stops = -8; stops <= 12; stops += 0.25)
        for (const dvec3& color : {dvec3(1), dvec3(1, 0.5, 0.2), dvec3(0.1, 0.2, 1), dvec3(0, 1, 0.3)}) {
            const dvec3 light = color * std::exp2(stops);
            EXPECT_LT(glm::length(glsl::toneNeutral(light) - neutralBySpecification(light)), 1e-9) << stops;
        }
}

TEST(ToneCurves, OfNoneIsTheIdentityUpToWhite)
{
    for (const double light : {0.0, 1e-6, 0.18, 0.999, 1.0}) EXPECT_EQ(glsl::toneNone(dvec3(light)), dvec3(light));
    EXPECT_EQ(glsl::toneNone(dvec3(2, 0.5, -1)), dvec3(1, 0.5, 0));
}

}  // namespace
}  // namespace vitrine::hall
