// Channels of a picture besides its color.

#include "tests/support/gallery.h"
#include "tests/support/tables.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using namespace test;

class PictureChannels : public test::GlTest {};

/// Returns the base color at a pixel of a picture with the channels normal and albedo.
glm::dvec3 albedoAt(const Picture& picture, int x, int y)
{
    return {picture.image.at(x, y, 8), picture.image.at(x, y, 9), picture.image.at(x, y, 10)};
}

using LongPictureChannels = PictureChannels;

TEST_F(PictureChannels, AlbedoIsTheColorOfTheMaterialInAnyLight)
{
    const glm::dvec3 color(0.75, 0.5, 0.125);  // Exact as half floats.
    Shot shot;
    shot.request.frame.channels = {.normal = true, .albedo = true};
    shot.values().set(sdfTable().baseColor, ColorValue{color});
    for (const bool shownAsMesh : {false, true}) {
        shot.values().set(sdfTable().shownAs, shownAsMesh ? SdfShown::mesh : SdfShown::field);
        for (const double sun : {0.1, 0.9}) {
            shot.hall().set(hallTable().sunElevation, sun);
            const Picture picture = shot.take();
            ASSERT_EQ(picture.image.channelNames[8], "albedo.R");
            int hits = 0;
            picture.each([&](int x, int y) {
                const glm::dvec3 expected = picture.hit(x, y) ? color : glm::dvec3(0);
                hits += picture.hit(x, y) ? 1 : 0;
                EXPECT_EQ(albedoAt(picture, x, y), expected) << x << ' ' << y;
            });
            EXPECT_GT(hits, 100);
        }
    }
}

TEST_F(LongPictureChannels, AlbedoOfTheHallDoesNotDependOnLightAndIsAReflectance)
{
    Shot shot;
    shot.inHall().size(64, 36);
    shot.request.frame.channels = {.normal = true, .albedo = true};
    const Picture evening = shot.take();
    shot.hall().set(hallTable().sunElevation, 0.9);
    const Picture noon = shot.take();
    double sum = 0;
    evening.each([&](int x, int y) {
        const glm::dvec3 albedo = albedoAt(evening, x, y);
        EXPECT_EQ(albedo, albedoAt(noon, x, y)) << x << ' ' << y;
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(albedo[c] >= 0 && albedo[c] <= 1) << x << ' ' << y;
        sum += albedo.y;
    });
    EXPECT_GT(sum / (64 * 36), 0.1) << "walls are light";
    EXPECT_GT(largestDifference(evening.image, noon.image), 0.01);
}

/// The channel is computed from depth and two cameras. The truth is another picture, from the camera before: where the
/// channel points in it, there is the same surface.
TEST_F(PictureChannels, MotionPointsToTheSameSurfaceInTheFrameBefore)
{
    Shot shot;
    shot.inHall().size(96, 64);
    shot.request.frame.channels = {};
    shot.request.depth = false;
    shot.request.position = true;
    Shot earlier = shot;
    render::Camera& camera = earlier.request.frame.camera;
    camera.eye += glm::dvec3(0.15, 0.08, 0.1);
    camera.target += glm::dvec3(-0.1, 0.05, 0);
    earlier.sceneState.camera = camera;
    shot.request.before = FrameBefore{0.25, camera};
    const Picture now = shot.take(), before = earlier.take();
    ASSERT_EQ(now.image.channelNames[7], "backward.u");
    const auto place = [](const Picture& p, int x, int y) {
        return glm::dvec3(p.image.at(x, y, 4), p.image.at(x, y, 5), p.image.at(x, y, 6));
    };
    int compared = 0, same = 0;
    double moved = 0;
    now.each([&](int x, int y) {
        const glm::dvec2 vector(now.image.at(x, y, 7), now.image.at(x, y, 8));
        const glm::dvec3 here = place(now, x, y);
        const int atX = static_cast<int>(std::floor(x + 0.5 + vector.x));
        const int atY = static_cast<int>(std::floor(y + 0.5 - vector.y));  // v points up.
        if (here == glm::dvec3(0) || atX < 0 || atY < 0 || atX >= before.width() || atY >= before.height()) return;
        ++compared;
        moved = std::max(moved, glm::length(vector));
        // A pixel is wider on a surface that is seen at a slant: up to ten times here.
        const double pixel = 2 * std::tan(camera.fovY / 2) / 64 * glm::distance(here, camera.eye);
        same += glm::distance(here, place(before, atX, atY)) < 10 * pixel ? 1 : 0;
    });
    EXPECT_GT(moved, 4) << "pixels";
    EXPECT_GT(compared, 96 * 64 / 2);
    // The rest is behind something from one of the two places.
    EXPECT_GT(same, 0.93 * compared);
}

TEST_F(PictureChannels, MotionOfACameraThatTurnsIsTheSameAtAnyDistance)
{
    Shot shot;
    shot.size(60, 40);
    shot.request.frame.channels = {};
    const render::Camera camera = shot.request.frame.camera;
    render::Camera turned = camera;
    const glm::dvec3 ahead = camera.target - camera.eye;
    const double angle = 0.02;
    turned.target = camera.eye + glm::dvec3(std::cos(angle) * ahead.x + std::sin(angle) * ahead.z, ahead.y,
                                            std::cos(angle) * ahead.z - std::sin(angle) * ahead.x);
    shot.request.before = FrameBefore{0.25, turned};
    const Picture picture = shot.take();
    const render::View was = render::makeView(turned, {{60, 40}});
    int sky = 0, surface = 0;
    picture.each([&](int x, int y) {
        (picture.hit(x, y) ? surface : sky) += 1;
        // The direction of the pixel, in the axes of the camera before.
        const glm::dvec3 ray = picture.ray(x, y);
        const glm::dvec3 seen = glm::dvec3(was.viewFromWorld * glm::dvec4(ray, 0));
        const double focal = 20 / std::tan(camera.fovY / 2);  // Pixels.
        const glm::dvec2 at(30 + focal * seen.x / -seen.z, 20 + focal * seen.y / -seen.z);
        EXPECT_NEAR(picture.image.at(x, y, 5), at.x - (x + 0.5), 1e-3) << x << ' ' << y;
        EXPECT_NEAR(picture.image.at(x, y, 6), at.y - (40 - y - 0.5), 1e-3) << x << ' ' << y;
    });
    EXPECT_GT(std::min(sky, surface), 100);
}

}  // namespace
}  // namespace vitrine
