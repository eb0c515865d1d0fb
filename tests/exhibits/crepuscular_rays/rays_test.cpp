// Pictures of the sunbeams, compared with float64 results and closed forms.

#include "exhibits/compare/offered_comparison.h"
#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/rays_scene.h"
#include "tests/exhibits/crepuscular_rays/ray_shot.h"
#include "tests/stability/fields.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::crepuscular_rays {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace test;

/// Mask of the last picture, sampled like in the shader; pixels from the lower left.
struct Mask {
    render::Image image = gallery().renderer.read("crepuscular_rays.mask");

    [[nodiscard]] double texel(int x, int y) const
    {
        return image.at(std::clamp(x, 0, image.width - 1), image.height - 1 - std::clamp(y, 0, image.height - 1), 0);
    }
    [[nodiscard]] double at(const dvec2& pixel) const
    {
        if (pixel.x < 0 || pixel.y < 0 || pixel.x > image.width || pixel.y > image.height) return 0;
        const dvec2 p = pixel - 0.5;
        const dvec2 base = glm::floor(p);
        const dvec2 f = p - base;
        const int x = static_cast<int>(base.x);
        const int y = static_cast<int>(base.y);
        return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), f.x),
                        glm::mix(texel(x, y + 1), texel(x + 1, y + 1), f.x), f.y);
    }
};

/// Returns the float64 sum at a pixel, counted from the lower left.
double gathered(const Mask& mask, const dvec2& source, const dvec2& pixel, int samples, double density, double exponent)
{
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        sum += mask.at(source + (pixel - source) * glsl::shaftStep(i, samples, density, 0)) *
               glsl::shaftStepWeight(i, samples, density, exponent);
    return sum;
}

using LongRays = Rays;

TEST_F(LongRays, LeaveThePictureAsItIsToTheBitWhenTheyAreOff)
{
    RayShot shot(RayTechnique::none);
    shot.rays().set(raysTable().view, RayView::picture);
    const Picture off = shot.take();
    shot.rays().set(raysTable().technique, RayTechnique::both);
    RayShot changed = shot;
    EXPECT_GT(test::largestDifference(off.image, shot.take().image), 0.05);
    // Strength 0 by every parameter, also with every pass forced to run.
    changed.rays().set(raysTable().weight, 0.0);
    changed.rays().set(raysTable().airDensity, 0.0);
    EXPECT_EQ(test::largestDifference(off.image, changed.take().image), 0);
    changed.request.frame.runEverything = true;
    EXPECT_EQ(test::largestDifference(off.image, changed.take().image), 0);
}

TEST_F(Rays, AreOfferedBesideThePictureWithoutThem)
{
    const std::size_t rays = *gallery().museum.find("crepuscular_rays");
    const SceneObject& subject = gallery().museum.subject(rays);
    for (const auto& [name, technique] :
         {std::pair{"without", RayTechnique::none}, {"screen", RayTechnique::screen}, {"air", RayTechnique::volume}}) {
        RayShot offered(RayTechnique::both), alone(technique);
        for (RayShot* shot : {&offered, &alone}) shot->rays().set(raysTable().view, RayView::picture);
        offered.sceneState = compare::otherSide(offered.sceneState, rays, compare::offeredComparison(subject, name));
        const Picture b = offered.take();
        EXPECT_GT(b.mean(), 0.001) << "an empty picture proves nothing";
        EXPECT_EQ(test::largestDifference(b.image, alone.take().image), 0) << name;
    }
}

TEST_F(Rays, OfTheSunBehindChangeNothing)
{
    // The reference projects a sun behind the camera into the middle of the picture, and draws rays there.
    RayShot shot(RayTechnique::none);
    shot.rays().set(raysTable().view, RayView::picture);
    const dvec3 sun(-0.049, 0.3256, -0.944);
    shot.see(dvec3(0, 5, 1), dvec3(0, 5, 1) - sun);
    const Picture off = shot.take();
    const glm::dvec4 clip = off.view.clipFromWorld * glm::dvec4(sun, 0);
    EXPECT_LT(clip.w, 0);
    EXPECT_LT(glm::length(dvec2(clip) / clip.w), 0.1);
    shot.rays().set(raysTable().technique, RayTechnique::screen);
    EXPECT_EQ(test::largestDifference(off.image, shot.take().image), 0);
    EXPECT_EQ(test::planned(gallery().museum, shot.sceneState, shot.request.frame).find("crepuscular_rays/mask"),
              nullptr);
}

TEST_F(Rays, InScreenSpaceAreInProportionToTheSunsStrengthDownToNone)
{
    // Rays only, from a white mask.
    RayShot shot(RayTechnique::screen);
    const double initial = std::get<double>(hallTable().rows()[hallTable().sunStrength.row].initial);
    const double mean = shot.take().mean();
    ASSERT_GT(mean, 0.01);
    for (const double share : {2.0, 0.5, 0.1, 1e-3}) {
        shot.hall().set(hallTable().sunStrength, share * initial);
        EXPECT_NEAR(shot.take().mean() / (share * mean), 1, 0.002) << share;
    }
    shot.hall().set(hallTable().sunStrength, 0.0);
    EXPECT_EQ(shot.take().mean(), 0);
}

TEST_F(LongRays, AreTheMeanThatFloat64Finds)
{
    // Sun in the picture, beyond its upper edge, and beyond its corner.
    const std::pair<dvec3, dvec3> views[] = {
        {{0.4, 1.65, -1}, {0.1, 3.8, -12}}, {{0.4, 1.65, -5}, {0.4, 1.6, -12}}, {{-3, 1.65, -6}, {1.5, 2.6, -12}}};
    double bent = 0;
    for (const auto& [eye, target] : views) {
        RayShot shot(RayTechnique::screen);
        shot.size(161, 91);
        shot.see(eye, target);
        shot.rays().set(raysTable().edgeFade, 8.0);
        shot.rays().set(raysTable().method, RayMethod::loop);
        shot.rays().set(raysTable().samples, 64);
        const Picture loop = shot.take();
        const Mask mask;
        const SunInPicture sun = sunInPicture(loop.view, shotTowardsSun);
        ASSERT_TRUE(sun.inFront);
        if (sun.beyond > 0) {
            // If the light were clamped to the picture, every ray would bend: the central one by this much.
            const auto angle = [](const dvec2& to) { return std::atan2(to.y - 45.5, to.x - 80.5); };
            bent = std::max(bent, std::abs(angle(sun.pixel) - angle(glm::clamp(sun.pixel, dvec2(0), dvec2(161, 91)))));
        }
        const double reach = std::max(glm::length(sun.pixel - dvec2(80.5, 45.5)) / 91, 1.0);
        const double density = glsl::shaftDensity(shot.rays()[raysTable().density], reach);
        const double exponent = glsl::shaftExponentAt(shot.rays()[raysTable().decay], reach);
        const double fade = glsl::shaftEdgeFade(sun.beyond, 8);
        double sky = 0;
        double worst = 0;
        double sumOfSquares = 0;
        shot.rays().set(raysTable().method, RayMethod::polar);
        shot.rays().set(raysTable().samples, 512);
        const Picture polar = shot.take();
        shot.rays().set(raysTable().method, RayMethod::threePasses);
        shot.rays().set(raysTable().samples, 1000);
        const Picture passes = shot.take();
        double polarSquares = 0;
        double passesSquares = 0;
        loop.each([&](int x, int y) {
            const dvec2 pixel(x + 0.5, 91 - y - 0.5);
            const double exact = gathered(mask, sun.pixel, pixel, 64, density, exponent) * fade * shot.white().y;
            const double fine = gathered(mask, sun.pixel, pixel, 600, density, exponent) * fade * shot.white().y;
            sky += mask.at(pixel);
            worst = std::max(worst, std::abs(loop.color(x, y).y - exact));
            sumOfSquares += std::pow(fine, 2);
            polarSquares += std::pow(polar.color(x, y).y - fine, 2);
            passesSquares += std::pow(passes.color(x, y).y - fine, 2);
        });
        const double pixels = 161 * 91;
        EXPECT_GT(sky, 100);
        EXPECT_GT(std::sqrt(sumOfSquares / pixels), 0.02);
        // Half floats, and a hardware sampler with a precision of 1/256 pixel.
        EXPECT_LT(worst, 0.004);
        EXPECT_LT(std::sqrt(polarSquares / pixels), 0.004);
        EXPECT_LT(std::sqrt(passesSquares / pixels), 0.006);
    }
    EXPECT_GT(bent, 3 * degree);
}

TEST_F(LongRays, OfMoreSamplesAreNoBrighter)
{
    RayShot shot(RayTechnique::screen);
    shot.size(320, 180);
    shot.rays().set(raysTable().jitter, true);
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
        const auto mean = [&](int samples, RaySum sum) {
            shot.rays().set(raysTable().method, method);
            shot.rays().set(raysTable().samples, samples);
            shot.rays().set(raysTable().sum, sum);
            return shot.take().mean();
        };
        const double many = mean(512, RaySum::mean);
        EXPECT_GT(many, 0.02);
        for (const int samples : {8, 27, 64, 216})
            EXPECT_NEAR(mean(samples, RaySum::mean) / many, 1, 0.005) << static_cast<int>(method) << ' ' << samples;
    }
    // Control: the reference's sum does.
    shot.rays().set(raysTable().sum, RaySum::plain);
    shot.rays().set(raysTable().samples, 64);
    const double few = shot.take().mean();
    shot.rays().set(raysTable().samples, 512);
    EXPECT_GT(shot.take().mean(), 1.5 * few);
}

TEST_F(Rays, OfADiskAreCenteredAtHalfSizeToATwentiethOfAPixel)
{
    // Without the hall, the sky shines within five degrees of the sun: a disk in the picture, with an odd or even
    // number of pixels.
    for (const glm::ivec2 size : {glm::ivec2(97, 55), glm::ivec2(96, 54), glm::ivec2(101, 53)}) {
        RayShot shot(RayTechnique::screen);
        shot.request.frame.alone = *gallery().museum.find("crepuscular_rays");
        shot.request.frame.transparent = true;
        shot.size(size.x, size.y);
        shot.see({0, 0, 0}, {-0.02, 0.36, -1});
        shot.rays().set(raysTable().lightSize, 0.17);
        shot.rays().set(raysTable().density, 0.3);
        shot.rays().set(raysTable().method, RayMethod::loop);
        const auto centroid = [&](RayResolution resolution) {
            shot.rays().set(raysTable().resolution, resolution);
            const Picture p = shot.take();
            dvec2 sum(0);
            double all = 0;
            p.each([&](int x, int y) {
                sum += dvec2(x, y) * p.color(x, y).y;
                all += p.color(x, y).y;
            });
            EXPECT_GT(all, 50);
            return sum / all;
        };
        const dvec2 full = centroid(RayResolution::full);
        EXPECT_LT(glm::length(centroid(RayResolution::half) - full), 0.05) << size.x << 'x' << size.y;
        if (size.x % 2 == 0) continue;
        // A texture of half the size that is stretched from edge to edge, as usual, shifts the disk.
        const render::Image coarse = gallery().renderer.read("crepuscular_rays.rays");
        double sum = 0;
        double all = 0;
        for (int y = 0; y < coarse.height; ++y)
            for (int x = 0; x < coarse.width; ++x) {
                sum += (x + 0.5) * coarse.at(x, y, 1);
                all += coarse.at(x, y, 1);
            }
        EXPECT_GT(std::abs(sum / all * size.x / coarse.width - (full.x + 0.5)), 0.2);
    }
}

TEST_F(Rays, OfTheOriginalAddUpToItsSumOnAWhiteMask)
{
    RayShot shot(RayTechnique::screen);
    shot.onWhite();
    shot.rays().set(raysTable().sum, RaySum::plain);
    shot.rays().set(raysTable().density, 1.0);
    shot.rays().set(raysTable().weight, 0.1);
    for (const double decay : {0.5, 0.96, 1.0}) {
        for (const int samples : {8, 128}) {
            shot.rays().set(raysTable().decay, decay);
            shot.rays().set(raysTable().samples, samples);
            const Picture p = shot.take();
            double sum = 0, share = 0.1;
            for (int i = 0; i < samples; ++i, share *= decay) sum += share;
            EXPECT_NEAR(p.color(40, 30).y / shot.white().y / sum, 1, 0.003) << decay << ' ' << samples;
        }
    }
}

TEST_F(Rays, WithoutDensityAreTheMaskToTheBit)
{
    RayShot shot(RayTechnique::screen);
    shot.rays().set(raysTable().density, 0.0);
    shot.rays().set(raysTable().method, RayMethod::loop);
    (void)shot.take();
    const render::Image mask = gallery().renderer.read("crepuscular_rays.mask");
    const render::Image gatheredImage = gallery().renderer.read("crepuscular_rays.rays");
    ASSERT_EQ(mask.width, gatheredImage.width);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) EXPECT_EQ(mask.at(x, y, 0), gatheredImage.at(x, y, 0)) << x << ',' << y;
}

TEST_F(Rays, HaveOneMaskWhicheverWayItIsMade)
{
    RayShot shot(RayTechnique::screen);
    std::vector<render::Image> masks;
    for (const RayMask mode : {RayMask::depth, RayMask::alpha, RayMask::occluders}) {
        shot.rays().set(raysTable().mask, mode);
        (void)shot.take();
        masks.push_back(gallery().renderer.read("crepuscular_rays.mask"));
    }
    double sky = 0;
    for (const float v : masks[0].pixels) sky += v;
    EXPECT_GT(sky, 200);
    EXPECT_EQ(test::largestDifference(masks[0], masks[1]), 0);
    EXPECT_EQ(test::largestDifference(masks[0], masks[2]), 0);
}

TEST_F(Rays, HaveOneMaskBehindWhatIsMarchedToo)
{
    // The torus-mug in front of the window has no mesh, but must hide the sky, too.
    RayShot shot(RayTechnique::screen);
    shot.see({0, 1.3, 2.2}, {0, 2.0, -12});
    std::vector<render::Image> masks;
    for (const RayMask mode : {RayMask::depth, RayMask::alpha, RayMask::occluders}) {
        shot.rays().set(raysTable().mask, mode);
        (void)shot.take();
        masks.push_back(gallery().renderer.read("crepuscular_rays.mask"));
    }
    EXPECT_EQ(test::largestDifference(masks[0], masks[1]), 0);
    EXPECT_EQ(test::largestDifference(masks[0], masks[2]), 0);
    // Control: without the object, more of the sky is visible.
    shot.values().set(test::sdfTable().boxSize, shot.values().rows()[test::sdfTable().boxSize.row].range.low);
    (void)shot.take();
    double hidden = 0;
    const render::Image open = gallery().renderer.read("crepuscular_rays.mask");
    for (std::size_t i = 0; i < open.pixels.size(); i += 4)
        hidden += static_cast<double>(open.pixels[i] - masks[2].pixels[i]);
    EXPECT_GT(hidden, 20);
}

TEST_F(Rays, AreWhereTheyShouldBeAtHalfSizeAndOddSizes)
{
    for (const glm::ivec2 size : {glm::ivec2(97, 55), glm::ivec2(96, 54), glm::ivec2(101, 53)}) {
        RayShot shot(RayTechnique::screen);
        shot.size(size.x, size.y);
        shot.rays().set(raysTable().method, RayMethod::loop);
        shot.rays().set(raysTable().samples, 256);
        const auto centroid = [&](RayResolution resolution) {
            shot.rays().set(raysTable().resolution, resolution);
            const Picture p = shot.take();
            dvec2 sum(0);
            double all = 0;
            p.each([&](int x, int y) {
                sum += dvec2(x, y) * p.color(x, y).y;
                all += p.color(x, y).y;
            });
            return sum / all;
        };
        const dvec2 full = centroid(RayResolution::full);
        EXPECT_LT(glm::length(centroid(RayResolution::half) - full), 0.3) << size.x << 'x' << size.y;
    }
}

TEST_F(Rays, JitterMovesTheGrainAndNotTheMean)
{
    RayShot shot(RayTechnique::both);
    shot.size(160, 90);
    shot.rays().set(raysTable().method, RayMethod::loop);
    shot.rays().set(raysTable().samples, 24);
    const double even = shot.take().mean();
    shot.rays().set(raysTable().jitter, true);
    EXPECT_NEAR(shot.take().mean() / even, 1, 0.01);
}

TEST_F(LongRays, OfATiledPictureAreThoseOfTheWhole)
{
    RayShot shot(RayTechnique::screen);
    shot.size(101, 75);
    shot.see({0, 1.3, 2.2}, {0, 2.4, -12});  // The ray-marched object hides some of the sky.
    for (const RayMethod method : {RayMethod::loop, RayMethod::threePasses, RayMethod::polar}) {
        for (const RayResolution resolution : {RayResolution::full, RayResolution::half}) {
            shot.rays().set(raysTable().method, method);
            shot.rays().set(raysTable().resolution, resolution);
            shot.request.largestTile = 37;
            const Picture tiled = shot.take();
            shot.request.largestTile = 2048;
            // A tile cannot sample its neighbors' passes, so a loop with the same number of samples replaces them.
            if (method == RayMethod::threePasses) shot.rays().set(raysTable().method, RayMethod::loop);
            const Picture whole = shot.take();
            EXPECT_GT(whole.mean(), 0.01);
            double worst = 0;
            int different = 0;
            whole.each([&](int x, int y) {
                const double d = glm::length(whole.color(x, y) - tiled.color(x, y));
                worst = std::max(worst, d);
                different += d > 2e-3;
            });
            if (resolution == RayResolution::full) {
                EXPECT_LT(worst, 2e-3) << static_cast<int>(method);
            }
            // At half size, corners of walls are rounded differently in each tile's clip space: one pixel in a hundred
            // may have another depth.
            EXPECT_LE(different, 101 * 75 / 100) << static_cast<int>(method);
            EXPECT_LT(test::colorDifference(whole, tiled), 0.003)
                << static_cast<int>(method) << ' ' << static_cast<int>(resolution);
        }
    }
}

TEST_F(Rays, JoinByTiles)
{
    RayShot shot(RayTechnique::volume);
    shot.size(101, 75);
    shot.rays().set(raysTable().jitter, true);
    for (const RayResolution resolution : {RayResolution::full, RayResolution::half, RayResolution::quarter}) {
        shot.rays().set(raysTable().resolution, resolution);
        shot.request.largestTile = 2048;
        const Picture whole = shot.take();
        shot.request.largestTile = 37;
        const Picture tiled = shot.take();
        int different = 0;
        whole.each([&](int x, int y) {
            different +=
                glm::length(whole.color(x, y) - tiled.color(x, y)) > 1e-3 + 0.01 * glm::length(whole.color(x, y));
        });
        // Corners of walls are rounded differently in each tile's clip space: one pixel in a hundred may have another
        // depth.
        EXPECT_LE(different, 101 * 75 / 100) << static_cast<int>(resolution);
    }
}

TEST_F(LongRays, LegalValuesNeverMakeWhatIsNotANumber)
{
    for (int i = 0; i < 30; ++i) {
        test::Random random(static_cast<std::uint64_t>(900 + i));
        RayShot shot(RayTechnique::both);
        shot.size(33, 19);
        ParameterValues& rays = shot.rays();
        for (std::size_t r = 0; r < rays.rows().size(); ++r) {
            const ParameterInfo& row = rays.rows()[r];
            if (row.kind == Kind::color)
                rays.setParameter(r, 0.5 + random.point(0.5));
            else if (row.kind == Kind::real || row.kind == Kind::count)
                rays.setParameter(r, i % 5 == 0   ? row.range.low
                                     : i % 5 == 1 ? row.range.high
                                                  : row.range.low + (row.range.high - row.range.low) *
                                                                        std::pow(random.number(0, 1), 3));
            else
                rays.setParameter(r, std::floor(random.number(
                                         0, row.kind == Kind::toggle ? 2 : static_cast<double>(row.choices.size()))));
        }
        rays.set(raysTable().samples, std::min(rays[raysTable().samples], 64));
        rays.set(raysTable().volumeSteps, std::min(rays[raysTable().volumeSteps], 32));
        shot.hall().set(hallTable().sunElevation, random.number(0.035, 1.5));
        const Picture p = shot.take();
        EXPECT_EQ(test::notFinite(p.image, 4), "") << i;
        float least = 0;
        p.each([&](int x, int y) {
            for (int c = 0; c < 3; ++c) least = std::min(least, p.image.at(x, y, c));
        });
        // The mask's colors are written so that they are displayed correctly. For saturated ones this has negative
        // components.
        if (rays[raysTable().view] != RayView::mask) {
            EXPECT_GE(least, -1e-4) << "settings " << i;
        }
    }
}

}  // namespace
}  // namespace vitrine::crepuscular_rays
