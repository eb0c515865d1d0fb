#include "render/scene/camera.h"
#include "tests/stability/fields.h"
#include "tests/support/edge_error.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine {
namespace {

using namespace render;

using std::numbers::pi;

bool allFinite(const glm::dmat4& m)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

/// Returns the depth that a float32 pipeline stores for a point at `distance` in front of a camera at the origin.
float storedDepth(const glm::mat4& clipFromView, double distance)
{
    const glm::vec4 clip = clipFromView * glm::vec4(0, 0, static_cast<float>(-distance), 1);
    return clip.z / clip.w;
}

TEST(Camera, ReversedDepthKeepsSevenDigitsFrom1To900Meters)
{
    const glm::mat4 clipFromView(makeView({}, {}).clipFromView);
    double worst = 0;
    double worstStandard = 0;
    for (double z = 1; z <= 900; z *= 1.001) {
        // Compares with the rounded position, whose error is not due to the matrix.
        const auto position = static_cast<double>(static_cast<float>(z));
        worst =
            std::max(worst, std::abs(View{}.nearPlane / static_cast<double>(storedDepth(clipFromView, z)) - position) /
                                position);
        // Control: GL's default depth, -1 to 1 with a far plane at 1 km, loses four digits.
        const double n = View{}.nearPlane, f = 1000;
        const auto standard = static_cast<float>((f + n) / (f - n) - 2 * f * n / ((f - n) * position));
        worstStandard =
            std::max(worstStandard,
                     std::abs(2 * f * n / ((f + n) - static_cast<double>(standard) * (f - n)) - position) / position);
    }
    EXPECT_LT(worst, 2e-7);
    EXPECT_GT(worstStandard, 1e-4);
}

TEST(Camera, InfinityIsDepthZeroAndNothingIsNaN)
{
    const View view = makeView({}, {});
    EXPECT_TRUE(allFinite(view.clipFromWorld));
    const glm::mat4 clipFromView(view.clipFromView);
    float last = storedDepth(clipFromView, View{}.nearPlane);
    EXPECT_NEAR(last, 1, 1e-6);
    for (double z = 0.03; z < 1e30; z *= 3) {
        const float depth = storedDepth(clipFromView, z);
        EXPECT_LT(depth, last);
        EXPECT_GT(depth, 0);
        last = depth;
    }
    const glm::dvec4 atInfinity = view.clipFromView * glm::dvec4(0, 0, -1, 0);
    EXPECT_EQ(atInfinity.z / atInfinity.w, 0);
}

TEST(Camera, AnyFieldOfViewAndDirectionGivesAFinitePicture)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double fov : {0.0, -1.0, 1e-9, 0.9, pi, 100.0, infinity, -infinity, nan}) {
        for (const glm::dvec3 target :
             {glm::dvec3(0, 1.65, 10.5), glm::dvec3(0, 5, 10.5), glm::dvec3(0, -5, 10.5), glm::dvec3(3, 1, 2)}) {
            for (const glm::ivec2 size :
                 {glm::ivec2(1, 1), glm::ivec2(16384, 1), glm::ivec2(1, 16384), glm::ivec2(0, 0)}) {
                Camera camera;
                camera.target = target;
                camera.fovY = fov;
                const View view = makeView(camera, {.size = size});
                EXPECT_TRUE(allFinite(view.clipFromWorld));
                EXPECT_GE(view.tanHalfFov.y, std::tan(0.49999 * pi / 180));
                EXPECT_LE(view.tanHalfFov.y, std::tan(87.50001 * pi / 180));
            }
        }
    }
}

TEST(Camera, NoPlaceIsTooFarOrTooStrangeToLookFrom)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const glm::dvec3 far(0, 0, 1e17);
    EXPECT_FALSE(
        // The point ahead is rounded to the eye.
        allFinite(glm::lookAt(far, far + glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0))));
    const double places[] = {0, 1e5, 1e6, -1e17, 1e300, infinity, -infinity, nan};
    for (const double x : places) {
        for (const double y : places) {
            const View view = makeView({.eye = {x, 1, y}, .target = {y, x, -3}}, {});
            EXPECT_TRUE(allFinite(glm::dmat4(glm::mat4(view.clipFromWorld)))) << x << ' ' << y;
            const glm::dmat3 turn(view.viewFromWorld);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    EXPECT_NEAR(glm::dot(turn[i], turn[j]), i == j ? 1 : 0, 1e-9) << x << ' ' << y;
        }
    }
    // Far from the origin, the direction keeps its precision.
    const View view = makeView({.eye = {1e5, 0, 1e5}, .target = {1e5 + 1, 0, 1e5 - 1}}, {});
    EXPECT_NEAR(view.viewFromWorld[0][2], -std::sqrt(0.5), 1e-12);
}

TEST(Camera, NeverCallsHiddenWhatHasAPointInView)
{
    test::Random random(1);
    int out = 0;
    for (int i = 0; i < 3000; ++i) {
        Camera camera{
            random.point(6), random.point(6), random.number(0.2, 2.5), {random.number(-1, 1), random.number(-1, 1)}};
        const View view = makeView(
            camera, {.size = {static_cast<int>(random.number(1, 400)), static_cast<int>(random.number(1, 400))},
                     .jitter = {random.number(-0.5, 0.5), random.number(-0.5, 0.5)}});
        const glm::dvec3 center = random.point(8);
        const glm::dvec3 half = glm::abs(random.point(i % 3 == 0 ? 5 : 0.5));
        const Box box{center - half, center + half};
        const bool may = view.mayContain(box);
        out += !may;
        for (int j = 0; j < 60 && !may; ++j) {
            const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(center + half * random.point(1), 1);
            EXPECT_FALSE(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && clip.z < clip.w && clip.z > 0);
        }
    }
    EXPECT_GT(out, 1000);  // The culling has an effect.
    EXPECT_FALSE(makeView({}, {}).mayContain(Box{}));
    EXPECT_TRUE(makeView({}, {}).mayContain({glm::dvec3(-100), glm::dvec3(100)}));
}

TEST(Camera, ATileIsThatPartOfThePicture)
{
    test::Random random(2);
    for (int i = 0; i < 500; ++i) {
        const Camera camera{
            random.point(3), random.point(3), random.number(0.2, 2), {random.number(-1, 1), random.number(-1, 1)}};
        const glm::ivec2 size(random.number(2, 500), random.number(2, 500));
        const glm::ivec2 offset(random.number(0, size.x - 1), random.number(0, size.y - 1));
        const glm::ivec2 tile(random.number(1, size.x - offset.x), random.number(1, size.y - offset.y));
        const glm::dvec2 jitter(random.number(-0.5, 0.5), random.number(-0.5, 0.5));
        const View whole = makeView(camera, {.size = size});
        const View part = makeView(camera, {.size = size, .offset = offset, .tile = tile, .jitter = jitter});
        const glm::dvec4 p(camera.eye + (camera.target - camera.eye) * random.number(0.5, 3) + random.point(0.3), 1);
        const glm::dvec4 a = whole.clipFromWorld * p;
        const glm::dvec4 b = part.clipFromWorld * p;
        if (a.w < 0.05) continue;
        const glm::dvec2 pixel = (glm::dvec2(a) / a.w * 0.5 + 0.5) * glm::dvec2(size);
        const glm::dvec2 pixelInTile = (glm::dvec2(b) / b.w * 0.5 + 0.5) * glm::dvec2(tile);
        // The sample is `jitter` beside the pixel's center, so the picture moves the other way.
        EXPECT_LT(glm::length(pixel - jitter - glm::dvec2(offset) - pixelInTile), 1e-6 * (1 + glm::length(pixel)));
        EXPECT_NEAR(a.z / a.w, b.z / b.w, 1e-12);
    }
}

/// Returns the position of a point in pixels from the lower left corner.
glm::dvec2 pixelOf(const Camera& camera, const glm::ivec2& size, const glm::dvec3& point)
{
    const glm::dvec4 clip = makeView(camera, {.size = size}).clipFromWorld * glm::dvec4(point, 1);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size);
}

TEST(Camera, AShiftedLensSlidesThePictureByTheClosedForm)
{
    test::Random random(4);
    double farthestMove = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::ivec2 size(random.number(20, 2000), random.number(20, 2000));
        const Camera middle{random.point(3), random.point(3), random.number(0.2, 2)};
        const glm::dvec3 forward = glm::normalize(middle.target - middle.eye);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
        const glm::dvec3 up = glm::cross(right, forward);
        const double plane = random.number(0.5, 5);
        const glm::dvec2 move(random.number(-0.4, 0.4), random.number(-0.4, 0.4));
        Camera moved = middle;
        moved.eye += right * move.x + up * move.y;
        moved.target += right * move.x + up * move.y;
        moved.lensShift = -move / plane;
        const double distance = i % 3 == 0 ? plane : random.number(0.3, 20);
        const double tanY = std::tan(middle.fovY / 2);
        const glm::dvec2 side = glm::dvec2(random.number(-1, 1), random.number(-1, 1)) * distance * tanY;
        const glm::dvec3 point = middle.eye + forward * distance + right * side.x + up * side.y;
        // A point at z moves by X (1/C - 1/z): with the camera if it is behind the plane C, against it in front,
        // linearly in X.
        const glm::dvec2 expected = move * (1 / plane - 1 / distance) * (size.y / (2 * tanY));
        const glm::dvec2 seen = pixelOf(moved, size, point) - pixelOf(middle, size, point);
        EXPECT_LT(glm::length(seen - expected), 1e-6);
        if (distance == plane) {
            EXPECT_LT(glm::length(seen), 1e-6);
        }
        farthestMove = std::max(farthestMove, glm::length(seen));
    }
    EXPECT_GT(farthestMove, 100);  // The points moved far enough for a meaningful test.
}

TEST(Camera, ADirectionLeadsToItsPlaceInThePictureWithAShiftedLensToo)
{
    test::Random random(5);
    for (int i = 0; i < 300; ++i) {
        const Camera camera{
            random.point(3), random.point(3), random.number(0.2, 2), {random.number(-1, 1), random.number(-1, 1)}};
        const glm::ivec2 size(random.number(2, 500), random.number(2, 500));
        const View view = makeView(camera, {.size = size});
        const glm::dvec2 ndc(random.number(-1, 1), random.number(-1, 1));
        const glm::dvec2 pixel = pixelOf(camera, size, camera.eye + view.direction(ndc) * random.number(0.1, 50));
        EXPECT_LT(glm::length(pixel - (ndc * 0.5 + 0.5) * glm::dvec2(size)), 1e-6);
    }
    Camera broken;
    broken.lensShift = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    EXPECT_TRUE(allFinite(makeView(broken, {}).clipFromWorld));
}

TEST(Camera, SamplesFillThePixelEvenlyAndStartInItsMiddle)
{
    for (const int n : {1, 4, 9, 64, 256}) {
        glm::dvec2 sum(0);
        for (int i = 0; i < n; ++i) {
            const glm::dvec2 p = samplePosition(i, n);
            EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec2(0.5))));
            sum += p;
        }
        EXPECT_EQ(samplePosition(0, n), glm::dvec2(0));
        // The mean of a low-discrepancy sequence differs from the center by much less than 1/sqrt(n).
        EXPECT_LT(glm::length(sum) / n, n == 1 ? 1e-12 : 0.6 / n + 0.25 / std::sqrt(n)) << n;
    }
}

TEST(LongCamera, SamplesOfEdgesErrWithThePower3Over4OfTheirNumberButForTheFirstFew)
{
    const auto ours = [](int n) { return test::edgeError(n, [n](int i) { return samplePosition(i, n); }); };
    test::Random places(9);
    const auto random = [&](int n) {
        return test::edgeError(n, [&](int) { return glm::dvec2(places.number(-0.5, 0.5), places.number(-0.5, 0.5)); });
    };
    const auto power = [](double few, double many, double ratio) { return std::log(few / many) / std::log(ratio); };
    // Exponent for a low-discrepancy sequence of two dimensions: 3/4 (Mitchell 1996), which halves the error with
    // 2^(4/3) = 2.5 times the samples. Random samples have 1/2, and need 4 times as many.
    EXPECT_NEAR(power(ours(2), ours(1024), 512), 0.75, 0.05);
    EXPECT_NEAR(power(random(2), random(128), 64), 0.5, 0.03);
    // A single sample is at the center, where it is as good as two random ones. Therefore the exponent up to 16 is
    // lower.
    EXPECT_LT(ours(1), 0.75 * random(1));
    EXPECT_LT(power(ours(1), ours(16), 16), 0.5);
    EXPECT_LT(ours(16), 0.85 * random(16));
}

TEST(Camera, ReversedOrthographicPutsNearAt1AndFarAt0)
{
    const glm::dmat4 m = reversedOrthographic({-2, -1}, {4, 3}, -0.5, -9);
    EXPECT_NEAR((m * glm::dvec4(0, 0, -0.5, 1)).z, 1, 1e-12);
    EXPECT_NEAR((m * glm::dvec4(0, 0, -9, 1)).z, 0, 1e-12);
    EXPECT_NEAR((m * glm::dvec4(-2, 3, -1, 1)).x, -1, 1e-12);
    EXPECT_NEAR((m * glm::dvec4(-2, 3, -1, 1)).y, 1, 1e-12);
}

TEST(Box, TransformedHoldsEveryTransformedPoint)
{
    test::Random random(3);
    for (int i = 0; i < 300; ++i) {
        glm::dmat4 m(1);
        for (int c = 0; c < 4; ++c) m[c] = glm::dvec4(random.point(2), c == 3 ? 1 : 0);
        const glm::dvec3 half = glm::abs(random.point(2));
        const Box box{-half, half};
        const Box moved = box.transformed(m);
        for (int j = 0; j < 20; ++j) {
            const glm::dvec3 p = glm::dvec3(m * glm::dvec4(half * random.point(1), 1));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, moved.low - 1e-12)) &&
                        glm::all(glm::lessThanEqual(p, moved.high + 1e-12)));
        }
    }
    EXPECT_TRUE(Box{}.transformed(glm::dmat4(1)).empty());
}

}  // namespace
}  // namespace vitrine
