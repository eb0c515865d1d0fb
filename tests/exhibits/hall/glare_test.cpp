// Glare: halos around light that is brighter than the screen's white.
#include "exhibits/hall/hall_scene.h"
#include "exhibits/museum/picture.h"
#include "render/measure/metrics.h"
#include "tests/support/gallery.h"
#include "tests/support/plan_steps.h"
#include "tests/support/planned.h"
#include "tests/support/tone_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace vitrine::hall {
namespace {

using namespace test;
using glm::dvec3;

class GlareOfLight : public GlTest {};

/// Lanterns through their frame in the hall by day, as a display shows them.
Shot lanterns()
{
    Shot shot("paper_lanterns");
    shot.inHall().size(160, 90);
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.frame.channels = {};
    shot.request.frame.transparent = false;
    shot.hall().set(hallTable().glare, 1.0);
    return shot;
}

/// Exposure of the hall by day, and the share of light above white that each octave of angles gets.
constexpr double exposure = 7.5, share = 0.0133;
/// Levels of that picture: the texels of the last one are at most half as high as the picture of 90 rows.
constexpr int levels = 4;

dvec3 colorAt(const render::Image& image, int x, int y)
{
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// Returns the light above white of a radiance.
dvec3 aboveWhite(const dvec3& radiance)
{
    const dvec3 c = exposure * radiance;
    return c * std::max(1 - 1 / std::max({c.r, c.g, c.b, 1.0}), 0.0);
}

/// Images of one frame: radiance, halos at a quarter of the resolution, and what the display shows.
struct Images {
    render::Image radiance, halos, shown;
};

Images imagesOf(const Shot& shot)
{
    (void)gallery().renderer.draw(planned(gallery().museum, shot.sceneState, shot.request.frame));
    return {gallery().renderer.read(radianceImage), gallery().renderer.read("glare.spread"),
            gallery().renderer.read("frame")};
}

using LongGlareOfLight = GlareOfLight;

TEST_F(LongGlareOfLight, ScattersLightAndCreatesNone)
{
    const Images images = imagesOf(lanterns());
    dvec3 all(0), above(0), halos(0);
    const double pixels = 160 * 90;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x) {
            all += exposure * colorAt(images.radiance, x, y) / pixels;
            above += aboveWhite(colorAt(images.radiance, x, y)) / pixels;
            halos += colorAt(images.halos, x / 4, images.halos.height - 1 - (89 - y) / 4) / pixels;
        }
    ASSERT_GT(above.r, 0.05 * all.r) << "nothing in this picture is bright";
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(halos[c], share * levels * above[c], 0.01 * all[c]) << c;
        // Each octave gets its share: without one level, 25 % would be missing.
        EXPECT_NEAR(halos[c] / (share * levels * above[c]), 1, 0.08) << c;
    }
}

TEST_F(GlareOfLight, IsTakenFromThePixelsThatShineAndToneMappedWithTheRest)
{
    const Images images = imagesOf(lanterns());
    const render::Image& halos = images.halos;
    double worst = 0, control = 0;
    for (int y = 4; y < 86; ++y)
        for (int x = 4; x < 156; ++x) {
            // Bilinear between the texels, which cover 4 x 4 pixels each.
            const glm::dvec2 at((x + 0.5) / 4 - 0.5, (89 - y + 0.5) / 4 - 0.5);
            const glm::ivec2 low = glm::floor(at);
            const glm::dvec2 f = at - glm::dvec2(low);
            const auto texel = [&](int i, int j) { return colorAt(halos, low.x + i, halos.height - 1 - low.y - j); };
            const dvec3 halo = (texel(0, 0) * (1 - f.x) + texel(1, 0) * f.x) * (1 - f.y) +
                               (texel(0, 1) * (1 - f.x) + texel(1, 1) * f.x) * f.y;
            const dvec3 radiance = colorAt(images.radiance, x, y);
            const dvec3 left = exposure * radiance - share * levels * aboveWhite(radiance);
            const dvec3 shown = colorAt(images.shown, x, y);
            worst = std::max(worst, glm::length(shown - glsl::toneVitrine(left + halo)));
            control = std::max(control, glm::length(shown - glsl::toneVitrine(exposure * radiance)));
        }
    EXPECT_LT(worst, 4e-3);
    EXPECT_GT(control, 0.02);
}

TEST_F(GlareOfLight, MakesHalosThatFadeAwayFromALight)
{
    Shot shot = lanterns();
    shot.size(320, 180);
    shot.hall().resetParameter(hallTable().glare.row);
    ParameterValues& values = shot.values();
    // Only the moon shines, in the upper left part of the picture.
    for (const auto& [row, value] : std::initializer_list<std::pair<const char*, double>>{
             {"crowding", 0}, {"stars", 0}, {"hallGlow", 0}, {"moon", 1}})
        values.setParameter(values.table().find(row).value(), value);
    const render::Image with = shot.take().image;
    shot.hall().set(hallTable().glare, 0.0);
    const Picture without = shot.take();
    glm::ivec2 moon(0);
    without.each([&](int x, int y) {
        if (y < 90 && without.luminance(x, y) > without.luminance(moon.x, moon.y)) moon = {x, y};
    });
    const auto halo = [&](int off) {
        const auto code = [](double linear) { return 255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055); };
        return code(with.at(moon.x + off, moon.y, 0)) - code(without.image.at(moon.x + off, moon.y, 0));
    };
    // At 10 pixels of a picture that is 1280 wide, from the edge of the moon's disk.
    int edge = 0;
    while (without.luminance(moon.x + edge, moon.y) > 0.3) ++edge;
    EXPECT_GT(halo(edge + 3), 3);
    EXPECT_GT(halo(edge + 3), halo(edge + 8));
    EXPECT_GT(halo(edge + 8), halo(edge + 24));
    EXPECT_GE(halo(edge + 24), 0);
}

TEST_F(LongGlareOfLight, GoesAcrossTheTilesOfAPicture)
{
    const auto pictureOf = [](int tile, double glare) {
        Shot shot = lanterns();
        shot.hall().set(hallTable().glare, glare);
        shot.request.samples = 2;
        shot.request.largestTile = tile;
        PictureMaker maker(gallery().museum, gallery().renderer, shot.sceneState, shot.request);
        while (maker.step())
            ;
        return maker.picture();
    };
    const render::Image whole = pictureOf(2048, 4), tiled = pictureOf(64, 4), without = pictureOf(64, 0);
    EXPECT_LT(render::colorDifference(whole, tiled).max, 0.02);
    EXPECT_GT(render::colorDifference(whole, without).max, 0.1) << "control: tiles without halos";
}

TEST_F(GlareOfLight, IsLeftOutForAReason)
{
    const auto why = [](const Shot& shot) {
        const render::FramePlan plan = planned(gallery().museum, shot.sceneState, shot.request.frame);
        EXPECT_EQ(reasonFor(plan, "glare"), reasonFor(plan, "glare/spread"));
        return reasonFor(plan, "glare");
    };
    const Shot lit = lanterns();
    EXPECT_EQ(why(lit), "it ran");
    Shot off = lit;
    off.hall().set(hallTable().glare, 0.0);
    EXPECT_EQ(why(off), "the strength of the glare is 0");
    Shot linear = lit;
    linear.request.frame.averageIn = AverageIn::radiance;
    EXPECT_EQ(why(linear), "linear light is requested");
    Shot transparent = lit;
    transparent.request.frame.transparent = true;
    EXPECT_EQ(why(transparent), "a transparent background is requested");
    Shot tile = lit;
    tile.request.frame.raster.tile = {64, 64};
    EXPECT_EQ(why(tile), "the picture is drawn in tiles, and halos reach beyond them");
    // The vault at night, without lamps.
    Shot dark = lit;
    dark.request.frame.camera = {{0, 1.65, 8}, {0, 9, 7.9}, 0.9};
    EXPECT_EQ(why(dark), "it ran");
    dark.hall().set(hallTable().sunStrength, 0.0);
    dark.hall().set(hallTable().skyStrength, 0.01);
    dark.hall().set(hallTable().lamps, LampsLit::off);
    for (ParameterValues& values : dark.sceneState.values)
        for (const char* lamp : {"lamp", "hallGlow"})
            if (const auto row = values.table().find(lamp)) values.setParameter(*row, 0.0);
    EXPECT_EQ(why(dark), "nothing is brighter than the screen's white");
}

}  // namespace
}  // namespace vitrine::hall
