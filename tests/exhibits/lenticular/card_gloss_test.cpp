// Reflection of the lamp in the plastic: size and brightness compared with the microfacet model at float64, and the
// effect of ribs and lenses.

#include "tests/exhibits/lenticular/card_shot.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

using glm::dvec3;
using lenticular::CardAxis;
using lenticular::cardLamp;
using lenticular::cardMiddle;
using lenticular::exhibitFromCard;
using lenticular::Lenticular;
using lenticular::LenticularTable;
using namespace test;

/// Position of the lamp in the card's space.
const dvec3 lamp(glm::affineInverse(exhibitFromCard()) * glm::dvec4(cardLamp(), 1));
constexpr double greenOfLamp = 0.90;  ///< Green component of its color.

/// Returns the radiance that a plane facing z reflects from unit irradiance along `l` toward `v`. Cook and Torrance
/// 1982 with the distribution and shadowing of Walter et al. 2007 ("Microfacet models for refraction through rough
/// surfaces", GGX, equations 33 and 34), the latter height-correlated (Heitz 2014, equation 99), and Schlick's Fresnel
/// term.
double mirroredBy(double roughness, double specular, const dvec3& l, const dvec3& v)
{
    const double alpha = roughness * roughness;  // Burley 2012.
    const dvec3 h = glm::normalize(l + v);
    const double tan2 = 1 / (h.z * h.z) - 1;
    const double d = alpha * alpha / (std::numbers::pi * std::pow(h.z, 4) * std::pow(alpha * alpha + tan2, 2));
    const auto lambda = [&](double cosine) {
        return 0.5 * (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1);
    };
    const double g = 1 / (1 + lambda(l.z) + lambda(v.z));
    const double f0 = 0.08 * specular;
    const double f = f0 + (1 - f0) * std::pow(1 - glm::dot(v, h), 5);
    return d * g * f / (4 * l.z * v.z) * l.z;
}

class CardGloss : public test::GlTest {
protected:
    CardViews views;

    /// Returns a black card, flat except for a test's changes, so that only reflections are visible.
    CardShot black()
    {
        CardShot shot;
        ParameterValues& v = shot.values();
        v.set(cardTable().frontPrint, views.level(0));
        v.set(cardTable().views, 1);
        v.set(cardTable().apertureSamples, 1);
        v.set(cardTable().specular, 0.5);
        v.set(cardTable().normalScale, 0.0);
        v.set(cardTable().lensGloss, 0.0);
        return shot;
    }
    /// Returns the green light of the lamp at every pixel.
    static std::vector<double> ofTheLamp(CardShot shot)
    {
        shot.values().set(cardTable().lamp, 1.0);
        const render::Image with = shot.take().image;
        shot.values().set(cardTable().lamp, 0.0);
        const render::Image without = shot.take().image;
        std::vector<double> result;
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x)
                result.push_back(static_cast<double>(with.at(x, y, 1)) - static_cast<double>(without.at(x, y, 1)));
        return result;
    }
    /// Sets the camera to the direction of the lamp's reflection, rotated by these radians across and upward.
    static CardShot& fromTheMirror(CardShot& shot, double pixel, double across = 0, double above = 0)
    {
        const dvec3 mirror = glm::normalize(dvec3(-lamp.x, -lamp.y, lamp.z));
        shot.from(std::atan2(mirror.x, mirror.z) + across, 10, pixel, std::asin(mirror.y) + above);
        return shot;
    }
    static dvec3 toEye(const CardShot& shot) { return glm::normalize(shot.request.frame.camera.eye); }
};

TEST_F(CardGloss, IsThatOfTheMicrofacetModel)
{
    const std::size_t middle = 12 * 25 + 12;
    for (const double roughness : {0.2, 0.4, 0.8}) {
        for (const double specular : {0.25, 0.5, 1.0}) {
            for (const double beside : {0.0, 0.1, 0.35}) {
                CardShot shot = black();
                shot.values().set(cardTable().roughness, roughness);
                shot.values().set(cardTable().specular, specular);
                fromTheMirror(shot, 0.0004, beside, 0.3 * beside);
                const double expected =
                    greenOfLamp * mirroredBy(roughness, specular, glm::normalize(lamp), toEye(shot));
                EXPECT_NEAR(ofTheLamp(shot)[middle] / expected, 1, 0.02)
                    << "roughness " << roughness << ", specular " << specular << ", " << beside << " rad beside";
            }
        }
    }
}

/// Returns the mean difference between horizontal neighbors relative to that between vertical ones.
double stretched(const std::vector<double>& picture, int side)
{
    double right = 0, below = 0;
    for (int y = 0; y + 1 < side; ++y) {
        for (int x = 0; x + 1 < side; ++x) {
            const auto at = [&](int i, int j) { return picture[static_cast<std::size_t>(j * side + i)]; };
            right += std::abs(at(x + 1, y) - at(x, y));
            below += std::abs(at(x, y + 1) - at(x, y));
        }
    }
    return right / below;
}

TEST_F(CardGloss, OfTheRibsIsStreaksAlongTheLenses)
{
    constexpr int side = 64;
    const auto ribbed = [&](CardAxis axis, double stretch, double scale) {
        CardShot shot = black();
        shot.size(side, side);
        shot.values().set(cardTable().axis, axis);
        shot.values().set(cardTable().normalScale, scale);
        shot.values().set(cardTable().ribWidth, 0.01);
        shot.values().set(cardTable().ribStretch, stretch);
        shot.values().set(cardTable().roughness, 0.5);
        // Direction in which the highlight falls off equally both ways, so that slopes in both directions are visible.
        fromTheMirror(shot, 0.0006, 0.2, 0.2);
        return ofTheLamp(shot);
    };
    // Noise 16 times as long as wide has slopes that change 16 times as fast across, and are 16 times as steep. Shading
    // reduces the ratio.
    EXPECT_GT(stretched(ribbed(CardAxis::vertical, 16, 1), side), 6);
    EXPECT_LT(stretched(ribbed(CardAxis::horizontal, 16, 1), side), 1.0 / 6);
    EXPECT_NEAR(std::log2(stretched(ribbed(CardAxis::vertical, 1, 1), side)), 0, 0.6);
    // For small slopes the light changes in proportion to the scale, with the same sign.
    const auto flat = ribbed(CardAxis::vertical, 16, 0), once = ribbed(CardAxis::vertical, 16, 0.05),
               twice = ribbed(CardAxis::vertical, 16, 0.1), turned = ribbed(CardAxis::vertical, 16, -0.05);
    double one = 0, two = 0, minus = 0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const double d = once[i] - flat[i];
        one += d * d;
        two += d * (twice[i] - flat[i]);
        minus += d * (turned[i] - flat[i]);
    }
    ASSERT_GT(one, 0);
    EXPECT_NEAR(two / one, 2, 0.1);
    EXPECT_NEAR(minus / one, -1, 0.1);
}

TEST_F(CardGloss, FollowsTheLensesSlopesAcrossThemOnly)
{
    const std::size_t middle = 12 * 25 + 12;
    const auto light = [&](double gloss, double across, double above) {
        CardShot shot = black();
        shot.values().set(cardTable().roughness, 0.2);
        shot.values().set(cardTable().lensGloss, gloss);
        shot.values().set(cardTable().glossSamples, 32);
        fromTheMirror(shot, 0.004, across, above);  // A pixel contains several lenses.
        return ofTheLamp(shot)[middle];
    };
    const double beside = 0.35;
    EXPECT_GT(light(0.35, beside, 0), 3 * light(0, beside, 0)) << "to the side the lenses send more than a flat sheet";
    EXPECT_LT(light(0.35, 0, beside), 1.2 * light(0, 0, beside)) << "above they do not";
    EXPECT_LT(light(0.35, 0, 0), 0.6 * light(0, 0, 0)) << "and what they send there is missing in the middle";
}

/// Streak of the lamp on the card, in the middle third of its width.
struct Streak {
    double height = 0;  ///< Height of its brightest place above the card's center, meters.
    double peak = 0;    ///< Radiance there, green.
    double share = 0;   ///< Share of the card's height in which it is brighter than a tenth of that.
};

/// Looks at the leaning card, with a black print, from this point in exhibit space.
Streak streakFrom(const std::string& blackPrint, const dvec3& eye)
{
    ExhibitShot<LenticularTable> shot("lenticular");
    shot.set(cardTable().scroll, false).set(cardTable().frontPrint, blackPrint).set(cardTable().margin, 0.0);
    shot.size(160, 160).see(eye, cardMiddle());
    shot.request.frame.camera.fovY = 2 * std::atan(0.25 / glm::length(eye - cardMiddle()));
    const Picture lit = shot.take();
    shot.set(cardTable().lamp, 0.0);
    const Picture unlit = shot.take();
    const glm::dmat4 cardFromExhibit = glm::affineInverse(exhibitFromCard());
    const dvec3 from(cardFromExhibit * glm::dvec4(eye, 1));
    std::array<double, 40> sums{}, counts{};  // Over the card's height.
    lit.each([&](int x, int y) {
        const dvec3 way = glm::dmat3(cardFromExhibit) * lit.ray(x, y);
        const dvec3 p = from - way * (from.z / way.z);
        if (std::abs(p.x) > 0.1 || std::abs(p.y) >= 0.2) return;
        const auto row = static_cast<std::size_t>((p.y + 0.2) * 100);
        sums[row] += lit.color(x, y).g - unlit.color(x, y).g;
        counts[row] += 1;
    });
    Streak streak;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] /= std::max(counts[i], 1.0);
        if (sums[i] > streak.peak) streak = {(static_cast<double>(i) + 0.5) / 100 - 0.2, sums[i], 0};
    }
    for (const double light : sums) streak.share += light > 0.1 * streak.peak ? 1.0 / sums.size() : 0;
    return streak;
}

/// Returns the height at which a flat mirror in place of the card would show the lamp.
double mirrorHeight(const dvec3& eye)
{
    const dvec3 from(glm::affineInverse(exhibitFromCard()) * glm::dvec4(eye, 1));
    return glm::mix(from.y, lamp.y, from.z / (from.z + lamp.z));
}

TEST_F(CardGloss, IsAStreakAcrossTheCardAtTheFirstView)
{
    const dvec3 eye = Lenticular().bestView(ParameterValues(cardTable())).eye;
    const Streak streak = streakFrom(views.level(0), eye);
    EXPECT_GT(streak.peak, 0.3) << "white paper in the lamp's light has 0.11";
    EXPECT_NEAR(streak.height, mirrorHeight(eye), 0.02);
    EXPECT_GT(streak.height, -0.18) << "on the picture";
    EXPECT_LT(streak.height, -0.1) << "beside the subject, which reaches from -0.13 to 0.13 m";
    EXPECT_LT(streak.share, 0.25) << "the rest of the picture is not veiled";
}

TEST_F(CardGloss, MovesOverTheCardWhenAVisitorComesNearer)
{
    const double eyes = 1.65 - 1.2;  // Height of a standing visitor's eyes, in exhibit space.
    double before = -0.2;
    for (const double distance : {4.4, 3.4, 2.6, 2.0}) {
        const dvec3 eye(0.2, eyes, distance);
        const Streak streak = streakFrom(views.level(0), eye);
        EXPECT_GT(streak.peak, 0.35 / std::numbers::pi)
            << "brighter than white paper in the lamp's light, " << distance;
        EXPECT_NEAR(streak.height, mirrorHeight(eye), 0.02) << distance;
        EXPECT_GT(streak.height, before + 0.03) << "it rises, " << distance;
        before = streak.height;
    }
}

}  // namespace
}  // namespace vitrine
