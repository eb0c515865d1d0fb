// The picture as a whole: a function of its inputs, independent of tiles, sampling and earlier pictures.

#include "tests/support/gallery.h"
#include "tests/support/planned.h"
#include "tests/support/tone_cpu.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using namespace test;

class PictureTest : public test::GlTest {};

using LongPictureTest = PictureTest;

TEST_F(PictureTest, IsTheSameTwice)
{
    for (const bool inHall : {false, true}) {
        Shot shot;
        if (inHall) shot.inHall();
        shot.request.samples = 3;
        EXPECT_EQ(test::largestDifference(shot.take().image, shot.take().image), 0);
    }
}

TEST_F(PictureTest, IsTheSameWhateverWasDrawnBefore)
{
    // Data kept between frames (shadow map, probe, average) must not depend on more than their key.
    for (const bool inHall : {false, true}) {
        Shot shot;
        if (inHall) shot.inHall();
        shot.hall().set(hallTable().sunAzimuth, 0.0);
        shot.hall().set(hallTable().sunElevation, 0.21);
        const Picture before = shot.take();
        Shot other;
        other.size(33, 21).values().set(sdfTable().morph, 0.0);
        other.hall().set(hallTable().sunElevation, 0.8);
        other.request.samples = 2;
        (void)other.take();
        Shot moved = shot;  // Same light, another object while the probe is captured again ...
        moved.values().set(sdfTable().morph, 0.0);
        (void)moved.take();
        EXPECT_EQ(test::largestDifference(shot.take().image, before.image), 0) << (inHall ? "in the hall" : "alone");
    }
}

TEST_F(PictureTest, IsTheSameByANewRenderer)
{
    Shot shot;
    shot.inHall();
    shot.hall().set(hallTable().sunAzimuth, 0.0);
    shot.hall().set(hallTable().sunElevation, 0.21);
    const Picture seasoned = shot.take();
    render::gl::Renderer fresh;
    PictureMaker maker(gallery().museum, fresh, shot.sceneState, shot.request);
    while (maker.step()) {
    }
    EXPECT_EQ(test::largestDifference(maker.picture(), seasoned.image), 0);
}

TEST_F(LongPictureTest, RunningEverythingChangesNothingButTheCost)
{
    for (const bool inHall : {false, true}) {
        Shot shot;
        if (inHall) shot.inHall();
        const Picture needed = shot.take();
        shot.request.frame.runEverything = true;
        EXPECT_EQ(test::largestDifference(shot.take().image, needed.image), 0);
        // Also from behind: invisible parts are then ray marched.
        shot.request.frame.runEverything = false;
        shot.see({0, 1.6, 3}, {0, 1.6, 12});
        const Picture behind = shot.take();
        shot.request.frame.runEverything = true;
        EXPECT_EQ(test::largestDifference(shot.take().image, behind.image), 0);
    }
}

TEST_F(PictureTest, AloneIsTheSameByTilesToTheBit)
{
    Shot shot;
    shot.size(101, 75);
    shot.request.frame.channels.evaluations = true;
    shot.request.frame.transparent = false;
    const Picture whole = shot.take();
    for (const int side : {37, 16, 64}) {
        shot.request.largestTile = side;
        const Picture tiled = shot.take();
        int different = 0;
        std::string where;
        for (std::size_t i = 0; i < whole.image.pixels.size(); ++i) {
            if (whole.image.pixels[i] == tiled.image.pixels[i]) continue;
            ++different;
            where = " last in channel " + whole.image.channelNames[i % static_cast<std::size_t>(whole.image.channels)];
        }
        EXPECT_EQ(different, 0) << where << "values of " << whole.image.pixels.size() << " with tiles of " << side
                                << ", largest difference " << test::largestDifference(whole.image, tiled.image);
    }
}

TEST_F(PictureTest, AloneIsTheSameByTilesWithSupersamplingToo)
{
    Shot shot;
    shot.size(61, 45);
    shot.request.samples = 5;
    const Picture whole = shot.take();
    shot.request.largestTile = 37;
    EXPECT_EQ(test::largestDifference(whole.image, shot.take().image), 0);
}

TEST_F(PictureTest, InTheHallIsTheSameByTilesToOneLevel)
{
    // Corners of walls are rounded differently in each tile's clip space. The difference is at most a level of 255,
    // except for one pixel in a thousand: where two surfaces meet, the other one may be visible, and a comparison with
    // the shadow map may have another result. One of the 25 texels of the tent filter has a weight of at most 49/144 of
    // a quarter, 8.5 % of the sun's light: 22 levels of a pixel that is white in the sun and black in shade.
    // Ray-marched surfaces are exactly equal.
    Shot shot;
    shot.inHall().size(101, 75);
    shot.request.frame.averageIn = AverageIn::display;
    const Picture whole = shot.take();
    Shot alone = shot;
    alone.request.frame.alone = shot.exhibit;
    alone.request.frame.subject.reset();
    const Picture object = alone.transform(shot.worldFromExhibit()).take();
    shot.request.largestTile = 37;
    const Picture tiled = shot.take();
    int beyond = 0;
    whole.each([&](int x, int y) {
        double worst = 0;
        for (int c = 0; c < 4; ++c) {
            const auto code = [](double linear) {
                return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
            };
            worst = std::max(worst, 255 * std::abs(code(whole.image.at(x, y, c)) - code(tiled.image.at(x, y, c))));
        }
        const bool same = glm::length(whole.normal(x, y) - tiled.normal(x, y)) < 0.1;
        beyond += !same || worst > 1;
        if (same) {
            EXPECT_LE(worst, 22) << x << ',' << y;
        }
        if (object.hit(x, y) && object.depth(x, y) == whole.depth(x, y)) {
            EXPECT_EQ(worst, 0) << x << ',' << y;
        }
    });
    EXPECT_LE(beyond, 101 * 75 / 1000);
    EXPECT_EQ(whole.hits(), tiled.hits());
}

TEST_F(PictureTest, ConvergesWithMoreSamples)
{
    Shot shot;
    shot.size(48, 27);
    shot.request.frame.transparent = false;
    shot.request.frame.averageIn = AverageIn::display;
    const auto with = [&](int samples) {
        shot.request.samples = samples;
        return shot.take();
    };
    const Picture reference = with(128);
    const double one = test::colorDifference(with(1), reference);
    const double four = test::colorDifference(with(4), reference);
    const double sixteen = test::colorDifference(with(16), reference);
    EXPECT_LT(four, 0.75 * one);
    EXPECT_LT(sixteen, 0.75 * four);
    // Control: the samples differ.
    EXPECT_GT(one, 0.005);
}

TEST_F(PictureTest, CoverageAtTheEdgeIsBetweenNothingAndAll)
{
    Shot shot;
    shot.request.samples = 16;
    const Picture p = shot.take();
    int partial = 0;
    p.each([&](int x, int y) {
        EXPECT_GE(p.alpha(x, y), 0);
        EXPECT_LE(p.alpha(x, y), 1 + 1e-5);
        partial += p.alpha(x, y) > 0.01 && p.alpha(x, y) < 0.99;
    });
    EXPECT_GT(partial, 50);
    EXPECT_EQ(p.alpha(0, 0), 0);
}

TEST_F(PictureTest, TransparencyTakesTheBackgroundAwayAndNothingElse)
{
    Shot shot;
    const Picture transparent = shot.take();
    shot.request.frame.transparent = false;
    const Picture opaque = shot.take();
    opaque.each([&](int x, int y) {
        EXPECT_EQ(opaque.alpha(x, y), 1);
        EXPECT_EQ(transparent.alpha(x, y), transparent.hit(x, y) ? 1 : 0);
        if (transparent.hit(x, y)) {
            EXPECT_EQ(opaque.color(x, y), transparent.color(x, y));
        }
    });
}

TEST_F(PictureTest, ShadowsAndProbeCanBeSwitchedOffAndAreSeen)
{
    Shot shot;
    shot.inHall();
    const Picture all = shot.take();
    Shot noShadows = shot;
    noShadows.hall().set(hallTable().sunShadows, false);
    EXPECT_GT(test::colorDifference(noShadows.take(), all), 0.01);
    Shot noProbe = shot;
    noProbe.hall().set(hallTable().reflectionProbe, false);
    EXPECT_GT(test::colorDifference(noProbe.take(), all), 0.01);
    Shot noBake = shot;
    noBake.hall().set(hallTable().bakedLight, false);
    EXPECT_GT(test::colorDifference(noBake.take(), all), 0.005);
}

TEST_F(PictureTest, EveryShadowFilterAndMapSizeDrawsTheSameShadow)
{
    Shot shot;
    shot.inHall();
    shot.hall().set(hallTable().shadowMapSize, 2048);
    const Picture fine = shot.take();
    for (const hall::ShadowFilter filter : {hall::ShadowFilter::hard, hall::ShadowFilter::tent3})
        for (const int size : {1024, 2048}) {
            shot.hall().set(hallTable().shadowFilter, filter);
            shot.hall().set(hallTable().shadowMapSize, size);
            const Picture other = shot.take();
            EXPECT_GT(test::largestDifference(other.image, fine.image), 0);
            EXPECT_NEAR(other.mean() / fine.mean(), 1, 0.02) << size;
        }
}

TEST_F(PictureTest, AStopOfExposureDoublesTheLightBeforeTheCurve)
{
    // Linear light is returned unchanged: exposure applies to the displayed picture only.
    Shot shot;
    const Picture linear = shot.take();
    shot.hall().set(hallTable().exposure, 1.0);
    EXPECT_EQ(test::largestDifference(shot.take().image, linear.image), 0);
    shot.request.frame.averageIn = AverageIn::display;
    const Picture bright = shot.take();
    shot.hall().set(hallTable().exposure, 0.0);
    const Picture normal = shot.take();
    EXPECT_GT(bright.mean(), 1.1 * normal.mean());
    bright.each([&](int x, int y) { EXPECT_LE(bright.luminance(x, y), 1.0001); });
}

TEST_F(PictureTest, TheDisplayShowsTheChosenToneCurveOfTheLight)
{
    constexpr double exposure = 1.04;  // Exposure of the studio.
    Shot shot;
    const Picture light = shot.take();
    shot.request.frame.averageIn = AverageIn::display;
    render::Image before;
    for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE(test::toneCurves[i].name);
        shot.hall().set(hallTable().toneCurve, static_cast<hall::ToneCurve>(i));
        const Picture shown = shot.take();
        int opaque = 0;
        shown.each([&](int x, int y) {
            if (light.alpha(x, y) < 1) return;
            ++opaque;
            const glm::dvec3 expected = test::toneCurves[i].map(light.color(x, y) * exposure);
            EXPECT_LT(glm::length(shown.color(x, y) - expected), 2e-3);
        });
        EXPECT_GT(opaque, 100);
        if (i > 0) {
            EXPECT_GT(test::largestDifference(shown.image, before), 0.02) << "a control: curves differ";
        }
        before = shown.image;
    }
}

TEST_F(PictureTest, APressedButtonIsSquashed)
{
    Shot shot;
    shot.inHall();
    shot.see({0.72, 1.4, 1.5}, {0.72, 0.95, 0.62});
    shot.request.frame.camera.fovY = 0.3;
    const auto red = [&](double since) {
        shot.request.frame.sincePressed = {1e9, since};
        const Picture p = shot.take();
        int count = 0;
        p.each([&](int x, int y) {
            count += p.color(x, y).r > 4 * p.color(x, y).g && p.color(x, y).r > 4 * p.color(x, y).b;
        });
        return count;
    };
    const int rest = red(1e9);
    EXPECT_GT(rest, 50);
    EXPECT_LT(red(0.1), 0.8 * rest);
    EXPECT_EQ(red(0.2), rest);
}

TEST_F(LongPictureTest, OutOfViewTheExhibitsCostWhatAHallWithoutExhibitsCosts)
{
    // The initial state, toward the floor in front of the door: no exhibit, stand or sunbeam is in view. The dust
    // always is, and takes one pass.
    const Museum empty{std::vector<std::unique_ptr<Exhibit>>{}};
    const auto counters = [](const Museum& museum, const glm::dvec3& target, bool dusty = false) {
        render::gl::Renderer renderer;
        SceneState sceneState = museum.initialSceneState();
        sceneState.hall().set(hallTable().shadowMapSize, 512);
        sceneState.hall().set(hallTable().probeSize, 32);
        if (const auto rays = museum.find("crepuscular_rays"); rays && !dusty)
            sceneState.values[*rays].set(test::raysTable().airDensity, 0.0);
        FrameRequest frame;
        frame.raster.size = {64, 36};
        frame.camera = {{0.5, 1.65, 9}, target, 0.959931};
        (void)renderer.draw(
            test::planned(museum, sceneState, frame, renderer.persistentState()));  // Shadow map and probe exist now.
        auto all = renderer.draw(test::planned(museum, sceneState, frame, renderer.persistentState())).counters;
        all.erase("programs");  // Counts all programs built so far.
        return all;
    };
    const glm::dvec3 away(0.5, 1.2, 12);
    auto bare = counters(empty, away);
    auto furnished = counters(gallery().museum, away);
    // The sun's map of static objects is kept beside the one with the mobile, if there is a mobile.
    EXPECT_EQ(furnished["images"], bare["images"] + 1);
    furnished.erase("images");
    bare.erase("images");
    EXPECT_EQ(furnished, bare);
    // Higher up, the beam of the oculus is in view, with two more passes: its march and its compositing.
    EXPECT_EQ(counters(gallery().museum, away, true)["passes"], bare["passes"] + 1);
    auto beam = counters(gallery().museum, {0.5, 3.2, 12}, true);
    EXPECT_EQ(beam["passes"], counters(empty, {0.5, 3.2, 12})["passes"] + 2);
    EXPECT_GT(counters(gallery().museum, {0, 1.4, 0})["passes"], bare["passes"] + 2);
}

}  // namespace
}  // namespace vitrine
