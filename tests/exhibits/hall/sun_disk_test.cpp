// Penumbras of the sun's disk, compared with the mean of many hard shadows of suns on that disk.

#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::hall {
namespace {

using namespace test;

class SunDisk : public test::GlTest {};

constexpr double elevation = 0.3316;
constexpr double azimuth = -0.0524;
constexpr double sunWidth = 0.05;  ///< Radians: five times the sun's width, so that penumbras are half a meter wide.

/// Returns a shot of the floor at the right edge of the window's light, ten meters from the edge that casts it.
Shot floorShot(ShadowFilter filter)
{
    Shot shot;
    shot.inHall();
    shot.request.frame.channels.normal = false;
    shot.see({1.7, 3, -2}, {1.7, 0, -2.3});
    shot.request.frame.camera.fovY = 0.5;
    shot.size(48, 27);
    shot.hall().set(hallTable().reflectionProbe, false);
    shot.hall().set(hallTable().bakedLight, false);
    shot.hall().set(hallTable().shadowMapSize, 2048);
    shot.hall().set(hallTable().sunElevation, elevation);
    shot.hall().set(hallTable().sunAzimuth, azimuth);
    shot.hall().set(hallTable().shadowFilter, filter);
    shot.hall().set(hallTable().sunDisk, sunWidth);
    shot.hall().set(hallTable().diskSamples, 64);
    return shot;
}

/// Draws the mean over suns distributed evenly over the disk, each with a hard shadow.
Picture drawnAreaLight()
{
    Shot shot = floorShot(ShadowFilter::hard);
    constexpr int suns = 48;
    Picture mean = shot.take();
    for (float& value : mean.image.pixels) value = 0;
    for (int i = 0; i < suns; ++i) {
        const double radius = 0.5 * sunWidth * std::sqrt((i + 0.5) / suns);
        const double angle = 2.39996323 * i;
        shot.hall().set(hallTable().sunElevation, elevation + radius * std::sin(angle));
        shot.hall().set(hallTable().sunAzimuth, azimuth + radius * std::cos(angle) / std::cos(elevation));
        const Picture one = shot.take();
        for (std::size_t p = 0; p < mean.image.pixels.size(); ++p) mean.image.pixels[p] += one.image.pixels[p] / suns;
    }
    return mean;
}

const Picture& areaLight()
{
    static const Picture drawn = drawnAreaLight();
    return drawn;
}

using LongSunDisk = SunDisk;

TEST_F(LongSunDisk, MakesTheHalfShadowOfAnAreaLight)
{
    const Picture& truth = areaLight();
    const Picture disk = floorShot(ShadowFilter::disk).take();
    const Picture tent = floorShot(ShadowFilter::tent5).take();
    double brightest = 0;
    double darkest = 1e9;
    int between = 0;
    truth.each([&](int x, int y) {
        brightest = std::max(brightest, truth.luminance(x, y));
        darkest = std::min(darkest, truth.luminance(x, y));
    });
    truth.each([&](int x, int y) {
        const double share = (truth.luminance(x, y) - darkest) / (brightest - darkest);
        between += share > 0.1 && share < 0.9;
    });
    ASSERT_GT(brightest, 1.5 * darkest);
    ASSERT_GT(between, 48 * 27 / 10);
    const double wrong = test::colorDifference(disk, truth) / (brightest - darkest);
    EXPECT_LT(wrong, 0.06);
    EXPECT_LT(wrong, 0.4 * test::colorDifference(tent, truth) / (brightest - darkest));
}

TEST_F(LongSunDisk, OfFewComparisonsBecomesTheAreaLightAsThePictureRefines)
{
    const Picture& truth = areaLight();
    const auto wrong = [&](int comparisons, int samples) {
        Shot shot = floorShot(ShadowFilter::disk);
        shot.hall().set(hallTable().diskSamples, comparisons);
        shot.request.samples = samples;
        return test::colorDifference(shot.take(), truth);
    };
    const double many = wrong(64, 1);
    // Every sample uses other points of the disk. Together they equal many points, without the bias of few.
    EXPECT_LT(wrong(8, 16), 1.25 * many);
    EXPECT_GT(wrong(8, 1), 1.25 * many);
}

TEST_F(SunDisk, IsTheSameInTilesAndEveryTime)
{
    Shot shot = floorShot(ShadowFilter::disk);
    shot.hall().set(hallTable().diskSamples, 8);
    const Picture once = shot.take();
    EXPECT_EQ(test::largestDifference(once.image, shot.take().image), 0);
    shot.request.largestTile = 24;
    const Picture tiled = shot.take();
    int different = 0;
    once.each([&](int x, int y) {
        different += std::abs(once.luminance(x, y) - tiled.luminance(x, y)) > 0.02 * once.luminance(x, y);
    });
    // Positions are rounded in each tile's own clip space; the noise stays the same.
    EXPECT_LE(different, 48 * 27 / 50);
}

TEST_F(SunDisk, OfAPointIsTheHardShadow)
{
    Shot point = floorShot(ShadowFilter::disk);
    point.hall().set(hallTable().sunDisk, 0.0001);
    const Picture narrow = point.take();
    const Picture hard = floorShot(ShadowFilter::hard).take();
    int different = 0;
    narrow.each([&](int x, int y) {
        different += std::abs(narrow.luminance(x, y) - hard.luminance(x, y)) > 0.1 * hard.luminance(x, y);
    });
    // Along the edge, a filter of one and a half texels remains.
    EXPECT_LT(different, 48 * 27 / 12);
}

}  // namespace
}  // namespace vitrine::hall
