// Pictures of sunbeams that are ray marched in the air, compared with closed forms.

#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "tests/exhibits/crepuscular_rays/ray_shot.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::crepuscular_rays {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

/// Looks across the beam. No walls keep the sun off, so all of the beam is lit.
struct SlabShot : RayShot {
    SlabShot() : RayShot(RayTechnique::volume)
    {
        see({-5, 3.4, -6}, {5, 2.6, -7});
        request.frame.camera.fovY = 0.5;
        hall().set(hallTable().sunShadows, false);
        rays().set(raysTable().ambient, 0.0);
        rays().set(raysTable().beamStrength, 1.0);
        rays().set(raysTable().airDensity, 0.09);
        rays().set(raysTable().airColor, ColorValue{dvec3(1)});
    }
};

using LongRays = Rays;

TEST_F(Rays, OfTheVolumeAreTheClosedFormOfALitSlabForAnyNumberOfSteps)
{
    SlabShot shot;
    const dvec3& towardsSun = shotTowardsSun;
    const dvec3 sunLight = blackBodyColor(6500) * shot.hall()[hallTable().sunStrength];
    for (const int steps : {1, 2, 64}) {
        shot.rays().set(raysTable().volumeSteps, steps);
        const Picture p = shot.take();
        const render::Box window{{-1.2, 1.4, -12.5}, {1.2, 6.4, -11.9}};
        const render::Box room = test::building().room();
        const std::vector<Beam> found = beams(std::span(&window, 1), room, towardsSun);
        double worst = 0;
        int compared = 0;
        p.each([&](int x, int y) {
            if (!p.hit(x, y)) return;
            const dvec2 ndc = (dvec2(x, y) + 0.5) / dvec2(p.width(), p.height()) * 2.0 - 1.0;
            const dvec3 inView(ndc.x * p.view.tanHalfFov.x, -ndc.y * p.view.tanHalfFov.y, -1);
            const dvec3 direction = glm::normalize(glm::transpose(glm::dmat3(p.view.viewFromWorld)) * inView);
            const double end = p.depth(x, y) * glm::length(inView);
            const dvec3 eye = p.view.eye;
            const auto depthTo = [&](double t) {
                const dvec2 air = glsl::lineBox(eye, direction, room.low, room.high);
                const double begin = std::max(air.x, 0.0);
                return glsl::airOpticalDepth(eye.y + direction.y * begin, direction.y, std::min(air.y, t) - begin, 0.09,
                                             shot.rays()[raysTable().densityFalloff]);
            };
            const dvec2 lit =
                glsl::airBeam(eye, direction, found[0].opening.low, found[0].opening.high, 2, found[0].plane,
                              towardsSun / towardsSun.z, found[0].box.low, found[0].box.high);
            const double first = std::max(lit.x, 0.0);
            const double last = std::min(lit.y, end);
            const double sum = last > first ? std::exp(-depthTo(first)) - std::exp(-depthTo(last)) : 0;
            const double exact =
                sum * glsl::airPhase(glm::dot(direction, towardsSun), shot.rays()[raysTable().anisotropy]) * sunLight.y;
            worst = std::max(worst, std::abs(p.color(x, y).y - exact) / sunLight.y);
            compared += sum > 0.05;
        });
        EXPECT_GT(compared, 1000);
        EXPECT_LT(worst, 2e-4) << steps;  // Half floats near 0.05, and float32 positions.
    }
}

TEST_F(Rays, OfTheVolumeLeaveAWhiteFurnaceWhite)
{
    // Furnace test: in a uniform panorama, with dust that absorbs nothing, no amount of dust changes a picture. The
    // light passes through panorama, probe and dust as in the hall.
    const test::TemporaryFolder folder;
    test::writePanorama(folder / "white.hdr", [](const dvec3&) { return dvec3(1); });
    RayShot shot(RayTechnique::volume);
    const std::size_t rays = *gallery().museum.find("crepuscular_rays");
    shot.request.frame.alone = rays;
    shot.request.frame.transparent = false;
    shot.request.frame.camera = gallery().museum.subject(rays).bestView(shot.rays());
    shot.size(64, 36);
    shot.hall().set(hallTable().environment, (folder / "white.hdr").string());
    shot.hall().set(hallTable().reflectionProbe, true);
    shot.rays().set(raysTable().view, RayView::picture);
    shot.rays().set(raysTable().ambient, 1.0);
    shot.rays().set(raysTable().beamStrength, 0.0);  // Sunlight would be added to the furnace.
    shot.rays().set(raysTable().airColor, ColorValue{dvec3(1)});
    const auto furthestFromBefore = [&](double density) {
        shot.rays().set(raysTable().airDensity, 0.0);
        const Picture before = shot.take();
        shot.rays().set(raysTable().airDensity, density);
        const Picture after = shot.take();
        double worst = 0;
        after.each([&](int x, int y) {
            EXPECT_GT(before.luminance(x, y), 0.01);
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::abs(after.color(x, y)[c] / before.color(x, y)[c] - 1));
        });
        return worst;
    };
    for (const double density : {0.012, 0.3, 10.0})
        EXPECT_LT(furthestFromBefore(density), 0.004) << density;  // Half floats, blended.
    // Control: dust that absorbs half of the light, or is lit by half of it, is not white.
    shot.rays().set(raysTable().airColor, ColorValue{dvec3(0.5)});
    EXPECT_GT(furthestFromBefore(0.3), 0.2);
    shot.rays().set(raysTable().airColor, ColorValue{dvec3(1)});
    shot.rays().set(raysTable().ambient, 0.5);
    EXPECT_GT(furthestFromBefore(0.3), 0.2);
    // Drawn once more without the file, so that no other test finds it in the hall's cache.
    shot.hall().set(hallTable().environment, std::string());
    (void)shot.take();
}

TEST_F(Rays, OfTheVolumeAreBrokenByWhatHangsInTheBeam)
{
    RayShot shot(RayTechnique::volume);
    shot.size(160, 90);
    shot.see({-3.5, 1.65, 2.5}, {1.2, 3.2, -6});
    shot.hall().set(hallTable().shadowMapSize, 2048);
    shot.hall().set(hallTable().sunAzimuth, -0.12);
    shot.rays().set(raysTable().volumeSteps, 64);
    shot.rays().set(raysTable().ambient, 0.0);
    const Picture broken = shot.take();
    shot.hall().set(hallTable().sunShadows, false);
    const Picture whole = shot.take();
    int shaded = 0;
    broken.each([&](int x, int y) {
        EXPECT_LE(broken.luminance(x, y), whole.luminance(x, y) * 1.001 + 1e-4);
        shaded += whole.luminance(x, y) > 0.02 && broken.luminance(x, y) < 0.8 * whole.luminance(x, y);
    });
    EXPECT_GT(shaded, 300);
    EXPECT_GT(broken.mean(), 0.2 * whole.mean());
}

TEST_F(LongRays, OfTheVolumeAreThoseOfAMapDrawnAnewHoweverTheMobileCameToTurn)
{
    // From turn to turn, only the mobile's part of the sun's shadow map is restored and drawn again. Nothing of an
    // earlier turn may stay, and nothing else may be lost.
    RayShot shot(RayTechnique::volume);
    shot.see({-3.5, 1.65, 2.5}, {1.2, 3.2, -6});
    shot.rays().set(raysTable().mobileRotation, 0.9);
    (void)shot.take();
    shot.rays().set(raysTable().mobileRotation, -1.3);
    (void)shot.take();
    const render::Image stepped = gallery().renderer.read("shadow.hall");
    // Another sun in between draws the whole map again.
    shot.hall().set(hallTable().sunAzimuth, 0.2);
    (void)shot.take();
    shot.hall().set(hallTable().sunAzimuth, sdf_morph::straightSunAzimuth);
    (void)shot.take();
    const render::Image anew = gallery().renderer.read("shadow.hall");
    EXPECT_EQ(test::largestDifference(stepped, anew), 0);
    // Control: the mobile is in the map, so another turn changes it.
    shot.rays().set(raysTable().mobileRotation, 0.9);
    (void)shot.take();
    EXPECT_GT(test::largestDifference(gallery().renderer.read("shadow.hall"), anew), 0.01);
}

TEST_F(Rays, TheProbeIsTheSameHoweverTheMobileHungWhenItWasMade)
{
    // The probe is kept while the mobile turns, so pictures must not depend on the turn at which it was made.
    const auto irradianceAt = [](double turn) {
        RayShot shot(RayTechnique::volume);
        shot.rays().set(raysTable().mobileRotation, turn);
        shot.hall().set(hallTable().sunAzimuth, 0.2);  // Another sun in between makes the probe again.
        (void)shot.take();
        const render::Image elsewhere = gallery().renderer.read("probe.irradiance");
        shot.hall().set(hallTable().sunAzimuth, sdf_morph::straightSunAzimuth);
        (void)shot.take();
        const render::Image irradiance = gallery().renderer.read("probe.irradiance");
        EXPECT_GT(test::largestDifference(irradiance, elsewhere), 0);
        return irradiance;
    };
    EXPECT_EQ(test::largestDifference(irradianceAt(0.9), irradianceAt(-1.3)), 0);
}

TEST_F(Rays, OfTheVolumeAloneAreTheBeamOfTheWindowAndNothingElse)
{
    RayShot shot(RayTechnique::volume);
    const std::size_t rays = *gallery().museum.find("crepuscular_rays");
    shot.request.frame.alone = rays;
    shot.request.frame.transparent = true;
    shot.request.frame.camera = gallery().museum.subject(rays).bestView(shot.rays());
    shot.size(96, 54);
    const Picture p = shot.take();
    int lit = 0;
    int dark = 0;
    p.each([&](int x, int y) {
        lit += p.luminance(x, y) > 0.02;
        dark += p.luminance(x, y) == 0;
    });
    EXPECT_GT(lit, 96 * 54 / 20);
    EXPECT_GT(dark, 96 * 54 / 10);
}

}  // namespace
}  // namespace vitrine::crepuscular_rays
