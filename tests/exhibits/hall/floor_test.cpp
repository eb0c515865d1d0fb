// Floor of the hall: contact shadows, and reflections of window, bars and plinths.

#include "exhibits/hall/hall_model.h"
#include "tests/support/gallery.h"
#include "tests/support/museum_on_paper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace vitrine::hall {
namespace {

using namespace test;

class Floor : public test::GlTest {};

Shot hallShot(const glm::dvec3& eye, const glm::dvec3& target, double fov)
{
    Shot shot;
    shot.inHall();
    shot.request.frame.channels.normal = false;
    shot.see(eye, target);
    shot.request.frame.camera.fovY = fov;
    return shot;
}

/// Returns the position of a point in pixels from the top left; pixel centers are at halves.
glm::dvec2 pixelOf(const Picture& picture, const glm::dvec3& world)
{
    const glm::dvec4 clip = picture.view.clipFromWorld * glm::dvec4(world, 1);
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    return {(0.5 + 0.5 * ndc.x) * picture.width(), (0.5 - 0.5 * ndc.y) * picture.height()};
}

double luminanceAt(const Picture& picture, const glm::dvec3& world)
{
    const glm::dvec2 p = pixelOf(picture, world);
    return picture.luminance(static_cast<int>(p.x), static_cast<int>(p.y));
}

/// Object on the floor, with a point of the floor in front of it and the direction away from it.
struct Standing {
    const char* what;
    glm::dvec3 edge, away, eye;
};

const std::vector<Standing>& standingThings()
{
    static const std::vector<Standing> things{
        {"the card's stand", {-3.0697, 0, 2.865}, {0.868, 0, -0.5}, {-1.9, 0.9, 2.2}},
        {"the plinth in the middle", {0.1, 0, 0.4}, {0, 0, 1}, {0.9, 1.0, 2.2}},
        {"the free plinth", {3.1, 0, -2.95}, {0, 0, 1}, {3.6, 1.0, -1.2}},
        {"a bench", {0.62, 0, 8.31}, {0, 0, -1}, {1.0, 0.8, 7.0}},
        {"the post of a button", {0.72, 0, 0.74}, {0, 0, 1}, {1.1, 0.8, 2.0}},
        {"the rim of the pit", {3.3, 0, 4.955}, {0, 0, 1}, {3.6, 1.0, 6.4}}};
    return things;
}

using LongFloor = Floor;

TEST_F(LongFloor, IsDarkerWhereSomethingStandsThanAStepAway)
{
    for (const Standing& thing : standingThings()) {
        Shot shot = hallShot(thing.eye, thing.edge + 0.2 * thing.away, 0.7);
        shot.size(96, 72);
        shot.hall().set(hallTable().reflectionProbe, false);
        shot.hall().set(hallTable().sunStrength, 0.0);
        // Only ambient light is occluded, so lamps are off.
        for (const char* exhibit : {"fur", "lenticular"}) {
            ParameterValues& values = shot.sceneState.values[*test::gallery().museum.find(exhibit)];
            values.setParameter(values.table().find("lamp").value(), 0.0);
        }
        const Picture with = shot.take();
        shot.hall().set(hallTable().contactShadows, false);
        const Picture without = shot.take();
        const auto left = [&](double meters) {
            const glm::dvec3 place = thing.edge + meters * thing.away;
            return luminanceAt(with, place) / luminanceAt(without, place);
        };
        EXPECT_LT(left(0.015), 0.88) << thing.what;
        EXPECT_GT(left(0.45), 0.92) << thing.what;  // The mug extends over the floor around its plinth.
        EXPECT_GT(left(0.45) - left(0.015), 0.08) << thing.what;
        EXPECT_LE(left(0.015), left(0.1) + 0.02) << thing.what;
    }
}

/// Returns the mean profile across the mirror image of an upright line, over its heights: values at whole pixels from
/// -`reach` to `reach`.
std::vector<double> acrossTheImage(const Picture& picture, const std::function<glm::dvec3(double)>& line, int reach,
                                   const std::function<double(int, int)>& value)
{
    std::vector<double> profile(static_cast<std::size_t>(2 * reach + 1), 0);
    std::vector<int> count(profile.size(), 0);
    int last = -1;
    for (double t = 0; t <= 1; t += 1e-3) {
        const glm::dvec2 p = pixelOf(picture, line(t));
        const int row = static_cast<int>(p.y);
        if (row == last || row < 0 || row >= picture.height()) continue;
        last = row;
        for (int i = -reach; i <= reach; ++i) {
            // Interpolates between the two nearest pixels, so that a slanted line stays in the middle.
            const double x = p.x - 0.5 + i;
            const int left = static_cast<int>(std::floor(x));
            if (left < 0 || left + 1 >= picture.width()) continue;
            const double share = x - left;
            profile[static_cast<std::size_t>(i + reach)] +=
                (1 - share) * value(left, row) + share * value(left + 1, row);
            ++count[static_cast<std::size_t>(i + reach)];
        }
    }
    for (std::size_t i = 0; i < profile.size(); ++i) profile[i] /= std::max(count[i], 1);
    return profile;
}

/// Lowest point of the profile relative to the line between its ends: its distance from the middle, and its depth
/// relative to the ends.
struct Dip {
    double at = 0, depth = 0;
};
Dip dipOf(std::vector<double> profile)
{
    const auto n = static_cast<double>(profile.size() - 1);
    const double first = profile.front();
    const double last = profile.back();
    for (std::size_t i = 0; i < profile.size(); ++i) profile[i] -= first + (last - first) * static_cast<double>(i) / n;
    const auto lowest = std::min_element(profile.begin() + 1, profile.end() - 1);
    const double bend = lowest[-1] - 2 * lowest[0] + lowest[1];
    const double part = bend > 0 ? 0.5 * (lowest[-1] - lowest[1]) / bend : 0;
    return {static_cast<double>(lowest - profile.begin()) + part - n / 2, -*lowest / (0.5 * (first + last))};
}

/// Returns a shot of the window's mirror image without obstacles: from behind the plinth, above the desk's image,
/// beside the inlay.
Shot windowShot()
{
    Shot shot = hallShot({-0.7, 1.65, -1.5}, {-0.5, 0, -5.0}, 0.5);
    shot.size(256, 144);
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().probeSize, 128);
    return shot;
}

TEST_F(Floor, MirrorsTheBarsOfTheWindowWhereRaysFindThem)
{
    Shot shot = windowShot();
    const Picture shapes = shot.take();
    shot.hall().set(hallTable().floorMirror, FloorMirror::probe);
    const Picture probe = shot.take();
    shot.hall().set(hallTable().reflectionProbe, false);
    const Picture none = shot.take();
    const WindowBars& bars = test::building().furniture().bars;
    ASSERT_EQ(bars.upright.size(), 3U);
    for (const glm::dvec2& bar : bars.upright) {
        const auto line = [&](double t) { return glm::dvec3(bar.x, -(3.0 + 1.4 * t), bars.z); };
        // Mirrored light only, without light that the stone scatters.
        const auto mirroredIn = [&](const Picture& picture) {
            return acrossTheImage(picture, line, 5,
                                  [&](int x, int y) { return picture.luminance(x, y) - none.luminance(x, y); });
        };
        const Dip found = dipOf(mirroredIn(shapes));
        EXPECT_NEAR(found.at, 0, 1) << bar.x;
        EXPECT_GT(found.depth, 0.03) << bar.x;
        EXPECT_LT(dipOf(mirroredIn(probe)).depth, 0.5 * found.depth) << bar.x;
    }
}

TEST_F(Floor, MirrorsAPlinthWhereRaysFindIt)
{
    Shot shot = hallShot({1.3, 1.65, 4.2}, {0, 0, 0.9}, 0.5);
    shot.size(192, 108);
    // On an overcast day the stone is darker than the room behind it. In sunlight, which is bounced to its front, it
    // would be about as bright.
    shot.hall().set(hallTable().sunStrength, 0.0);
    shot.hall().set(hallTable().probeSize, 128);
    const Picture shapes = shot.take();
    shot.hall().set(hallTable().floorMirror, FloorMirror::probe);
    const Picture probe = shot.take();
    // Left edge, from a hand above the floor to half its height. Left of it is the room, right of it the stone.
    const auto line = [](double t) { return glm::dvec3(-0.4, -(0.1 + 0.35 * t), 0.4); };
    const int reach = 8;
    const std::vector<double> change = acrossTheImage(
        shapes, line, reach, [&](int x, int y) { return shapes.luminance(x, y) / probe.luminance(x, y); });
    std::size_t steepest = 1;
    for (std::size_t i = 1; i + 1 < change.size(); ++i)
        if (std::abs(change[i + 1] - change[i - 1]) > std::abs(change[steepest + 1] - change[steepest - 1]))
            steepest = i;
    EXPECT_NEAR(static_cast<double>(steepest), reach, 1.5);
    // Control: the probe does not contain the plinth, which changes the floor in front of it.
    EXPECT_GT(std::abs(change.back() - change.front()), 0.03);
}

/// Returns Pearson's correlation.
double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const auto n = static_cast<double>(a.size());
    const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / n;
    const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / n;
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - meanA) * (b[i] - meanB);
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
    }
    return ab / std::sqrt(aa * bb);
}

TEST_F(Floor, MirrorsThePictureInScreenSpace)
{
    const glm::dvec3 eye(-2, 0.6, -2);
    Shot shot = hallShot(eye, {-6.5, 0.9, -6}, 0.9);
    shot.size(320, 180);
    shot.hall().set(hallTable().probeSize, 128);
    const Picture shapes = shot.take();
    shot.hall().set(hallTable().floorMirror, FloorMirror::screen);
    const Picture screen = shot.take();
    const double wall = building().room().low.x;
    // Mean light of parts of the wall, `aside` meters beside those whose mirror images are in the floor, and how the
    // floor has changed there. Parts are as wide as the floor's lobe.
    const auto alike = [&](double aside) {
        constexpr int points = 5;  // Along each side of a part.
        constexpr double part = 0.4;
        std::vector<double> seen, changed;
        for (double low = 0.1; low < 1.6; low += part)
            for (double left = -7.5; left < -3.5; left += part) {
                double light = 0, change = 0;
                int count = 0;
                for (int i = 0; i < points * points; ++i) {
                    const double y = low + part * (i / points + 0.5) / points;
                    const double z = left + part * (i % points + 0.5) / points;
                    const double way = eye.y / (eye.y + y);
                    const glm::dvec3 place(glm::mix(eye.x, wall, way), 0, glm::mix(eye.z, z, way));
                    const glm::dvec2 at = pixelOf(screen, place);
                    if (at.x < 1 || at.y < 1 || at.x > screen.width() - 1 || at.y > screen.height() - 1) continue;
                    light += luminanceAt(screen, {wall, y, z + aside});
                    change += luminanceAt(screen, place) - luminanceAt(shapes, place);
                    ++count;
                }
                if (count < points * points) continue;
                seen.push_back(light / count);
                changed.push_back(change / count);
            }
        EXPECT_GT(seen.size(), 20U);
        return correlation(seen, changed);
    };
    EXPECT_GT(alike(0), 0.5);
    // Control: not with what stands beside.
    EXPECT_GT(alike(0), alike(-1.5) + 0.2);
    EXPECT_GT(alike(0), alike(1.5) + 0.2);
    // In tiles, which do not show each other, the floor keeps to the shapes.
    shot.size(96, 54);
    shot.request.largestTile = 32;
    const Picture tiled = shot.take();
    shot.hall().set(hallTable().floorMirror, FloorMirror::shapes);
    EXPECT_EQ(tiled.image.pixels, shot.take().image.pixels);
}

TEST_F(Floor, IsTheSameInTiles)
{
    Shot shot = windowShot();
    shot.size(96, 54);
    const Picture once = shot.take();
    shot.request.largestTile = 32;
    const Picture tiled = shot.take();
    int different = 0;
    once.each([&](int x, int y) {
        different += std::abs(once.luminance(x, y) - tiled.luminance(x, y)) > 0.01 * once.luminance(x, y) + 1e-4;
    });
    EXPECT_LE(different, 96 * 54 / 100);
}

TEST_F(Floor, KeepsItsContactShadowsWhileNothingElseStandsThere)
{
    const Museum& museum = test::gallery().museum;
    test::Scene scene;
    const render::FramePlan first = scene.plan();
    ASSERT_NE(first.find("floor/contact"), nullptr);
    EXPECT_EQ(scene.plan(test::keptAfter(first)).find("floor/contact"), nullptr);
    scene.hall().set(hallTable().exposure, 1.0);
    EXPECT_EQ(scene.plan(test::keptAfter(first)).find("floor/contact"), nullptr);
    // In an empty museum, covered shapes replace the stands.
    const Museum empty{std::vector<std::unique_ptr<Exhibit>>{}};
    test::Scene bare;
    const render::FramePlan other =
        test::planned(empty, empty.initialSceneState(), bare.request, test::keptAfter(first));
    EXPECT_NE(other.find("floor/contact"), nullptr);
    scene.hall().set(hallTable().contactShadows, false);
    EXPECT_EQ(test::reasonFor(scene.plan(), "floor/contact"), "contact shadows are switched off");
    EXPECT_FALSE(museum.exhibits().empty());
}

}  // namespace
}  // namespace vitrine::hall
