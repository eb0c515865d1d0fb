// Small pictures from the GPU: normals compared with the same methods at float64, palettes, halves, steps.

#include "exhibits/pixel_art/normals_cpu.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "render/image/srgb.h"
#include "tests/exhibits/pixel_art/pixel_art_pictures.h"
#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace vitrine::pixel_art {
namespace {

using namespace test;
using glm::dvec3;
using glm::ivec2;
using render::Image;

/// Images of a small picture.
struct Small {
    Image truth, normal, depth, lit, shown;
    PixelBlock block;
};

/// Small picture of the test scene, without the hall.
struct SmallShot {
    ParameterValues values = table().initial();
    PaletteTextures palette;
    ivec2 size{120, 68};
    std::vector<WorldPart> parts = testParts(0.5);

    SmallShot()
    {
        values.set(table().parallax, 0.0);
        values.set(table().world, PixelWorld::testScene);
        values.set(table().palette, PaletteName::none);
    }
    [[nodiscard]] Small take()
    {
        PixelShot shot{table(), values, pixelCamera(table(), values, {0, 0}), 0.5};
        shot.camera.size = size;
        shot.parts = parts;
        if (const auto colors = shippedPalette(values[table().palette]); !colors.empty()) {
            palette = paletteTextures({colors.begin(), colors.end()});
            shot.palette = &palette;
        }
        render::FramePlan plan;
        plan.view.raster.size = size;
        plan.allSlices = true;
        Small made;
        made.block = planPixelPicture(shot, plan);
        EXPECT_TRUE(plan.errors().empty()) << plan.errors().front();
        plan.prune({pixelTruthImage, pixelSurfaceImage, pixelDrawnDepthImage, pixelLitImage, pixelShownImage});
        render::gl::Renderer& renderer = gallery().renderer;
        renderer.draw(plan);
        made.truth = renderer.read(pixelTruthImage);
        made.normal = normalsOf(renderer.read(pixelSurfaceImage));
        made.depth = renderer.read(pixelDrawnDepthImage);
        made.lit = renderer.read(pixelLitImage);
        made.shown = renderer.read(pixelShownImage);
        return made;
    }
};

class PixelPictures : public GlTest {};

using LongPixelPictures = PixelPictures;

TEST_F(PixelPictures, NormalsAreThoseOfTheSameMethodAtFloat64)
{
    for (const PixelProjection projection : {PixelProjection::orthographic, PixelProjection::perspective})
        for (const NormalsBy method : {NormalsBy::tap3, NormalsBy::tap4, NormalsBy::tap5, NormalsBy::tap9,
                                       NormalsBy::tap9Plus, NormalsBy::parabola, NormalsBy::vote}) {
            SmallShot shot;
            shot.values.set(table().projection, projection);
            shot.values.set(table().method, method);
            const Small small = shot.take();
            glsl::NormalsFromDepth methods{
                [&](ivec2 p) -> double { return small.depth.at(p.x, small.depth.height - 1 - p.y); }};
            const PixelBlock& b = small.block;
            const decltype(methods)::DepthLens lens{
                glm::dvec2(b.halfExtent), b.nearPlane, b.farPlane, b.orthographic, false, b.size, 0};
            int off = 0, seen = 0;
            for (int y = 0; y < b.size.y; ++y)
                for (int x = 0; x < b.size.x; ++x) {
                    const int row = b.size.y - 1 - y;
                    if (small.normal.at(x, row, 3) < 0.5F) continue;
                    ++seen;
                    const ivec2 p(x, y);
                    dvec3 n;
                    switch (method) {
                    case NormalsBy::tap3: n = methods.normal3Tap(lens, p); break;
                    case NormalsBy::tap4: n = methods.normal4Tap(lens, p); break;
                    case NormalsBy::tap5: n = methods.normal5Tap(lens, p); break;
                    case NormalsBy::tap9: n = methods.normal9Tap(lens, p); break;
                    case NormalsBy::tap9Plus: n = methods.normal9TapPlus(lens, p); break;
                    case NormalsBy::parabola: n = methods.normalCurved(lens, p); break;
                    default: n = methods.normalVoted(lens, p); break;
                    }
                    off += glm::distance(n, at(small.normal, x, row)) > 0.01;
                }
            EXPECT_GT(seen, 1500);
            // If both sides of an axis are equally good, rounding decides.
            EXPECT_LE(off, seen / 100) << static_cast<int>(method);
        }
}

TEST_F(PixelPictures, NineTapAndNinePlusAreTheSameToTheBit)
{
    for (const PixelProjection projection : {PixelProjection::orthographic, PixelProjection::perspective}) {
        SmallShot shot;
        shot.values.set(table().projection, projection);
        shot.values.set(table().method, NormalsBy::tap9);
        const Small nine = shot.take();
        shot.values.set(table().method, NormalsBy::tap9Plus);
        EXPECT_EQ(nine.normal.pixels, shot.take().normal.pixels);
        shot.values.set(table().method, NormalsBy::tap3);
        EXPECT_NE(nine.normal.pixels, shot.take().normal.pixels);
    }
}

TEST_F(PixelPictures, EitherWayRoundIsTheSamePicture)
{
    for (const DepthBits bits : {DepthBits::unorm24, DepthBits::unorm16}) {
        SmallShot shot;
        shot.values.set(table().projection, PixelProjection::perspective);
        shot.values.set(table().method, NormalsBy::tap9);
        shot.values.set(table().depthBits, bits);
        const Small reversed = shot.take();
        shot.values.set(table().depthOrder, DepthOrder::standard);
        const Small standard = shot.take();
        int differ = 0;
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                EXPECT_EQ(reversed.normal.at(x, y, 3), standard.normal.at(x, y, 3));
                differ += glm::distance(at(reversed.normal, x, y), at(standard.normal, x, y)) > 0.02;
            }
        // One and five texels of 8160 differ, because rounding decides between two equally good sides.
        EXPECT_LE(differ, shot.size.x * shot.size.y / 1000);
    }
}

TEST_F(PixelPictures, EveryNormalIsOfUnitLengthAtAnySize)
{
    for (const ivec2 size : {ivec2(1, 1), ivec2(2, 1), ivec2(7, 3), ivec2(61, 37)})
        for (const NormalsBy method :
             {NormalsBy::tap3, NormalsBy::tap4, NormalsBy::tap5, NormalsBy::tap9, NormalsBy::vote}) {
            SmallShot shot;
            shot.size = size;
            shot.values.set(table().method, method);
            shot.values.set(table().smoothing, 2);
            const Small small = shot.take();
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) EXPECT_NEAR(glm::length(at(small.normal, x, y)), 1, 2e-3);
        }
}

TEST_F(PixelPictures, AnySizeHasAPictureInEveryDither)
{
    for (const ivec2 size : {ivec2(1, 1), ivec2(1, 7), ivec2(13, 1), ivec2(61, 37)})
        for (const Dither dither : {Dither::none, Dither::ordered, Dither::blueNoise, Dither::errorDiffusion}) {
            SmallShot shot;
            shot.size = size;
            shot.values.set(table().palette, PaletteName::oneBit);
            shot.values.set(table().dither, dither);
            const Small small = shot.take();
            ASSERT_EQ(ivec2(small.shown.width, small.shown.height), size);
            const auto colors = shippedPalette(PaletteName::oneBit);
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    EXPECT_TRUE(std::any_of(
                        colors.begin(), colors.end(),
                        [&](const Rgb8& c) { return render::srgb8FromLinear(small.shown.at(x, y, 0)) == c.r; }))
                        << size.x << ' ' << size.y << ' ' << static_cast<int>(dither);
        }
}

TEST_F(PixelPictures, NormalsOfNoLengthInAModelAreDrawnAsUnitNormals)
{
    SmallShot shot;
    auto bare = std::make_shared<render::Mesh>(*shot.parts.front().mesh);
    for (render::Vertex& vertex : bare->vertices) vertex.normal = {};
    shot.parts = {{bare, glm::dmat4(1), 0}};
    for (const NormalsBy method : {NormalsBy::trueNormals, NormalsBy::parabola}) {
        shot.values.set(table().method, method);
        const Small small = shot.take();
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                EXPECT_NEAR(glm::length(at(small.normal, x, y)), 1, 2e-3);
                EXPECT_TRUE(std::isfinite(small.lit.at(x, y, 0)));
            }
    }
}

// The palette is applied to the exact color. The picture before it has 16-bit floats, whose rounding moves at most one
// color in 400 to another cell of the table.
TEST_F(PixelPictures, ThePaletteIsTheNearestToThePictureBeforeIt)
{
    SmallShot shot;
    shot.size = {240, 135};
    shot.values.set(table().palette, PaletteName::isle);
    const Small small = shot.take();
    int differ = 0;
    for (int y = 0; y < shot.size.y; ++y)
        for (int x = 0; x < shot.size.x; ++x) {
            const auto cell = [&](int k) {
                const double c = render::srgbFromLinear(small.lit.at(x, y, k));
                return std::clamp(static_cast<int>(std::floor(c * 31 + 0.5)), 0, 31);
            };
            const auto index =
                shot.palette.nearest->bytes[static_cast<std::size_t>((cell(2) * 32 + cell(1)) * 32 + cell(0))];
            const float* wanted = shot.palette.linear->floats.data() + std::size_t{index} * 4;
            differ += glm::distance(at(small.shown, x, y), dvec3(wanted[0], wanted[1], wanted[2])) > 2e-3;
        }
    EXPECT_LE(differ, 240 * 135 / 400);
}

TEST_F(PixelPictures, AVoteMendsDrawnBarsOfOneToThreeTexels)
{
    for (const PixelProjection projection : {PixelProjection::orthographic, PixelProjection::perspective}) {
        SmallShot shot;
        shot.size = {240, 135};
        shot.parts = barParts();
        shot.values.set(table().projection, projection);
        const auto error = [&](NormalsBy method) {
            shot.values.set(table().method, method);
            const Small small = shot.take();
            double sum = 0;
            for (int y = 0; y < shot.size.y; ++y)
                for (int x = 0; x < shot.size.x; ++x)
                    if (small.normal.at(x, y, 3) >= 0.5F)
                        sum +=
                            std::acos(std::clamp(glm::dot(at(small.normal, x, y), at(small.truth, x, y)), -1.0, 1.0));
            return sum;
        };
        EXPECT_LT(error(NormalsBy::vote), error(NormalsBy::tap9)) << static_cast<int>(projection);
    }
}

TEST_F(PixelPictures, TheDividerDividesToTheTexel)
{
    SmallShot shot;
    shot.values.set(table().view, PixelView::normals);
    shot.values.set(table().method, NormalsBy::trueNormals);
    const Small left = shot.take();
    shot.values.set(table().method, NormalsBy::tap3);
    shot.values.set(table().view, PixelView::depth);
    const Small right = shot.take();
    shot.values.set(table().view, PixelView::normals);
    shot.values.set(table().method, NormalsBy::trueNormals);
    shot.values.set(table().rightView, PixelView::depth);
    shot.values.set(table().rightMethod, NormalsBy::tap3);
    shot.values.set(table().split, true);
    for (const double divider : {0.0, 0.25, 0.5, 1.0}) {
        shot.values.set(table().divider, divider);
        const Small both = shot.take();
        const int column = static_cast<int>(std::floor(divider * shot.size.x + 0.5));
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x)
                EXPECT_EQ(at(both.lit, x, y), at(x < column ? left.lit : right.lit, x, y)) << x << ' ' << y;
    }
}

TEST_F(PixelPictures, SmoothingBringsFacetsNearerToTheDrawnNormals)
{
    SmallShot shot;
    shot.size = {240, 135};
    shot.parts = {{isleParts(0.5)[1].mesh, glm::dmat4(1), 0}};
    shot.values.set(table().tall, 2.0);
    const auto error = [&](int smoothing) {
        shot.values.set(table().smoothing, smoothing);
        const Small small = shot.take();
        double sum = 0, count = 0;
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                if (small.normal.at(x, y, 3) < 0.5F) continue;
                sum += std::acos(std::clamp(glm::dot(at(small.normal, x, y), at(small.truth, x, y)), -1.0, 1.0));
                ++count;
            }
        return sum / count;
    };
    EXPECT_LT(error(3), 0.8 * error(0));
}

TEST_F(PixelPictures, ASlowPanMovesThePictureByWholeTexelsOnly)
{
    SmallShot shot;
    shot.parts = barParts();
    shot.values.set(table().method, NormalsBy::trueNormals);
    const double texel = shot.values[table().tall] / 135;  // Positions snap to the texel size of the table.
    shot.size = {240, 135};
    const Image start = shot.take().lit;
    for (int step = 1; step <= 20; ++step) {
        shot.values.set(table().panX, 0.1 * step * texel);
        const Image now = shot.take().lit;
        const int moved = static_cast<int>(std::floor(0.1 * step + 0.5));
        int differ = 0;
        for (int y = 2; y < 133; ++y)
            for (int x = 4; x < 234; ++x)
                differ += glm::distance(at(now, x, y), at(start, x + moved, y)) > (moved == 0 ? 0 : 0.01);
        // Edges of shadows, and bars that end in the middle of a texel, depend on rounding.
        EXPECT_LE(differ, moved == 0 ? 0 : 60) << step;
    }
    shot.values.set(table().snap, false);
    shot.values.set(table().panX, 0.4 * texel);
    int crawling = 0;
    const Image now = shot.take().lit;
    for (int y = 2; y < 133; ++y)
        for (int x = 4; x < 234; ++x) crawling += at(now, x, y) != at(start, x, y);
    EXPECT_GT(crawling, 500);
}

/// Number of texels, of 29,606, that change when the camera moves by whole texels.
struct Panned {
    int normals = 0;  ///< By more than a degree.
    int lit = 0;      ///< By more than a hundredth.
};

Panned pannedBy(int texels, SmallShot shot)
{
    shot.size = {240, 135};  // Positions snap to the texel size of the table.
    shot.values.set(table().panX, 0.0);
    const Small start = shot.take();
    shot.values.set(table().panX, texels * shot.values[table().tall] / 135);
    const Small now = shot.take();
    Panned changed;
    for (int y = 2; y < 133; ++y)
        for (int x = 4; x < 230; ++x) {
            changed.normals += glm::distance(at(now.normal, x, y), at(start.normal, x + texels, y)) > 0.0175;
            changed.lit += glm::distance(at(now.lit, x, y), at(start.lit, x + texels, y)) > 0.01;
        }
    return changed;
}

// Depths from the rasterizer differ by rounding. The methods ignore differences of this size, and no tone begins at the
// slope of walls. Otherwise 29 to 85 normals of the bars would change, and 57 to 200 texels of either scene.
TEST_F(LongPixelPictures, NormalsFromDepthStayWhenTheCameraMovesByWholeTexels)
{
    for (const NormalsBy method : {NormalsBy::trueNormals, NormalsBy::tap9Plus, NormalsBy::parabola, NormalsBy::vote})
        for (const bool bars : {false, true})
            for (const int texels : {1, 2, 3, 5}) {
                SmallShot shot;
                if (bars) shot.parts = barParts();
                shot.values.set(table().method, method);
                const Panned changed = pannedBy(texels, shot);
                EXPECT_EQ(changed.normals, 0) << static_cast<int>(method) << ' ' << bars << ' ' << texels;
                // The rest are shadows and tones that end in the middle of a texel.
                EXPECT_LE(changed.lit, 30) << static_cast<int>(method) << ' ' << bars << ' ' << texels;
            }
}

std::tuple<int, int, int> codes(const Image& image, int x, int y)
{
    return {render::srgb8FromLinear(image.at(x, y, 0)), render::srgb8FromLinear(image.at(x, y, 1)),
            render::srgb8FromLinear(image.at(x, y, 2))};
}

TEST_F(PixelPictures, ThePictureHasColorsOfThePaletteOnly)
{
    for (const PaletteName name : {PaletteName::isle, PaletteName::gameBoy, PaletteName::c64, PaletteName::nes})
        for (const Dither dither : {Dither::none, Dither::ordered, Dither::blueNoise, Dither::errorDiffusion}) {
            SmallShot shot;
            shot.values.set(table().palette, name);
            shot.values.set(table().dither, dither);
            const Small small = shot.take();
            std::set<std::tuple<int, int, int>> palette, used;
            for (const Rgb8& c : shippedPalette(name)) palette.insert({c.r, c.g, c.b});
            for (int y = 0; y < shot.size.y; ++y)
                for (int x = 0; x < shot.size.x; ++x) used.insert(codes(small.shown, x, y));
            EXPECT_GE(used.size(), 3U) << static_cast<int>(name) << ' ' << static_cast<int>(dither);
            for (const auto& c : used)
                EXPECT_TRUE(palette.contains(c)) << static_cast<int>(name) << ' ' << static_cast<int>(dither);
        }
}

TEST_F(PixelPictures, DitheringKeepsTheMean)
{
    SmallShot shot;
    shot.size = {256, 300};
    shot.parts.clear();
    shot.values.set(table().palette, PaletteName::oneBit);
    shot.values.set(table().ditherStrength, 1.0);
    shot.values.set(table().horizon, ColorValue{dvec3(0.05)});
    shot.values.set(table().zenith, ColorValue{dvec3(0.9)});
    const auto means = [&](Dither dither) {
        shot.values.set(table().dither, dither);
        const Small small = shot.take();
        glm::dvec2 sum(0);
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) sum += glm::dvec2(small.lit.at(x, y, 0), small.shown.at(x, y, 0));
        return sum / (1.0 * shot.size.x * shot.size.y);
    };
    for (const Dither dither : {Dither::ordered, Dither::blueNoise, Dither::errorDiffusion}) {
        const glm::dvec2 mean = means(dither);
        EXPECT_NEAR(mean.x, mean.y, 0.01) << static_cast<int>(dither);
    }
    const glm::dvec2 none = means(Dither::none);
    EXPECT_GT(std::abs(none.x - none.y), 0.01);
}

TEST_F(PixelPictures, AnOutlineIsOneTexelWideOnTheNearSide)
{
    for (const PixelProjection projection : {PixelProjection::orthographic, PixelProjection::perspective}) {
        SmallShot shot;
        shot.size = {240, 135};
        shot.parts = {testParts(0.5)[2]};
        shot.values.set(table().view, PixelView::edges);
        shot.values.set(table().projection, projection);
        shot.values.set(table().method, NormalsBy::trueNormals);
        const Small small = shot.take();
        const auto seen = [&](int x, int y) { return small.truth.at(x, y, 3) > 0; };
        int lines = 0;
        for (int y = 1; y < 134; ++y)
            for (int x = 1; x < 239; ++x) {
                const bool border =
                    seen(x, y) && (!seen(x - 1, y) || !seen(x + 1, y) || !seen(x, y - 1) || !seen(x, y + 1));
                const bool line = small.lit.at(x, y, 0) > 0.5F;
                EXPECT_EQ(line, border) << x << ' ' << y;
                lines += line;
            }
        EXPECT_GT(lines, 20);
    }
}

TEST_F(PixelPictures, StrengthsOfLinesAct)
{
    SmallShot shot;
    const Image start = shot.take().lit;
    shot.values.set(table().outlineStrength, 0.0);
    const Image without = shot.take().lit;
    EXPECT_NE(start.pixels, without.pixels);
    shot.values.set(table().highlightStrength, 0.0);
    EXPECT_NE(without.pixels, shot.take().lit.pixels);
}

TEST_F(PixelPictures, TheTestSceneMovesAndComesBackAfterItsRound)
{
    const auto first = testParts(0), middle = testParts(1.3), again = testParts(worldRound);
    ASSERT_EQ(first.size(), 4U);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_NE(first[i].worldFromModel, middle[i].worldFromModel);
        for (int c = 0; c < 4; ++c)
            EXPECT_LT(glm::distance(first[i].worldFromModel[c], again[i].worldFromModel[c]), 1e-9);
    }
}

}  // namespace
}  // namespace vitrine::pixel_art
