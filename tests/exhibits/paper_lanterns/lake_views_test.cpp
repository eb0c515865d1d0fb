// Pictures of the lake that show the reference's errors on request only.

#include "tests/exhibits/paper_lanterns/lake_shot.h"
#include "tests/support/plan_steps.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <string>

namespace vitrine::paper_lanterns {
namespace {

using namespace test;
using glm::dvec2;
using glm::dvec3;

class LakeViews : public GlTest {};

const PaperLanternsTable& row()
{
    return lanternsTable();
}

/// Returns the mean change from a column to the next one, over all rows.
double columnStep(const Picture& p, int column)
{
    double sum = 0;
    for (int y = 0; y < p.height(); ++y) sum += std::abs(p.luminance(column + 1, y) - p.luminance(column, y));
    return sum / p.height();
}

/// Returns how much larger the change is at the center of a picture than between columns beside it.
double seamInTheMiddle(const Picture& p)
{
    const int middle = p.width() / 2 - 1;
    double beside = 0;
    for (int off = 2; off < 12; ++off) beside += (columnStep(p, middle + off) + columnStep(p, middle - off)) / 20;
    return columnStep(p, middle) / beside;
}

TEST_F(LakeViews, SeamOfThePaperIsNotSeenAtEitherParity)
{
    // The angle wraps around in the middle: between two quads of pixels in one picture, within a quad in the other.
    for (const int width : {64, 66}) {
        LakeShot shot;
        const auto l = shot.inTheDark().withOneLantern();
        shot.set(row().bounces, 0).set(row().fibers, 1.0);
        shot.request.frame.raster.size = {width, 64};
        shot.from(l.place + dvec3(-3, 1, 0), l.place + dvec3(0, 1, 0), 0.24);
        const Picture ours = shot.take();
        EXPECT_GT(ours.luminance(width / 2, 32), 0.02);
        EXPECT_LT(seamInTheMiddle(ours), 1.8) << width;
        shot.set(row().look, LakeLook::reference);
        EXPECT_GT(seamInTheMiddle(shot.take()), 3) << width;
    }
}

TEST_F(LakeViews, APanoramaHasNoSeamAtEitherParity)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "sky.hdr";
    // Bright behind, where the panorama wraps around; dark elsewhere.
    writePanorama(file, [](const dvec3& d) { return dvec3(d.z > 0.8 ? 1 : 0.125); });
    for (const int width : {64, 66}) {
        LakeShot shot;
        shot.inTheDark().set(row().panorama, file.string()).set(row().crowding, 0.0);
        shot.request.frame.raster.size = {width, 32};
        shot.request.frame.camera = {{0, 0, 0}, {0, 0.5, 1}, 0.1};
        const auto dark = [&](const Picture& p) {
            double least = 1e9, even = 0;
            for (int x = 0; x < width; ++x) {
                double sum = 0;
                for (int y = 0; y < p.height(); ++y) sum += p.luminance(x, y) / p.height();
                least = std::min(least, sum);
                even += sum / width;
            }
            return 1 - least / even;
        };
        EXPECT_LT(dark(shot.take()), 0.02) << width;
        shot.set(row().look, LakeLook::reference);
        EXPECT_GT(dark(shot.take()), 0.1) << width;
    }
}

TEST_F(LakeViews, HeightsAreThoseOfTheWaterTimesTheExaggeration)
{
    LakeShot shot;
    constexpr double exaggeration = 3;
    shot.set(row().show, LakeShow::heights).set(row().crowding, 0.0).set(row().exaggeration, exaggeration);
    shot.from({0, 20, -10}, {0, 0, -10.001}, 0.5);
    const Picture p = shot.take();
    glsl::Lake lake = lakeAtFloat64(shot.values(), 0);
    const glm::dmat4 lakeFromExhibit = lakePortal(row(), shot.values()).workFromExhibit;
    const dvec3 eye(lakeFromExhibit * glm::dvec4(p.view.eye, 1));
    // Mean difference between the color and the height times `factor`.
    const auto difference = [&](double factor) {
        double sum = 0;
        p.each([&](int x, int y) {
            const dvec2 ndc(2 * (x + 0.5) / p.width() - 1, 1 - 2 * (y + 0.5) / p.height());
            const dvec3 d = glm::dmat3(lakeFromExhibit) * p.view.direction(ndc);
            const double t = lake.waterDistance(eye, glm::normalize(d), 0, 1000, 1e-5, 0.5, 256);
            const dvec3 at = eye + glm::normalize(d) * t;
            const double share = 0.5 + 0.5 * glm::clamp(lake.lakeAt({at.x, at.z}).height * factor / 0.2075, -1.0, 1.0);
            const double ratio = p.color(x, y).x / p.color(x, y).z;
            const double shown = (0.3 * ratio - 0.02) / (0.88 - 0.05 * ratio);
            sum += std::abs(shown - share) / (p.width() * p.height());
        });
        return sum;
    };
    EXPECT_LT(difference(exaggeration), 0.01);
    EXPECT_GT(difference(1), 0.05);
    // The reference's surface is at -1 minus the sum of its waves.
    EXPECT_GT(difference(-exaggeration), 0.2);
}

TEST_F(LakeViews, OfALanternsInsideAreWhole)
{
    for (const LakeLook look : {LakeLook::physical, LakeLook::reference}) {
        LakeShot shot;
        shot.set(row().look, look).set(row().waveHeight, 0.0);
        const auto l = shot.withOneLantern();
        const dvec3 eye = l.place + dvec3(0.05, 0.9, 0.02);
        const double scale = shot.values()[row().scale];
        // The wall from inside: lit everywhere, at its distance, and not clipped.
        const Picture wall = shot.from(eye, eye + dvec3(1, 0, 0), 0.9).take();
        EXPECT_EQ(notFinite(wall.image, 4), "");
        int dark = 0;
        wall.each([&](int x, int y) { dark += !(wall.luminance(x, y) > 0.1 * wall.mean()) || !wall.hit(x, y); });
        EXPECT_LT(dark, look == LakeLook::physical ? 1 : 60);  // Its frame gets no light from between wall and post.
        EXPECT_NEAR(wall.depth(48, 30), 0.67 / scale, 0.01);
        // Down at the base, and up through the opening at the sky.
        const Picture down = shot.from(eye, eye + dvec3(0, -1, 0.001), 0.5).take();
        EXPECT_EQ(notFinite(down.image, 4), "");
        EXPECT_NEAR(down.depth(48, 30), 0.86 / scale, 0.01);
        const Picture up = shot.from(eye, eye + dvec3(0, 1, 0.001), 1.6).take();
        EXPECT_EQ(notFinite(up.image, 4), "");
        EXPECT_GT(up.depth(48, 30), 1e6);
        EXPECT_LT(up.depth(2, 30), 1);
        // Control: the same view without a lantern around it.
        shot.set(row().crowding, 0.0);
        EXPECT_FALSE(shot.from(eye, eye + dvec3(1, 0, 0), 0.9).take().depth(48, 30) < 1);
    }
}

TEST_F(LakeViews, OfTheDeepHaveNoHorizon)
{
    // Under water, across the horizontal: no mist, and no lights of distant lanterns.
    LakeShot shot;
    shot.from({0, -1.2, -3}, {0, -1.2, -13}, 0.9);
    // Minimum and maximum of some rows.
    const auto range = [&](const Picture& p) {
        dvec2 found(1e9, 0);
        for (int y = 26; y < 34; ++y)
            for (int x = 0; x < p.width(); ++x)
                found = {std::min(found.x, p.luminance(x, y)), std::max(found.y, p.luminance(x, y))};
        return found;
    };
    const dvec2 deep = range(shot.take());
    EXPECT_GT(deep.x, 0);
    EXPECT_LT(deep.y, 2 * deep.x);
    // Control: above the water, the same rows show the lights at the horizon.
    shot.from({0, 1.2, -3}, {0, 1.2, -13}, 0.9);
    const dvec2 over = range(shot.take());
    EXPECT_GT(over.y, 10 * over.x);
}

TEST_F(LakeViews, ShowWaterDownToTheFrameFromTheLowestEye)
{
    LakeShot shot;
    shot.request.frame.alone = std::nullopt;
    shot.request.frame.camera = gallery().museum.bestView(shot.exhibit, shot.values());
    shot.set(row().eyeHeight, 1.0);
    const Picture p = shot.take();
    // Waves and reflections: in each row above the frame's lower edge, pixels differ.
    for (int y = 40; y < 52; ++y) {
        double sum = 0, squares = 0;
        constexpr int left = 24, right = 72;
        for (int x = left; x < right; ++x) {
            sum += p.luminance(x, y) / (right - left);
            squares += p.luminance(x, y) * p.luminance(x, y) / (right - left);
        }
        EXPECT_GT(std::sqrt(std::max(squares - sum * sum, 0.0)), 0.1 * sum) << y;
    }
}

/// Returns the luminance around a place of the lake.
double luminanceAt(LakeShot& shot, const Picture& p, const dvec3& place)
{
    const dvec2 pixel = shot.pixelOf(p, place);
    EXPECT_TRUE(pixel.x >= 1 && pixel.y >= 1 && pixel.x < p.width() - 1 && pixel.y < p.height() - 1)
        << "a place outside of the picture: " << pixel.x << ' ' << pixel.y;
    double sum = 0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += p.luminance(static_cast<int>(pixel.x) + x, static_cast<int>(pixel.y) + y);
    return sum / 9;
}

TEST_F(LakeViews, TheMistIsLitFinitelyAroundAnEyeInAFlame)
{
    LakeShot shot;
    shot.inTheDark().set(row().fog, 0.05).set(row().flicker, 0.0);
    const auto l = shot.withOneLantern();
    const double half = lakeBlock(row(), shot.values(), 0).paperHeight / 2;
    const auto middle = [&](const dvec3& off) {
        const dvec3 eye = l.place + dvec3(0, half, 0) + off;
        const Picture p = shot.from(eye, eye + dvec3(1, 0.02, 0.01), 0.4).take();
        EXPECT_EQ(notFinite(p.image, 4), "");
        return p.mean();
    };
    const double here = middle({0, 0, 0});
    // The inverse square of the distance would grow by 10^4 from each of these places to the next one.
    for (const double off : {1e-6, 1e-4, 1e-2}) EXPECT_NEAR(middle({0, 0, off}) / here, 1, 0.05) << off;
    shot.set(row().fog, 0.0);
    EXPECT_NE(middle({0, 0, 0}), here) << "the mist was not lit";
}

TEST_F(LakeViews, ALanternShadesItsBaseFromTheMoonWhereATracedRayIsBlocked)
{
    LakeShot shot;
    shot.inTheDark().set(row().candles, false).set(row().bounces, 0).set(row().moon, 10.0).set(row().moonSize, 0.01);
    shot.set(row().moonElevation, 0.6).set(row().moonAzimuth, 1.5);
    const auto l = shot.withOneLantern();
    glsl::Lake lake = lakeAtFloat64(shot.values(), lakeTime(row(), shot.values(), 0));
    const std::vector<glsl::Lake::Lantern> only{l};
    const dvec3 moon(lake.lake.towardsMoon);
    // From the side, where parts in moonlight and in shade are visible.
    const dvec3 eye = l.place + 3.0 * glm::normalize(dvec3(moon.z, 0, -moon.x)) + dvec3(0, 5, 0);
    shot.request.frame.raster.size = {192, 192};
    const Picture p = shot.from(eye, l.place, 0.6).take();
    const auto met = [&](const dvec3& from, const dvec3& direction, double to) {
        glsl::Lake::LanternRay ray{};
        ray.origin = from;
        ray.direction = direction;
        ray.to = to;
        return nearestOfAll(lake, only, ray);
    };
    double lit = 0, shaded = 0;
    int litPlaces = 0, shadedPlaces = 0;
    const double top = lake.lake.baseHalfHeight, inner = lake.lake.baseHalfWidth - 0.06;
    const glm::dmat3 axes = lake.lakeFromLantern(l);
    for (double u = -inner; u <= inner; u += 0.03)
        for (double v = -inner; v <= inner; v += 0.03) {
            const dvec3 place = l.place + axes * dvec3(u, top + 1e-3, v);
            const dvec3 away = eye - place;
            if (met(place, glm::normalize(away), glm::length(away)) < glm::length(away)) continue;
            // Edges of the shadow are left out: nearby places must agree.
            int blocked = 0;
            for (const dvec2 off : {dvec2(0), dvec2(0.05, 0), dvec2(-0.05, 0), dvec2(0, 0.05), dvec2(0, -0.05)})
                blocked += met(place + axes * dvec3(off.x, 0, off.y), moon, 20) < 20;
            if (blocked != 0 && blocked != 5) continue;
            (blocked ? shaded : lit) += luminanceAt(shot, p, place);
            ++(blocked ? shadedPlaces : litPlaces);
        }
    ASSERT_GT(litPlaces, 20);
    ASSERT_GT(shadedPlaces, 20);
    // Material and normal are equal: without the shadow both are equally bright.
    EXPECT_LT(shaded / shadedPlaces, 0.3 * lit / litPlaces);
}

TEST_F(LakeViews, ALanternsMoonShadowFallsOnTheWaterWhereItShows)
{
    LakeShot shot;
    shot.inTheDark().set(row().candles, false).set(row().bounces, 0).set(row().moon, 10.0).set(row().moonSize, 0.01);
    shot.set(row().waterColor, ColorValue{{0.4, 0.4, 0.4}}).set(row().moonElevation, 0.8).set(row().moonAzimuth, 0.4);
    const auto l = shot.withOneLantern();
    const dvec3 moon(lakeBlock(row(), shot.values(), 0).towardsMoon);
    const dvec3 aside = glm::normalize(dvec3(moon.x, 0, moon.z));
    // Shadow of the tube's center: its distance from the foot follows from the moon's height.
    const dvec3 shaded = l.place - 1.9 * aside, lit = l.place + 1.9 * aside;
    shot.from(l.place + dvec3(1.0, 12, 1.0), l.place, 0.6);
    const Picture p = shot.take();
    EXPECT_LT(luminanceAt(shot, p, shaded), 0.5 * luminanceAt(shot, p, lit));
    const auto reason = [&] {
        return reasonFor(planned(gallery().museum, shot.sceneState, shot.request.frame), "paper_lanterns/moon_shadow");
    };
    EXPECT_EQ(reason(), "not in the plan");
    shot.set(row().crowding, 0.0);
    const Picture open = shot.take();
    EXPECT_NEAR(luminanceAt(shot, open, shaded) / luminanceAt(shot, open, lit), 1, 0.1);
    EXPECT_NE(reason(), "not in the plan");
    shot.set(row().crowding, 1.0).set(row().waterColor, ColorValue{{0.001, 0.001, 0.001}});
    EXPECT_NE(reason(), "not in the plan");
}

/// Returns a shot of the lake's frame in the hall at night, with this glow.
LakeShot frameInTheHall(double glow)
{
    LakeShot shot;
    shot.request.frame.alone = std::nullopt;
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().skyStrength, 0.0);
    shot.set(row().hallGlow, glow);
    for (const char* exhibit : {"fur", "lenticular"}) {
        ParameterValues& values = shot.sceneState.values[gallery().museum.find(exhibit).value()];
        values.setParameter(values.table().find("lamp").value(), 0.0);
    }
    const glm::dmat4 world = gallery().museum.worldFromExhibit(shot.exhibit);
    shot.request.frame.camera = {dvec3(world * glm::dvec4(0.5, 0, 4, 1)), dvec3(world * glm::dvec4(0.5, -0.4, 0, 1)),
                                 1.1};
    return shot;
}

TEST_F(LakeViews, GlowFallsOnWallAndFloorBesideTheFrameInTheHall)
{
    LakeShot parts = frameInTheHall(3);
    parts.set(row().show, LakeShow::parts);
    const Picture with = frameInTheHall(3).take(), without = frameInTheHall(0).take(), unlit = parts.take();
    const glm::dmat4 world = gallery().museum.worldFromExhibit(parts.exhibit);
    const auto at = [&](const Picture& p, dvec3 place, bool onFloor) {
        place = dvec3(world * glm::dvec4(place, 1));
        if (onFloor) place.y = 0;
        const glm::dvec4 clip = p.view.clipFromWorld * glm::dvec4(place, 1);
        return p.luminance(static_cast<int>((0.5 + 0.5 * clip.x / clip.w) * p.width()),
                           static_cast<int>((0.5 - 0.5 * clip.y / clip.w) * p.height()));
    };
    const dvec3 beside(1.6, 0, 0), before(0.2, 0, 0.9), farAside(2.9, 0, 0);
    const double wall = at(with, beside, false) - at(without, beside, false);
    EXPECT_GT(wall, 1e-3);
    EXPECT_GT(at(with, before, true) - at(without, before, true), 1e-3);
    EXPECT_LT(at(with, farAside, false) - at(without, farAside, false), 0.2 * wall);
    // Control: a view of parts does not glow.
    EXPECT_EQ(at(unlit, beside, false), at(without, beside, false));
    EXPECT_EQ(at(unlit, before, true), at(without, before, true));
}

TEST_F(LakeViews, LanternsOutshineTheirFrame)
{
    LakeShot shot;
    shot.request.frame.alone = std::nullopt;
    shot.request.frame.averageIn = AverageIn::display;
    shot.request.frame.camera = gallery().museum.bestView(shot.exhibit, shot.values());
    shot.size(320, 180);
    const Picture p = shot.take();
    const auto code = [](double linear) {
        return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
    };
    // The opening is in the middle; the frame's left side is beside it.
    std::vector<double> codes;
    std::vector<double> bright;
    double frame = 0;
    p.each([&](int x, int y) {
        if (x >= 50 && x < 270 && y >= 20 && y < 160) {
            const dvec3 c = p.color(x, y);
            codes.push_back((code(c.r) + code(c.g) + code(c.b)) / 3);
            bright.push_back(p.luminance(x, y));
        }
        if (x >= 15 && x < 40 && y >= 60 && y < 120) frame += p.luminance(x, y) / (25 * 60);
    });
    std::sort(codes.begin(), codes.end());
    std::sort(bright.begin(), bright.end());
    EXPECT_GE(codes[codes.size() * 99 / 100], 192);
    // Lanterns cover more than a twentieth of the opening.
    EXPECT_GT(bright[bright.size() * 95 / 100], 4 * frame);
}

TEST_F(LakeViews, TheProbeSeesTheGlow)
{
    // Mean red light, which comes from the glow only.
    const auto seen = [&](double glow) {
        LakeShot shot = frameInTheHall(glow);
        const auto renderer = gallery().renderer.sibling();
        (void)renderer->draw(planned(gallery().museum, shot.sceneState, shot.request.frame));
        const render::Image sums = renderer->read("probe.irradiance");
        return sums.at(0, 0, 0);
    };
    const float low = seen(1), middle = seen(3), high = seen(5);
    EXPECT_GT(middle, 1.01F * low);
    EXPECT_NEAR((high - middle) / (middle - low), 1, 0.05);
}

}  // namespace
}  // namespace vitrine::paper_lanterns
