// Limits of the screen-space sunbeams that hold for all settings and positions of the sun.

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "tests/exhibits/crepuscular_rays/ray_shot.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace vitrine::crepuscular_rays {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

const dvec3& towardsSun = shotTowardsSun;

/// Returns the largest difference of a white mask from `expected`, over all pixels counted from the lower left.
double worstOf(const Picture& p, const dvec3& white, const std::function<double(const dvec2&)>& expected)
{
    double worst = 0;
    p.each([&](int x, int y) {
        worst = std::max(worst, glm::length(p.color(x, y) / white - dvec3(expected({x + 0.5, p.height() - y - 0.5}))));
    });
    return worst;
}

using LongRays = Rays;

TEST_F(LongRays, AWhiteMaskIsWhiteForEverySetting)
{
    RayShot shot(RayTechnique::screen);
    shot.onWhite();
    shot.size(64, 36);
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar})
        for (const RayResolution resolution : {RayResolution::full, RayResolution::half, RayResolution::quarter})
            for (const bool jitter : {false, true})
                for (const double decay : {0.0, 0.98, 1.0})
                    for (const double density : {0.0, 0.3, 1.0})
                        for (const int samples : {1, 8, 216}) {
                            shot.rays().set(raysTable().method, method);
                            shot.rays().set(raysTable().resolution, resolution);
                            shot.rays().set(raysTable().jitter, jitter);
                            shot.rays().set(raysTable().decay, decay);
                            shot.rays().set(raysTable().density, density);
                            shot.rays().set(raysTable().samples, samples);
                            // Half floats store the mean: a thousandth.
                            EXPECT_LT(worstOf(shot.take(), shot.white(), [](const dvec2&) { return 1.0; }), 0.004)
                                << static_cast<int>(method) << ' ' << static_cast<int>(resolution) << ' ' << jitter
                                << ' ' << decay << ' ' << density << ' ' << samples;
                        }
}

TEST_F(LongRays, OfASunBeyondTheEdgeAreTheShareOfTheWayInsideThePictureTimesTheFade)
{
    // Beyond the picture's edge the mask is black. A white mask therefore gives the weight of the ray from the pixel to
    // the edge, in closed form, times the edge fade.
    for (const dvec3& towards : {dvec3(-0.05, -0.25, -1), dvec3(0.5, -0.1, -1)}) {
        RayShot shot(RayTechnique::screen);
        shot.onWhite();
        shot.see({0, 0, 0}, towards);
        shot.size(128, 72);
        shot.rays().set(raysTable().decay, 0.99);
        for (const double edgeFade : {1.5, 8.0}) {
            shot.rays().set(raysTable().edgeFade, edgeFade);
            for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
                shot.rays().set(raysTable().method, method);
                shot.rays().set(raysTable().samples, method == RayMethod::loop ? 512 : 4096);
                const Picture p = shot.take();
                const SunInPicture sun = sunInPicture(p.view, towardsSun);
                ASSERT_TRUE(sun.inFront);
                ASSERT_GT(sun.beyond, 0.05);
                const double reach =
                    std::max(glm::length(sun.pixel - dvec2(64, 36)) / 72 / shot.rays()[raysTable().streak], 1.0);
                // Part of the ray within the picture, for a density of 1, where a streak is longer.
                const double left = 1 - 1 / reach;
                const double exponent = 1 - 128 * std::log(0.99) * reach;
                const double fade = glsl::shaftEdgeFade(sun.beyond, edgeFade);
                ASSERT_GT(fade, 0.05);
                const auto share = [&](const dvec2& pixel) {
                    double edge = left;
                    for (int axis = 0; axis < 2; ++axis) {
                        const double size = axis == 0 ? 128 : 72;
                        const double limit = sun.pixel[axis] < 0 ? 0 : sun.pixel[axis] > size ? size : sun.pixel[axis];
                        if (limit != sun.pixel[axis])
                            edge = std::max(edge, (limit - sun.pixel[axis]) / (pixel[axis] - sun.pixel[axis]));
                    }
                    return fade * (1 - std::pow(edge, exponent)) / (1 - std::pow(left, exponent));
                };
                SCOPED_TRACE(testing::Message() << towards.x << ' ' << edgeFade << ' ' << static_cast<int>(method));
                // Near the edge, one sample more or less is inside. The three passes sample between the pixels of the
                // previous one.
                if (method != RayMethod::threePasses) {
                    EXPECT_LT(worstOf(p, shot.white(), share), 0.03);
                }
                double squares = 0;
                p.each([&](int x, int y) {
                    squares += std::pow(p.color(x, y).y / shot.white().y - share({x + 0.5, p.height() - y - 0.5}), 2);
                });
                EXPECT_LT(std::sqrt(squares / (128 * 72)), 0.01);
                p.each(
                    [&](int x, int y) { EXPECT_LT(p.color(x, y).y / shot.white().y, fade + 0.004) << x << ',' << y; });
            }
        }
    }
}

TEST_F(Rays, AreNeverBrighterThanTheMask)
{
    RayShot shot(RayTechnique::screen);
    shot.rays().set(raysTable().jitter, true);
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
        for (const RayResolution resolution : {RayResolution::full, RayResolution::half, RayResolution::quarter}) {
            shot.rays().set(raysTable().method, method);
            shot.rays().set(raysTable().resolution, resolution);
            const Picture p = shot.take();
            p.each([&](int x, int y) { EXPECT_LE(p.color(x, y).x, 1.002 * shot.white().x) << x << ',' << y; });
        }
    }
    // The same for a decay above 1, which is clamped, and an exposure that is NaN.
    shot.rays().set(raysTable().method, RayMethod::loop);
    shot.rays().set(raysTable().decay, 1.0);
    const Picture even = shot.take();
    even.each([&](int x, int y) { EXPECT_LE(even.color(x, y).x, 1.002 * shot.white().x) << x << ',' << y; });
    for (const double decay : {1.1, 4.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(shot.rays().setParameter(raysTable().decay.row, decay));
        EXPECT_EQ(test::largestDifference(shot.take().image, even.image), 0) << decay;
    }
    for (const std::uint16_t row : {raysTable().rayExposure.row, raysTable().weight.row}) {
        EXPECT_FALSE(shot.rays().setParameter(row, std::nan("")));
        EXPECT_EQ(test::largestDifference(shot.take().image, even.image), 0) << row;
    }
    // Control: the reference's sum differs by far.
    shot.rays().set(raysTable().sum, RaySum::plain);
    shot.rays().set(raysTable().decay, 1.0);
    const Picture plain = shot.take();
    double brightest = 0;
    plain.each([&](int x, int y) { brightest = std::max(brightest, plain.color(x, y).x); });
    EXPECT_GT(brightest, 20);
}

TEST_F(LongRays, ChangeLittleByLittleWhileTheCameraTurnsAway)
{
    // From the sun in the picture, across the edge, to a quarter turn beyond it, in steps of a tenth of a degree here
    // around the edge and at the end of the fade: no jumps.
    RayShot shot(RayTechnique::screen);
    shot.size(64, 36);
    shot.rays().set(raysTable().edgeFade, 0.8);
    const auto mean = [&](double yaw) {
        const double a = yaw * degree;
        shot.see({0.4, 1.65, -1}, dvec3(0.4, 1.65, -1) + dvec3(std::sin(a), 0.2, -std::cos(a)));
        return shot.take().mean();
    };
    const double straight = mean(0);
    EXPECT_GT(straight, 0.05);
    for (const double around : {-42.0, 36.0, 58.0, 66.0}) {
        double last = mean(around);
        for (int i = 1; i <= 12; ++i) {
            const double now = mean(around + 0.1 * i);
            EXPECT_LT(std::abs(now - last), 0.02 * straight) << around + 0.1 * i;
            last = now;
        }
    }
    // The view "rays only" is shown although it is black.
    shot.rays().set(raysTable().view, RayView::picture);
    EXPECT_EQ(test::planned(gallery().museum, shot.sceneState, shot.request.frame).find("crepuscular_rays/mask"),
              nullptr);
}

/// Returns the directions in which the sun is looked for, in tenths of a degree from three degrees before it: each
/// tenth around the camera's plane, where the sun's position in the picture goes to infinity and returns mirrored, and
/// coarser ones elsewhere.
std::vector<int> tenthsOfADegree()
{
    std::vector<int> tenths;
    for (int tenth = 0; tenth <= 1800; tenth += tenth < 860 ? 20 : tenth < 950 ? 1 : 50) tenths.push_back(tenth);
    return tenths;
}

TEST_F(LongRays, FadeToNothingBeforeTheSunComesToTheCamerasPlane)
{
    // Between two directions whose pictures differ by little there is no jump; where they differ, the tenths between
    // them are drawn, too. No pass runs behind the plane. Nothing but sky is visible, so only the fade is tested.
    for (const double edgeFade : {1.5, 8.0}) {
        RayShot shot(RayTechnique::screen);
        shot.onWhite();
        shot.size(16, 9);
        shot.rays().set(raysTable().edgeFade, edgeFade);
        const auto brightnessAt = [&](int tenth) {
            const double yaw = (0.1 * tenth - 3) * degree;
            shot.see({0, 0, 0}, {std::sin(yaw), 0, -std::cos(yaw)});
            const Picture p = shot.take();
            const bool runs =
                test::planned(gallery().museum, shot.sceneState, shot.request.frame).find("crepuscular_rays/mask") !=
                nullptr;
            EXPECT_TRUE(std::isfinite(p.mean())) << tenth;
            EXPECT_FALSE(runs && tenth >= 900) << tenth;
            EXPECT_TRUE(runs || p.mean() == 0) << tenth;
            return p.mean();
        };
        const double straight = brightnessAt(0);
        EXPECT_GT(straight, 0.3);
        const double little = 0.02 * straight;
        std::map<int, double> drawn{{0, straight}};
        for (const int tenth : tenthsOfADegree()) {
            const auto [last, before] = *drawn.rbegin();
            const double now = brightnessAt(tenth);
            if (std::abs(now - before) >= little)
                for (int between = last + 1; between < tenth; ++between) drawn[between] = brightnessAt(between);
            drawn[tenth] = now;
        }
        for (auto next = std::next(drawn.begin()); next != drawn.end(); ++next)
            EXPECT_LT(std::abs(next->second - std::prev(next)->second), little) << edgeFade << " at " << next->first;
    }
}

TEST_F(Rays, AreTheMaskItselfWithTheSunOnAPixelsCenter)
{
    // The plain direction to the light is 0/0 at the light.
    const auto naive = [](const dvec2& path) { return path / glm::length(path); };
    EXPECT_TRUE(std::isnan(naive(dvec2(0)).x));
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
        RayShot shot(RayTechnique::screen);
        shot.size(33, 19);
        shot.rays().set(raysTable().method, method);
        shot.see({0, 3, -9}, dvec3(0, 3, -9) + towardsSun);
        const Picture p = shot.take();
        EXPECT_LT(glm::length(sunInPicture(p.view, towardsSun).pixel - dvec2(16.5, 9.5)), 1e-9);
        EXPECT_EQ(test::notFinite(p.image, 4), "");
        EXPECT_NEAR(p.color(16, 9).y / shot.white().y, 1, 0.004)
            << static_cast<int>(method);  // The sky through the window.
    }
}

TEST_F(Rays, AreFiniteTowardsTheSkyAndWithTheEyeInTheWindow)
{
    // Infinite rays, and rays that start at the end of the air.
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
        RayShot shot(RayTechnique::both);
        shot.size(33, 19);
        shot.rays().set(raysTable().method, method);
        for (const double z : {-9.0, -11.999, -12.0, -12.2}) {
            shot.see({0, 3.9, z}, dvec3(0, 3.9, z) + towardsSun);
            EXPECT_EQ(test::notFinite(shot.take().image, 4), "") << z;
        }
    }
}

}  // namespace
}  // namespace vitrine::crepuscular_rays
