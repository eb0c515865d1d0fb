// Light levels in the hall: bounced light, the film curve, and unlit parts.
#include "exhibits/hall/hall.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/noise/noise_table.h"
#include "tests/exhibits/hall/bounced_light.h"
#include "tests/support/degree.h"
#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::hall {
namespace {

using namespace test;

class LightLevels : public test::GlTest {};

const Hall& hall()
{
    static const Hall built(std::make_shared<const HallModel>(), {});
    return built;
}

using LongLightLevels = LightLevels;

TEST_F(LightLevels, TheMapOfBouncedLightIsThatOfFloat64)
{
    Shot shot;
    const HallScene scene = hall().scene(shot.hall(), false, nullptr);
    render::FramePlan plan;
    planBouncedLight(scene, sceneLighting(scene), plan);
    plan.prune({"light.bounced"});
    render::gl::Renderer renderer;
    (void)renderer.draw(plan);
    const render::Image map = renderer.read("light.bounced");
    const SunTransfer& transfer = scene.model.surfaces().lightmaps().sun;
    ASSERT_EQ(map.width, transfer.surfaces()->width);
    const test::Air air =
        test::airOf(transfer, transfer.at(shot.hall()[hallTable().sunAzimuth], shot.hall()[hallTable().sunElevation]));
    // Centers of large triangles, which lie on the map as the mesh says.
    int checked = 0;
    for (const render::MeshInstance& part : scene.model.walls())
        for (std::size_t i = 0; i + 2 < part.mesh->indices.size(); i += 3) {
            const render::Vertex* corner[3];
            for (std::size_t k = 0; k < 3; ++k) corner[k] = &part.mesh->vertices[part.mesh->indices[i + k]];
            const glm::dvec2 a(corner[0]->extra), b(corner[1]->extra), c(corner[2]->extra);
            const glm::dvec2 size(map.width, map.height);
            if (std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) * size.x * size.y < 600) continue;
            // Center of the texel, and its position on the triangle.
            const glm::ivec2 texel((a + b + c) / 3.0 * size);
            const glm::dvec2 at = (glm::dvec2(texel) + 0.5) / size;
            const glm::dvec2 st = glm::inverse(glm::dmat2(b - a, c - a)) * (at - a);
            const auto blend = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
                return p + st.x * (q - p) + st.y * (r - p);
            };
            const glm::dvec3 place = blend(corner[0]->position, corner[1]->position, corner[2]->position);
            const glm::dvec3 n = glm::normalize(blend(corner[0]->normal, corner[1]->normal, corner[2]->normal));
            const glm::dvec3 right = test::surfaceShare(transfer, at) * test::airOn(transfer, air, place, n);
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(map.at(texel.x, map.height - 1 - texel.y, k), right[k], 5e-3 * right[k] + 1e-6);
            ++checked;
        }
    EXPECT_GT(checked, 20);
}

/// Returns the walls alone, scene-linear, under a sky that does not depend on the sun. `change` may change the block of
/// their light.
render::Image wallsWith(const ParameterValues& values, const std::function<void(LightBlock&)>& change = {},
                        const std::optional<render::Camera>& camera = {})
{
    const HallScene scene = hall().scene(values, false, nullptr);
    SceneLighting light = sceneLighting(scene);
    if (change) change(light.light);
    light.light.skyZenith = {1.2F, 1.5F, 2};
    light.light.skyHorizon = {1.9F, 2, 2.1F};
    light.light.skySunward = {0, 0, 0};
    render::FramePlan plan;
    render::Raster raster;
    raster.size = {96, 54};
    plan.view = render::makeView(camera.value_or(hall().bestView(values)), raster);
    plan.image({.name = radianceImage, .format = render::Format::rgba32f});
    plan.image({.name = depthImage, .format = render::Format::depth32f, .nearest = true});
    planHallShadow(scene, light, plan);
    planBouncedLight(scene, light, plan);
    planAirLight(scene, light, plan);
    planContactShadows(scene, plan);
    planProbe(scene, light, plan);
    planWalls(scene, light, {}, plan);
    plan.prune({radianceImage});
    render::gl::Renderer renderer;
    (void)renderer.draw(plan);
    return renderer.read(radianceImage);
}

// Parts of the hall that are marked as out of all sunlight are not looked up in its shadow map. No pixel may change by
// that.
TEST_F(LongLightLevels, WithTheShadowMapAskedEverywhereAreTheSame)
{
    Shot shot;
    shot.hall().set(hallTable().reflectionProbe, false);
    const auto everywhere = [](LightBlock& light) { light.roomLow = light.roomHigh = glm::vec3(0); };
    const auto nowhere = [](LightBlock& light) {
        for (glm::vec4& passage : light.sunPassages) passage = glm::vec4(0);
    };
    for (const ShadowFilter filter : {ShadowFilter::tent5, ShadowFilter::disk}) {
        shot.hall().set(hallTable().shadowFilter, filter);
        std::vector<glm::dvec2> suns{{-3, 19}, {120, 70}};
        if (filter == ShadowFilter::tent5) suns.insert(suns.end(), {{-40, 8}, {35, 25}, {10, 4}, {170, 12}});
        for (const glm::dvec2 sun : suns) {
            shot.hall().set(hallTable().sunAzimuth, sun.x * degree);
            shot.hall().set(hallTable().sunElevation, sun.y * degree);
            EXPECT_EQ(test::largestDifference(wallsWith(shot.hall()), wallsWith(shot.hall(), everywhere)), 0)
                << sun.x << ", " << sun.y;
        }
        shot.hall().set(hallTable().sunAzimuth, -3 * degree);
        shot.hall().set(hallTable().sunElevation, 19 * degree);
        EXPECT_GT(test::largestDifference(wallsWith(shot.hall()), wallsWith(shot.hall(), nowhere)), 0.1);
    }
}

// The door stands in a recess behind the room's wall, and walls lie on its boundary. They are looked up nowhere, so a
// map that answers "lit" everywhere changes nothing.
TEST_F(LightLevels, LookUpNoSunlightThatCrossesTheRoomBesideTheOpenings)
{
    Shot shot;
    shot.hall().set(hallTable().reflectionProbe, false);
    shot.hall().set(hallTable().sunAzimuth, -3 * degree);
    shot.hall().set(hallTable().sunElevation, 19 * degree);
    const auto closed = [](LightBlock& light) {
        for (glm::vec4& passage : light.sunPassages) passage = glm::vec4(0);
    };
    const auto lit = [](LightBlock& light) {
        for (int column = 0; column < 3; ++column) light.hallShadowFromWorld[column][2] = 0;
        light.hallShadowFromWorld[3][2] = 1;
    };
    const auto closedAndLit = [&](LightBlock& light) {
        closed(light);
        lit(light);
    };
    const render::Camera door{{0.5, 1.65, 9}, {0.5, 1.2, 12}, 0.959931};
    const render::Image dark = wallsWith(shot.hall(), closed, door);
    EXPECT_EQ(test::largestDifference(dark, wallsWith(shot.hall(), closedAndLit, door)), 0);
    const auto openAndLit = [&](LightBlock& light) {
        light.roomLow = light.roomHigh = glm::vec3(0);
        lit(light);
    };
    EXPECT_GT(test::largestDifference(dark, wallsWith(shot.hall(), openAndLit, door)), 0.1);
}

/// Returns irradiance over pi in the probe for both directions along x, with these shapes in the hall.
std::array<glm::dvec3, 2> probeSidesWith(const std::vector<StandingShape>& bodies)
{
    Shot shot;
    HallScene scene = hall().scene(shot.hall(), false, nullptr);
    scene.bodies = bodies;
    const SceneLighting light = sceneLighting(scene);
    render::FramePlan plan;
    planHallShadow(scene, light, plan);
    planBouncedLight(scene, light, plan);
    planAirLight(scene, light, plan);
    planProbe(scene, light, plan);
    plan.prune({"probe.irradiance"});
    render::gl::Renderer renderer;
    (void)renderer.draw(plan);
    const render::Image sums = renderer.read("probe.irradiance");
    std::array<glm::dvec3, 2> sides;
    for (int c = 0; c < 3; ++c) {
        const auto at = [&](int k) { return static_cast<double>(sums.at(k, 0, c)); };
        sides[0][c] = at(0) + at(3) - at(6) + at(8);
        sides[1][c] = at(0) - at(3) - at(6) + at(8);
    }
    return sides;
}

TEST_F(LightLevels, AreReflectedByWhatStandsAroundButNotByWhatStandsWhereTheProbeIs)
{
    Shot shot;
    const glm::dvec3 probe = probePosition(hall().scene(shot.hall(), false, nullptr));
    const glm::dvec3 red(0.8, 0.02, 0.02);
    const auto none = probeSidesWith({});
    const auto screen =
        probeSidesWith({standingBox({probe + glm::dvec3(1.5, -1.5, -3), probe + glm::dvec3(1.7, 2, 3)}, red)});
    const auto redness = [](const glm::dvec3& light) { return light.r / light.g; };
    EXPECT_GT(redness(screen[0]), 1.3 * redness(none[0]));
    EXPECT_LT(redness(screen[1]), 1.1 * redness(none[1]));
    const auto around = probeSidesWith({standingBox({probe - 0.3, probe + 0.3}, red)});
    EXPECT_EQ(around[0], none[0]);
    EXPECT_EQ(around[1], none[1]);
}

/// Returns the mug in the hall, with this roughness, while the work behind the frame of Noise has this color.
Picture mugBeside(const glm::dvec3& color, double roughness)
{
    static const noise::NoiseTable table;
    Shot shot;
    shot.inHall().size(320, 200).see({-1.1, 1.6, 1.0}, {0, 1.45, 0});
    shot.request.frame.averageIn = AverageIn::radiance;
    shot.hall().set(hallTable().probeSize, 128);
    shot.values().set(sdfTable().roughness, roughness);
    ParameterValues& noise = shot.sceneState.values[*gallery().museum.find("noise")];
    noise.set(table.work, noise::NoiseWork::field);
    noise.set(table.threshold, -0.4);
    noise.set(table.albedo, ColorValue{color});
    return shot.take();
}

TEST_F(LongLightLevels, OfWorksOnTheWallsAreInTheMirrorsOfTheHall)
{
    const glm::dvec3 red(0.9, 0.02, 0.02), green(0.02, 0.9, 0.02);
    const auto turned = [&](double roughness) {
        const Picture reds = mugBeside(red, roughness), greens = mugBeside(green, roughness);
        int pixels = 0;
        reds.each([&](int x, int y) {
            const glm::dvec3 more = reds.color(x, y) - greens.color(x, y);
            pixels += more.r > 5e-4 && more.g < -5e-4;
        });
        return pixels;
    };
    EXPECT_GT(turned(0.03), 40) << "pixels of the mug that turn from red to green with the work";
    EXPECT_EQ(turned(0.6), 0) << "control: the work itself is out of view, and chalk mirrors nothing";
}

TEST_F(LightLevels, OfASunThatShinesInNowhereAreThoseOfNoSun)
{
    Shot shot;
    shot.hall().set(hallTable().reflectionProbe, false);
    const auto under = [&](double azimuth, double elevation, double strength) {
        shot.hall().set(hallTable().sunAzimuth, azimuth * degree);
        shot.hall().set(hallTable().sunElevation, elevation * degree);
        shot.hall().set(hallTable().sunStrength, strength);
        return wallsWith(shot.hall());
    };
    const render::Image none = under(-3, 19, 0);
    EXPECT_EQ(test::largestDifference(under(170, 12, 3.6), none), 0);
    EXPECT_GT(test::largestDifference(under(-3, 19, 3.6), none), 0.1);
}

/// Region of the hall's first view, as shares of width and height from the top left.
struct Region {
    const char* name;
    double left, top, width, height;
    double darkest, brightest;  ///< Limits of the mean luminance on the display.
};
constexpr Region regions[] = {
    {"left wall", 0.094, 0.306, 0.078, 0.111, 0.16, 0.25},
    {"right wall", 0.805, 0.19, 0.070, 0.09, 0.16, 0.25},
    {"pool of a picture light", 0.805, 0.306, 0.070, 0.139, 0.27, 0.45},
    {"far left wall", 0.305, 0.36, 0.047, 0.083, 0.16, 0.25},
    {"wall of the window", 0.60, 0.36, 0.05, 0.12, 0.08, 0.16},
    {"sunlit floor", 0.325, 0.67, 0.04, 0.03, 0.48, 0.75},
};
/// From here on, an 8-bit display shows 250 or more.
constexpr double nearlyWhite = 0.951;

/// Levels of a view: the share of nearly white pixels, the codes that a display shows (mean of the three channels, 0 to
/// 255, ascending), and the regions of the hall's first view that are out of their limits.
struct Levels {
    double white = 0;
    std::vector<double> codes;
    std::vector<std::string> wrong;

    [[nodiscard]] double deviation() const
    {
        double sum = 0, squares = 0;
        for (const double code : codes) {
            sum += code;
            squares += code * code;
        }
        const auto count = static_cast<double>(codes.size());
        return std::sqrt(squares / count - sum / count * (sum / count));
    }
    /// Returns the share of the codes from 110 to 170. A picture that lies between them is pale.
    [[nodiscard]] double middle() const
    {
        const auto first = std::lower_bound(codes.begin(), codes.end(), 110);
        const auto last = std::upper_bound(codes.begin(), codes.end(), 170);
        return static_cast<double>(last - first) / static_cast<double>(codes.size());
    }
    /// Returns the code below which this share of the pixels lies.
    [[nodiscard]] double below(double share) const
    {
        return codes[static_cast<std::size_t>(share * static_cast<double>(codes.size() - 1))];
    }
};

double codeOf(double linear)
{
    return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

template <typename ColorOf> Levels levelsOf(const Picture& p, const ColorOf& colorOf)
{
    Levels levels;
    p.each([&](int x, int y) {
        const glm::dvec3 c = colorOf(p.color(x, y));
        levels.white += std::max({c.r, c.g, c.b}) >= nearlyWhite;
        levels.codes.push_back((codeOf(c.r) + codeOf(c.g) + codeOf(c.b)) / 3);
    });
    std::sort(levels.codes.begin(), levels.codes.end());
    levels.white /= static_cast<double>(p.width()) * p.height();
    for (const Region& r : regions) {
        double sum = 0, count = 0;
        for (int y = static_cast<int>(r.top * p.height()); y < (r.top + r.height) * p.height(); ++y)
            for (int x = static_cast<int>(r.left * p.width()); x < (r.left + r.width) * p.width(); ++x, ++count)
                sum += glm::dot(colorOf(p.color(x, y)), glm::dvec3(0.2126, 0.7152, 0.0722));
        if (sum / count < r.darkest || sum / count > r.brightest)
            levels.wrong.push_back(r.name + (' ' + std::to_string(sum / count)));
    }
    return levels;
}

/// Plain sigmoid in log exposure, of the contrast of the hall's curve, without its shoulder and toe.
glm::dvec3 plainSigmoid(const glm::dvec3& radiance)
{
    constexpr double exposure = 7.5, contrast = 1.5, gray = 0.18;
    const glm::dvec3 x = glm::pow(radiance * exposure, glm::dvec3(contrast));
    return x / (x + std::pow(gray, contrast) * (1 - gray) / gray);
}

/// Shot of the hall in its initial air, as a display shows it.
Shot displayed(const render::Camera& camera)
{
    Shot shot;
    shot.inHall();
    shot.request.samples = 4;
    shot.request.frame.camera = shot.sceneState.camera = camera;
    shot.size(192, 108);
    const std::size_t rays = *test::gallery().museum.find("crepuscular_rays");
    shot.sceneState.values[rays].resetParameter(test::raysTable().technique.row);
    shot.request.frame.averageIn = AverageIn::display;
    return shot;
}

const auto asShown = [](const glm::dvec3& color) { return color; };

TEST_F(LongLightLevels, OfTheFirstViewHaveContrastAndLeaveNothingWhite)
{
    Shot shot = displayed(hall().bestView(Shot().hall()));
    const Levels shown = levelsOf(shot.take(), asShown);
    EXPECT_LT(shown.white, 0.003);
    EXPECT_GE(shown.deviation(), 33);
    EXPECT_LE(shown.middle(), 0.48);
    for (const std::string& wrong : shown.wrong) ADD_FAILURE() << wrong;
    // Control: without a shoulder, more of the window is white, and the sunlit floor is too bright.
    shot.request.frame.averageIn = AverageIn::radiance;
    const Levels plain = levelsOf(shot.take(), plainSigmoid);
    EXPECT_GT(plain.white, 0.006);
    EXPECT_GE(plain.wrong.size(), 1U);
}

TEST_F(LightLevels, AreNotVeiledByDustInTheBeam)
{
    // From the window, along the sunlight: all of the hall is seen through the lit dust.
    const Levels shown = levelsOf(displayed({{0, 1.65, -10.5}, {-4.7, 1.9, 10}}).take(), asShown);
    EXPECT_GE(shown.deviation(), 28);
    EXPECT_LE(shown.below(0.01), 70);
}

}  // namespace
}  // namespace vitrine::hall
