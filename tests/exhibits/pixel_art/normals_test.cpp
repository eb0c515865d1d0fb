// Normals from depth at float64: the GPU's own methods, on scenes traced by closed forms.

#include "exhibits/pixel_art/normals_cpu.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "tests/exhibits/pixel_art/traced_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <random>

namespace vitrine::pixel_art {
namespace {

using namespace test;
using glm::dvec3;
using glm::ivec2;
using DepthOf = std::function<double(ivec2)>;
using Methods = glsl::NormalsFromDepth<DepthOf>;

constexpr NormalsBy fromDepth[] = {NormalsBy::tap3,     NormalsBy::tap4,     NormalsBy::tap5, NormalsBy::tap9,
                                   NormalsBy::tap9Plus, NormalsBy::parabola, NormalsBy::vote};

dvec3 normalBy(NormalsBy method, Methods& m, const Methods::DepthLens& lens, ivec2 p)
{
    switch (method) {
    case NormalsBy::tap3: return m.normal3Tap(lens, p);
    case NormalsBy::tap4: return m.normal4Tap(lens, p);
    case NormalsBy::tap5: return m.normal5Tap(lens, p);
    case NormalsBy::tap9: return m.normal9Tap(lens, p);
    case NormalsBy::tap9Plus: return m.normal9TapPlus(lens, p);
    case NormalsBy::parabola: return m.normalCurved(lens, p);
    case NormalsBy::vote:
    case NormalsBy::trueNormals: break;
    }
    return m.normalVoted(lens, p);
}

/// Traced picture as a depth buffer of some kind stores it.
struct Buffer {
    explicit Buffer(const TracedPicture& traced, double levels = 0, bool standard = false, bool exact = false)
        : picture(traced), methods{[this, levels, standard, exact](ivec2 p) {
              EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.x < picture.size.x && p.y < picture.size.y);
              ++fetches;
              const double d = picture.depth[picture.index(p)];
              return exact ? (standard ? 1 - d : d) : stored(d, levels, standard);
          }}
    {
        const PixelBlock& b = traced.block;
        lens = {glm::dvec2(b.halfExtent),   b.nearPlane, b.farPlane, b.orthographic, standard, traced.size,
                levels > 0 ? 1 / levels : 0};
    }
    Buffer(const Buffer&) = delete;
    dvec3 normal(NormalsBy method, ivec2 p) { return normalBy(method, methods, lens, p); }

    const TracedPicture& picture;
    int fetches = 0;  ///< Number of depth texels read so far.
    Methods methods;
    Methods::DepthLens lens{};
};

double degreesBetween(const dvec3& a, const dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

struct Errors {
    double mean = 0, beyond5 = 0, beyond20 = 0;
};

Errors errorsOf(Buffer& buffer, NormalsBy method)
{
    Errors e;
    double count = 0;
    for (int y = 0; y < buffer.picture.size.y; ++y)
        for (int x = 0; x < buffer.picture.size.x; ++x) {
            if (!buffer.picture.hit({x, y})) continue;
            const double off =
                degreesBetween(buffer.normal(method, {x, y}), buffer.picture.normals[buffer.picture.index({x, y})]);
            e.mean += off;
            e.beyond5 += off > 5;
            e.beyond20 += off > 20;
            ++count;
        }
    e.mean /= count;
    e.beyond5 *= 100 / count;
    e.beyond20 *= 100 / count;
    return e;
}

PixelCamera cameraOf(bool orthographic, ivec2 size = {320, 180})
{
    PixelCamera camera;
    camera.azimuth = 0.6;
    camera.elevation = 0.55;
    camera.tall = 9.8;
    camera.orthographic = orthographic;
    camera.size = size;
    return camera;
}

TEST(NormalsFromDepth, PlanesAreExactAtAnySlopeAndEitherWayRound)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> some(-1, 1);
    for (int i = 0; i < 40; ++i) {
        const bool orthographic = i % 2 == 0;
        const dvec3 n = glm::normalize(dvec3(some(random), some(random), some(random)));
        const TracedPicture traced(cameraOf(orthographic, {24, 14}), [&](const dvec3& o, const dvec3& d) {
            std::optional<TracedHit> best;
            const double facing = glm::dot(n, d);
            if (std::abs(facing) > 0.03) nearer(best, -glm::dot(n, o) / facing, facing < 0 ? n : -n);
            return best;
        });
        for (const bool standard : {false, true}) {
            Buffer buffer(traced, 0, standard, true);
            for (int y = 0; y < traced.size.y; ++y)
                for (int x = 0; x < traced.size.x; ++x) {
                    bool whole = true;
                    for (int k = -2; k <= 2; ++k)
                        for (const ivec2 q : {ivec2(x + k, y), ivec2(x, y + k)})
                            whole = whole && (q.x < 0 || q.y < 0 || q.x >= traced.size.x || q.y >= traced.size.y ||
                                              traced.hit(q));
                    if (!whole) continue;
                    for (const NormalsBy method : fromDepth)
                        EXPECT_LT(degreesBetween(buffer.normal(method, {x, y}), traced.normals[traced.index({x, y})]),
                                  1e-6)
                            << i << ' ' << x << ' ' << y << ' ' << static_cast<int>(method);
                }
        }
    }
}

TEST(LongNormalsFromDepth, ErrorsFallInTheKnownOrder)
{
    for (const bool orthographic : {true, false}) {
        const TracedPicture traced(cameraOf(orthographic, {640, 400}), solids);
        Buffer buffer(traced);
        std::map<NormalsBy, Errors> e;
        for (const NormalsBy method : fromDepth) e[method] = errorsOf(buffer, method);
        EXPECT_GT(e[NormalsBy::tap3].beyond5, 2 * e[NormalsBy::tap5].beyond5);
        EXPECT_GT(e[NormalsBy::tap4].beyond5, 2 * e[NormalsBy::tap5].beyond5);
        EXPECT_GT(e[NormalsBy::tap5].beyond5, 1.3 * e[NormalsBy::tap9].beyond5);
        EXPECT_GT(e[NormalsBy::tap9].mean, 1.5 * e[NormalsBy::parabola].mean);
        EXPECT_GT(e[NormalsBy::tap9].beyond5, e[NormalsBy::parabola].beyond5);
        EXPECT_LE(e[NormalsBy::parabola].beyond5, 0.10);
    }
}

TEST(NormalsFromDepth, FewerFetchesGiveTheSameNormalsToTheBit)
{
    const TracedPicture traced(cameraOf(false), solids);
    for (const double levels : {0.0, 65535.0}) {
        Buffer buffer(traced, levels);
        for (int y = 0; y < traced.size.y; ++y)
            for (int x = 0; x < traced.size.x; ++x)
                ASSERT_EQ(buffer.normal(NormalsBy::tap9, {x, y}), buffer.normal(NormalsBy::tap9Plus, {x, y}))
                    << x << ' ' << y;
    }
}

TEST(NormalsFromDepth, FetchAsManyTexelsAsTheFrameReportCounts)
{
    const TracedPicture traced(cameraOf(false), solids);
    Buffer buffer(traced);
    for (const NormalsBy method : fromDepth) {
        int most = 0;
        for (int y = 2; y + 2 < traced.size.y; ++y)
            for (int x = 2; x + 2 < traced.size.x; ++x) {
                buffer.fetches = 0;
                (void)buffer.normal(method, {x, y});
                most = std::max(most, buffer.fetches);
            }
        EXPECT_EQ(most, fetchesOf(method)) << static_cast<int>(method);
    }
}

TEST(NormalsFromDepth, ReversedAndStandardDepthGiveTheSameNormals)
{
    const TracedPicture traced(cameraOf(false), solids);
    Buffer reversed(traced, 0, false, true), standard(traced, 0, true, true);
    for (const NormalsBy method : fromDepth) {
        int differ = 0;
        for (int y = 0; y < traced.size.y; ++y)
            for (int x = 0; x < traced.size.x; ++x)
                differ += degreesBetween(reversed.normal(method, {x, y}), standard.normal(method, {x, y})) > 1e-4;
        // If both sides of an axis are equally good, rounding decides.
        EXPECT_LT(differ, traced.size.x * traced.size.y / 200) << static_cast<int>(method);
    }
}

TEST(NormalsFromDepth, AVoteMendsBarsOfOneAndTwoTexels)
{
    const TracedPicture traced(cameraOf(true, {240, 135}), bars);
    Buffer buffer(traced);
    const Errors nine = errorsOf(buffer, NormalsBy::tap9), vote = errorsOf(buffer, NormalsBy::vote);
    EXPECT_LT(vote.mean, 0.85 * nine.mean);
    EXPECT_LT(vote.beyond20, nine.beyond20);
}

TEST(NormalsFromDepth, AtTwiceTheSizeEdgesOfBarsBendNoParabola)
{
    // Their faces are planes of two to four texels: the surface beyond an edge must not change the slope on this side.
    const TracedPicture traced(cameraOf(true, {480, 270}), bars);
    Buffer buffer(traced);
    const Errors nine = errorsOf(buffer, NormalsBy::tap9);
    EXPECT_LT(errorsOf(buffer, NormalsBy::vote).mean, nine.mean);
    EXPECT_LT(errorsOf(buffer, NormalsBy::parabola).mean, 1.01 * nine.mean);
}

TEST(NormalsFromDepth, AParabolaBendsNoMoreThanTheDepthAroundTheMiddle)
{
    // Depths along x from -2; along y all are 0.5. The center is on both lines; the horizontal one is chosen.
    const auto slopeOf = [](std::array<double, 5> depths) {
        Methods methods{[&](ivec2 p) { return p.y == 2 ? depths[static_cast<std::size_t>(p.x)] : 0.5; }};
        Methods::DepthLens lens{};
        lens.halfExtent = glm::dvec2(2.5);
        lens.farPlane = 1;
        lens.orthographic = true;
        lens.size = ivec2(5);
        const dvec3 n = methods.normalCurved(lens, {2, 2});
        return -n.x / n.z;  // Slope per texel of one meter; the depth is in meters, too.
    };
    // A smooth curve has the slope of a parabola at the center. A plane that ends at an edge has its own slope.
    // Curvature that rounding to floats could cause is ignored.
    EXPECT_NEAR(slopeOf({0.56, 0.54, 0.5, 0.44, 0.36}), -0.05, 2e-7);
    EXPECT_NEAR(slopeOf({0.3, 0.45, 0.5, 0.55, 0.59}), 0.05, 2e-7);
}

/// Returns whether the 5 tap method gives 0 if neighbors beyond the border are clamped to it, as in common code.
bool isZeroWhenClamped(Buffer& buffer, ivec2 p)
{
    const auto at = [&](ivec2 q) {
        q = glm::clamp(q, ivec2(0), buffer.picture.size - 1);
        return buffer.methods.positionAt(buffer.lens, q, buffer.methods.texelDepth(q));
    };
    const dvec3 c = at(p);
    const auto axis = [&](ivec2 step) {
        const dvec3 low = c - at(p - step), high = at(p + step) - c;
        return std::abs(low.z) < std::abs(high.z) ? low : high;
    };
    return glm::length(glm::cross(axis({1, 0}), axis({0, 1}))) < 1e-12;
}

TEST(NormalsFromDepth, AreOfUnitLengthEverywhereUpToTheBorder)
{
    for (const ivec2 size : {ivec2(1, 1), ivec2(1, 9), ivec2(9, 1), ivec2(2, 2), ivec2(3, 5), ivec2(61, 37)})
        for (const bool orthographic : {true, false}) {
            const TracedPicture traced(cameraOf(orthographic, size), solids);
            for (const bool standard : {false, true}) {
                Buffer buffer(traced, standard ? 65535 : 0, standard);
                for (const NormalsBy method : fromDepth)
                    for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x)
                            EXPECT_NEAR(glm::length(buffer.normal(method, {x, y})), 1, 1e-9);
            }
        }
    const TracedPicture traced(cameraOf(false), solids);
    Buffer buffer(traced);
    int zeros = 0;
    for (int y = 0; y < traced.size.y; ++y)
        for (int x = 0; x < traced.size.x; ++x) zeros += isZeroWhenClamped(buffer, {x, y});
    EXPECT_GT(zeros, 300);
}

TEST(NormalsFromDepth, TheSkyIsToldFromWhatIsSeenEitherWayRound)
{
    const TracedPicture traced(cameraOf(true), [](const dvec3& o, const dvec3& d) {
        std::optional<TracedHit> best;
        meetSphere(best, o, d, dvec3(0), 2);
        return best;
    });
    for (const bool standard : {false, true})
        for (const double levels : {0.0, 16777215.0, 65535.0}) {
            Buffer buffer(traced, levels, standard);
            for (int y = 0; y < traced.size.y; ++y)
                for (int x = 0; x < traced.size.x; ++x)
                    ASSERT_EQ(buffer.methods.isSky(buffer.lens, buffer.methods.texelDepth({x, y})),
                              !traced.hit({x, y}));
        }
}

TEST(SharpTexels, AreSquaresWithBordersOfOnePixel)
{
    for (const double wide : {0.07, 0.21, 0.5}) {
        double last = 0;
        for (double x = 10; x < 13; x += 0.001) {
            const double at = glsl::sharpTexel(glm::dvec2(x, 4.5), wide).x;
            EXPECT_GE(at, last);
            const double within = x - std::floor(x);
            if (within > 0.5 * wide && within < 1 - 0.5 * wide) {
                EXPECT_NEAR(at, std::floor(x) + 0.5, 1e-12);
            }
            last = at;
        }
    }
}

TEST(PixelCamera, SnappingMovesItByWholeTexels)
{
    const PixelArtTable t;
    ParameterValues values = t.initial();
    values.set(t.parallax, 0.0);
    const auto eyeAt = [&](double pan) {
        values.set(t.panX, pan);
        return pixelView(pixelCamera(t, values, {0, 0}), values[t.snap]);
    };
    const double texel = values[t.tall] / 135;
    const PixelEye start = eyeAt(0);
    const dvec3 right = glm::dvec3(glm::transpose(start.view.viewFromWorld)[0]);
    int places = 0;
    double last = 1e9;
    for (int i = 0; i <= 100; ++i) {
        const PixelEye eye = eyeAt(0.1 * i * texel);
        const double moved = glm::dot(eye.view.eye - start.view.eye, right) / texel;
        EXPECT_NEAR(moved, std::round(moved), 1e-9);
        EXPECT_NEAR(moved + static_cast<double>(eye.block.remainder.x), 0.1 * i, 1e-5);
        places += std::abs(moved - last) > 0.5;
        last = moved;
    }
    EXPECT_EQ(places, 11);
    values.set(t.snap, false);
    EXPECT_NEAR(glm::dot(eyeAt(0.3 * texel).view.eye - start.view.eye, right) / texel, 0.3, 1e-9);
}

TEST(PixelCamera, OrbitsAndTurnsByWholeSteps)
{
    const PixelArtTable t;
    ParameterValues values = t.initial();
    values.set(t.turnStep, 0.1);
    for (double aside = -0.5; aside < 0.5; aside += 0.013) {
        const PixelCamera c = pixelCamera(t, values, {aside, 0.5 * aside});
        EXPECT_NEAR(std::remainder(c.azimuth, 0.1), 0, 1e-9);
        EXPECT_NEAR(std::remainder(c.elevation, 0.1), 0, 1e-9);
        const PixelEye eye = pixelView(c, true);
        EXPECT_NEAR(glm::distance(eye.view.eye, c.target), c.distance, 0.2);
        EXPECT_NEAR(glm::determinant(glm::dmat3(eye.view.viewFromWorld)), 1, 1e-9);
    }
}

}  // namespace
}  // namespace vitrine::pixel_art
