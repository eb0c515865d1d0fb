// Dust in the hall: its extent, its motion, and its look in the noon sun.
#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "exhibits/hall/sun.h"
#include "tests/exhibits/crepuscular_rays/ray_shot.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vitrine::crepuscular_rays {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

class DustyAir : public test::GlTest {};

using LongDustyAir = DustyAir;

TEST_F(LongDustyAir, FillsTheHallAndEndsAtItsWalls)
{
    // Lit by the hall alone, every pixel gets the light that dust scatters along its ray, from wall to wall only.
    RayShot shot(RayTechnique::volume);
    shot.size(96, 54);
    shot.see({1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0});
    shot.rays().set(raysTable().beamStrength, 0.0);
    shot.rays().set(raysTable().ambient, 1.0);
    shot.rays().set(raysTable().airColor, ColorValue{dvec3(1)});
    shot.rays().set(raysTable().airDensity, 0.08);
    const Picture p = shot.take();
    const render::Box& room = test::building().room();
    const double falloff = shot.rays()[raysTable().densityFalloff];
    const std::vector<Beam> found =
        beams(test::building().openings(), room, hall::sunOf(hallTable(), shot.hall()).towards());
    ASSERT_FALSE(found.empty());
    const auto hiddenIn = [&](const render::Box& air, const dvec3& direction, double end) {
        const dvec2 inside = glsl::lineBox(p.view.eye, direction, air.low, air.high);
        const double begin = std::max(inside.x, 0.0);
        return -std::expm1(-glsl::airOpticalDepth(p.view.eye.y + direction.y * begin, direction.y,
                                                  std::min(inside.y, end) - begin, 0.08, falloff));
    };
    double least = std::numeric_limits<double>::infinity(), most = 0;
    double leastOfBeam = least, mostOfBeam = 0;
    p.each([&](int x, int y) {
        if (!p.hit(x, y)) return;
        const dvec2 ndc = (dvec2(x, y) + 0.5) / dvec2(p.width(), p.height()) * 2.0 - 1.0;
        const dvec3 inView(ndc.x * p.view.tanHalfFov.x, -ndc.y * p.view.tanHalfFov.y, -1);
        const dvec3 ray = glm::transpose(glm::dmat3(p.view.viewFromWorld)) * inView;
        const double end = p.depth(x, y) * glm::length(ray);
        const auto note = [&](double hidden, double& low, double& high) {
            low = std::min(low, p.color(x, y).g / hidden);
            high = std::max(high, p.color(x, y).g / hidden);
        };
        note(hiddenIn(room, glm::normalize(ray), end), least, most);
        note(hiddenIn(found[0].box, glm::normalize(ray), end) + 1e-3, leastOfBeam, mostOfBeam);
    });
    EXPECT_GT(least, 0);
    EXPECT_LT(most, 1.01 * least) << "one light for all of the hall";
    EXPECT_GT(mostOfBeam, 2 * leastOfBeam) << "which is not that of a box around the beam";
}

TEST_F(DustyAir, DriftsWhileTheDraftCarriesIt)
{
    RayShot shot(RayTechnique::volume);
    shot.size(64, 36);
    shot.see({-3.5, 1.65, 2.5}, {1.2, 3.2, -6});
    shot.rays().set(raysTable().densityNoise, 1.0);
    shot.rays().set(raysTable().turnSpeed, 0.0);
    const auto at = [&](double time) {
        shot.request.frame.time = time;
        return shot.take();
    };
    const auto nextChange = [&] { return test::nextChange(test::museum(), shot.sceneState, shot.request.frame); };
    EXPECT_EQ(test::largestDifference(at(0).image, at(20).image), 0) << "it rests";
    EXPECT_EQ(nextChange(), test::never);
    shot.rays().set(raysTable().animate, true);
    const Picture before = at(0);
    EXPECT_GT(test::colorDifference(before, at(20)), 0.05 * before.mean());
    EXPECT_EQ(nextChange(), 0);
    EXPECT_EQ(test::notFinite(at(1e18).image, 4), "");
    shot.rays().set(raysTable().driftSpeed, 0.0);
    EXPECT_EQ(test::largestDifference(at(0).image, at(20).image), 0);
    EXPECT_EQ(nextChange(), test::never);
}

TEST_F(DustyAir, BrightensTheFirstViewOfTheBeams)
{
    test::Shot shot;
    shot.inHall();
    shot.size(160, 90);
    const std::size_t index = *test::museum().find("crepuscular_rays");
    ParameterValues& rays = shot.sceneState.values[index];
    rays.resetParameter(raysTable().technique.row);
    shot.request.frame.camera = test::museum().bestView(index, rays);
    const auto tenthBrightest = [&shot] {
        const Picture p = shot.take();
        std::vector<double> luminances;
        p.each([&](int x, int y) { luminances.push_back(p.luminance(x, y)); });
        const auto found = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() * 9 / 10);
        std::nth_element(luminances.begin(), found, luminances.end());
        return *found;
    };
    const double with = tenthBrightest();
    rays.set(raysTable().technique, RayTechnique::none);
    EXPECT_GT(with, 1.8 * tenthBrightest());
}

TEST_F(LongDustyAir, ShowsAShaftFromTheOculusAtNoon)
{
    test::Shot shot;
    shot.inHall();
    shot.size(96, 54);
    shot.see({1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0});
    shot.hall().set(hallTable().sunBy, hall::SunBy::hour);
    ParameterValues& rays = shot.sceneState.values[*test::museum().find("crepuscular_rays")];
    rays.resetParameter(raysTable().technique.row);
    const auto brightened = [&](double hour) {
        shot.hall().set(hallTable().timeOfDay, hour);
        rays.resetParameter(raysTable().beamStrength.row);
        const Picture with = shot.take();
        rays.set(raysTable().beamStrength, 0.0);
        const Picture without = shot.take();
        int count = 0;
        // Above the window, but not on the wall that the sun lights.
        with.each([&](int x, int y) {
            count += y < 27 && without.luminance(x, y) < 0.1 && with.luminance(x, y) > 1.15 * without.luminance(x, y);
        });
        return count;
    };
    EXPECT_GT(brightened(12.2), 96 * 54 / 200) << "half a percent of the picture";
    EXPECT_EQ(brightened(5.0), 0) << "before the sun is up there is none";
}

}  // namespace
}  // namespace vitrine::crepuscular_rays
