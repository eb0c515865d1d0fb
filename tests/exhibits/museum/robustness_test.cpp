// Unusual sizes, extreme values and times: no GL errors and only finite values.

#include "render/image/image_io.h"
#include "tests/stability/fields.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using namespace test;

class Robustness : public test::GlTest {};

TEST_F(Robustness, IsErrorFreeAtEverySizeWithEverySwitch)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 2), glm::ivec2(101, 57)}) {
        for (const bool inHall : {false, true}) {
            Shot shot;
            if (inHall) shot.inHall();
            shot.size(size.x, size.y);
            shot.request.frame.channels.evaluations = true;
            for (const bool glass : {false, true}) {
                shot.values().set(sdfTable().material, glass ? SdfMaterial::glass : SdfMaterial::opaque);
                shot.values().set(sdfTable().shownAs, glass ? SdfShown::mesh : SdfShown::field);
                shot.values().set(sdfTable().showBox, glass);
                const Picture p = shot.take();
                EXPECT_EQ(test::notFinite(p.image, 4), "") << size.x << 'x' << size.y;
                EXPECT_EQ(p.width(), size.x);
                EXPECT_EQ(p.height(), size.y);
            }
        }
    }
}

TEST_F(Robustness, EveryExhibitDrawsAtItsBestView)
{
    for (const auto& [i, exhibit] : gallery().museum.exhibits()) {
        if (capability<OverFrame>(exhibit)) continue;  // Light over the frame hits no surface: see "Rays".
        Shot shot;
        shot.request.frame.alone = i;
        shot.request.frame.camera = exhibit.bestView(shot.sceneState.values[i]);
        const Picture p = shot.take();
        EXPECT_EQ(test::notFinite(p.image, 4), "") << exhibit.name();
        EXPECT_GT(p.hits(), 96 * 54 / 10) << exhibit.name();
    }
}

TEST_F(Robustness, ThinAndTallPicturesAreNoSpecialCase)
{
    for (const glm::ivec2 size : {glm::ivec2(2000, 1), glm::ivec2(1, 2000), glm::ivec2(17, 400)}) {
        Shot shot;
        shot.size(size.x, size.y);
        EXPECT_EQ(test::notFinite(shot.take().image, 4), "");
    }
}

TEST_F(Robustness, APictureOfNothingIsRefused)
{
    Shot shot;
    shot.size(0, 5);
    EXPECT_THROW((void)shot.take(), std::exception);
    // A window of height 0 is no error: nothing is drawn.
    FrameRequest frame = shot.request.frame;
    frame.raster.size = {0, 0};
    EXPECT_TRUE(gallery().renderer.draw(test::planned(gallery().museum, shot.sceneState, frame)).ran.empty());
}

/// Sets random legal values of all parameters: half of them from the comfortable range, half from the legal one.
void shuffle(ParameterValues& values, test::Random& random)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        const bool wild = random.number(0, 1) < 0.5;
        const double low = wild ? row.range.low : row.range.softLow;
        const double high = wild ? row.range.high : row.range.softHigh;
        switch (row.kind) {
        case Kind::real:
        case Kind::count: {
            const double t = random.number(0, 1) < 0.2 ? std::round(random.number(0, 1)) : random.number(0, 1);
            values.setParameter(i, row.range.scale == Scale::logarithmic ? low * std::pow(high / low, t)
                                                                         : low + (high - low) * t);
            break;
        }
        case Kind::toggle: values.setParameter(i, std::floor(random.number(0, 2))); break;
        case Kind::choice:
            values.setParameter(i, std::floor(random.number(0, static_cast<double>(row.choices.size()))));
            break;
        case Kind::color: values.setParameter(i, 0.5 + random.point(0.5)); break;
        case Kind::direction: values.setParameter(i, random.direction()); break;
        case Kind::file:
        case Kind::text: break;
        }
    }
}

TEST_F(Robustness, LegalValuesNeverMakeWhatIsNotANumber)
{
    const double hostile[] = {
        0, 1e6, -3.5, 1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 24; ++i) {
        SCOPED_TRACE("set " + std::to_string(i));
        test::Random random(static_cast<std::uint64_t>(100 + i));
        Shot shot;
        shuffle(shot.values(), random);
        shuffle(shot.hall(), random);
        // Higher values take a minute and test nothing more.
        shot.values().set(sdfTable().tessellation, std::min(shot.values()[sdfTable().tessellation], 40));
        shot.values().set(sdfTable().shadowRays, std::min(shot.values()[sdfTable().shadowRays], 24));
        shot.hall().set(hallTable().shadowMapSize, 256);
        shot.hall().set(hallTable().probeSize, i % 3 == 0 ? 16 : 32);
        shot.hall().set(hallTable().probeSamples, 4);
        if (i % 4 == 3)
            shot.inHall();
        else
            shot.request.frame.camera = gallery().museum.subject(shot.exhibit).bestView(shot.values());
        shot.size(32, 18);
        shot.request.frame.time = hostile[i % 6];
        shot.request.frame.channels.evaluations = true;
        const Picture p = shot.take();
        EXPECT_EQ(test::notFinite(p.image, 4), "");
        p.each([&](int x, int y) {
            EXPECT_GE(p.image.at(x, y, 4), 0) << "depth";  // Fails for NaN, too.
            for (int c = 5; c < 9; ++c) EXPECT_TRUE(std::isfinite(p.image.at(x, y, c))) << "channel " << c;
            for (int c = 0; c < 3; ++c) EXPECT_GE(p.image.at(x, y, c), -1e-4) << "negative light";
        });
        if (!shot.hall()[hallTable().reflectionProbe]) continue;
        for (const float value : gallery().renderer.read("probe.irradiance").pixels)
            EXPECT_TRUE(std::isfinite(value)) << "probe";
    }
}

/// View that shows numbers, or a picture made from them, as display colors.
struct NumbersShown {
    const char* exhibit;
    const char* row;
    double value;
};

TEST_F(Robustness, WhatIsShownAsNumbersIsTheSameColorInFilesOfLight)
{
    for (const NumbersShown& view : {NumbersShown{"sdf_morph", "heatMap", 1}, NumbersShown{"sdf_morph", "heatMap", 2},
                                     NumbersShown{"sdf_morph", "heatMap", 3}, NumbersShown{"sdf_morph", "heatMap", 4},
                                     NumbersShown{"ice_cream", "heatMap", 4}, NumbersShown{"sdf_scenes", "heatMap", 1},
                                     NumbersShown{"sdf_scenes", "heatMap", 3}, NumbersShown{"sdf_scenes", "look", 2},
                                     NumbersShown{"pixel_art", "view", 0}, NumbersShown{"pixel_art", "view", 1},
                                     NumbersShown{"crepuscular_rays", "view", 1}}) {
        SCOPED_TRACE(std::string(view.exhibit) + '.' + view.row + ' ' + std::to_string(view.value));
        Shot shot;
        const std::size_t exhibit = *gallery().museum.find(view.exhibit);
        ParameterValues& values = shot.sceneState.values[exhibit];
        values.setParameter(*values.table().find(view.row), view.value);
        shot.request.frame.alone = exhibit;
        shot.request.frame.transparent = std::string_view(view.exhibit) != "crepuscular_rays";
        shot.request.frame.camera = gallery().museum.subject(exhibit).bestView(values);
        shot.size(48, 27);
        const Picture light = shot.take();
        shot.request.frame.averageIn = AverageIn::display;
        const Picture shown = shot.take();
        // One exposure for all pixels: that of the brightest.
        double brightest = 0, exposure = 0;
        light.each([&](int x, int y) {
            for (int c = 0; c < 3; ++c) {
                if (light.alpha(x, y) < 1 || shown.color(x, y)[c] <= brightest) continue;
                brightest = shown.color(x, y)[c];
                exposure = brightest / light.color(x, y)[c];
            }
        });
        ASSERT_GT(brightest, 0.1);
        light.each([&](int x, int y) {
            EXPECT_LE(light.alpha(x, y), 1);
            for (int c = 0; c < 3; ++c) EXPECT_GE(light.color(x, y)[c], 0) << "negative light";
            if (light.alpha(x, y) < 1) return;
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(exposure * light.color(x, y)[c], shown.color(x, y)[c], 2e-3);
        });
    }
}

TEST_F(Robustness, APanoramaWithTexelsThatAreNoNumbersLeavesThePictureFinite)
{
    const test::TemporaryFolder folder;
    render::Image panorama(16, 8, 3, 0.5F);
    panorama.at(3, 3, 0) = std::numeric_limits<float>::infinity();
    panorama.at(5, 4, 1) = std::numeric_limits<float>::quiet_NaN();
    panorama.at(9, 2, 2) = -std::numeric_limits<float>::infinity();
    render::writePicture(folder / "hostile.exr", panorama, render::PictureFormat::exr);
    Shot shot;
    shot.hall().set(hallTable().environment, (folder / "hostile.exr").string());
    shot.request.frame.transparent = false;
    for (const double roughness : {0.0, 1.0}) {
        shot.values().set(sdfTable().roughness, roughness);
        const Picture p = shot.take();
        EXPECT_EQ(test::notFinite(p.image, 4), "");
        p.each([&](int x, int y) { EXPECT_GE(p.luminance(x, y), -1e-4) << x << ',' << y; });
    }
}

TEST_F(Robustness, WhereNothingIsThereIsNeitherDepthNorNormal)
{
    for (const bool inHall : {false, true}) {
        Shot shot;
        if (inHall) shot.inHall().see({0, 3, 6}, {0, 4, -20});  // The sky through the window.
        shot.request.frame.transparent = false;
        const Picture p = shot.take();
        int sky = 0;
        p.each([&](int x, int y) {
            if (p.hit(x, y)) {
                EXPECT_NEAR(glm::length(p.normal(x, y)), 1, 1e-3) << x << ',' << y;
                return;
            }
            ++sky;
            EXPECT_EQ(p.normal(x, y), glm::dvec3(0)) << x << ',' << y;
            EXPECT_EQ(p.alpha(x, y), 1);
        });
        EXPECT_GT(sky, 20) << (inHall ? "hall" : "alone");
    }
}

TEST_F(Robustness, ATimeFarOffShowsWhatItsPhaseShows)
{
    Shot shot;
    shot.values().set(sdfTable().animate, true);
    shot.values().set(sdfTable().speed, 0.125);
    shot.request.frame.time = 2.5;
    const Picture now = shot.take();
    for (const double later : {8e5, 8e8}) {
        shot.request.frame.time = 2.5 + later;  // Whole periods of 8 s.
        EXPECT_EQ(test::largestDifference(shot.take().image, now.image), 0) << later;
    }
    shot.request.frame.time = 3;
    EXPECT_GT(test::largestDifference(shot.take().image, now.image), 0);
}

TEST_F(Robustness, TheRendererKeepsNothingOfASizeThatIsGone)
{
    Shot shot;
    const Picture before = shot.take();
    const auto images = [&] { return shot.take().report.counters.at("images"); };
    const std::int64_t count = images();
    for (int i = 1; i < 20; ++i) {
        shot.size(i, 2 * i);
        (void)shot.take();
    }
    shot.size(96, 54);
    EXPECT_EQ(test::largestDifference(shot.take().image, before.image), 0);
    EXPECT_EQ(images(), count);
}

}  // namespace
}  // namespace vitrine
