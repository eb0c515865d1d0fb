// Visitors' panoramas at the poles, where texels are dense.

#include "render/image/image_io.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <numbers>

namespace vitrine::hall {
namespace {

using namespace test;

using Panorama = GlTest;

using std::numbers::pi;
constexpr int width = 1024;
constexpr int stripe = 4;  ///< Width in columns of texels.

double columnBrightness(int column)
{
    return column / stripe % 2 == 0 ? 1 : 0;
}

/// Returns the radiance of the panorama from a direction, float64, without filtering.
double stripes(const glm::dvec3& d)
{
    const double u = std::atan2(d.x, -d.z) / (2 * pi) + 0.5;
    return columnBrightness(static_cast<int>(std::floor(u * width)) % width);
}

/// Interpolates between the two nearest columns at full resolution, like a plain lookup.
double plainLookup(const glm::dvec3& d)
{
    const double x = (std::atan2(d.x, -d.z) / (2 * pi) + 0.5) * width - 0.5;
    const double t = x - std::floor(x);
    const int column = (static_cast<int>(std::floor(x)) + width) % width;
    return columnBrightness(column) * (1 - t) + columnBrightness((column + 1) % width) * t;
}

TEST_F(Panorama, AtThePolesAPixelIsTheMeanOfAllColumnsThatItHolds)
{
    const TemporaryFolder folder;
    render::Image picture(width, width / 2, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) picture.at(x, y, c) = static_cast<float>(columnBrightness(x));
    render::writePicture(folder / "stripes.exr", picture, render::PictureFormat::exr);
    for (const double up : {1.0, -1.0}) {
        Shot shot;
        shot.hall().set(hallTable().environment, (folder / "stripes.exr").string());
        shot.request.frame.transparent = false;
        shot.size(48, 48).see({0, 3 * up, 0}, {0.02, 30 * up, 0.03});
        const Picture p = shot.take();
        double error = 0;
        double naive = 0;
        int pixels = 0;
        p.each([&](int x, int y) {
            const auto direction = [&](double dx, double dy) {
                return glm::normalize(p.view.direction({2 * (x + dx) / p.width() - 1, 1 - 2 * (y + dy) / p.height()}));
            };
            const glm::dvec3 middle = direction(0.5, 0.5);
            // A pixel with less than two dark and two bright stripes is no mean of many.
            const double columns =
                2 * p.view.tanHalfFov.y / p.height() / std::hypot(middle.x, middle.z) * width / (2 * pi);
            if (p.hit(x, y) || columns < 4 * stripe) return;
            double mean = 0;
            constexpr int side = 32;
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i)
                    mean += stripes(direction((i + 0.5) / side, (j + 0.5) / side)) / (side * side);
            error = std::max(error, std::abs(p.color(x, y).g - mean));
            naive = std::max(naive, std::abs(plainLookup(middle) - mean));
            ++pixels;
        });
        EXPECT_GT(pixels, 150);
        EXPECT_GT(naive, 0.4) << "the plain lookup is not wrong enough to be a control";
        EXPECT_LT(error, 0.12) << up;
    }
}

TEST_F(Panorama, AboveTheFirstRowLiesNotTheLastOne)
{
    // The texture repeats to hide its seam. In the vertical direction, that would bring the ground into the sky.
    const TemporaryFolder folder;
    render::Image picture(64, 32, 3);
    for (int x = 0; x < picture.width; ++x)
        for (int c = 0; c < 3; ++c) picture.at(x, picture.height - 1, c) = 100;
    render::writePicture(folder / "ground.exr", picture, render::PictureFormat::exr);
    Shot shot;
    shot.hall().set(hallTable().environment, (folder / "ground.exr").string());
    shot.request.frame.transparent = false;
    shot.size(33, 33).see({0, 3, 0}, {0, 30, 0.001});
    const Picture p = shot.take();
    p.each([&](int x, int y) {
        if (p.hit(x, y)) return;
        EXPECT_EQ(p.color(x, y).g, 0) << x << ',' << y;
    });
}

}  // namespace
}  // namespace vitrine::hall
