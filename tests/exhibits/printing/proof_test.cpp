#include "exhibits/printing/proof.h"
#include "exhibits/printing/view_files.h"

#include "exhibits/printing/crosstalk.h"
#include "exhibits/printing/optics.h"
#include "exhibits/printing/sheet.h"
#include "render/image/image_io.h"
#include "tests/exhibits/printing/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace vitrine::printing {
namespace {

using namespace test;

/// Returns the view that the center of the print shows, as a real number.
double viewSeen(const PrintLayout& layout, const render::Image& raster, double angle)
{
    const render::Image seen = lookThrough(layout, raster, {.angle = angle}, 256);
    return static_cast<double>(seen.at(seen.width / 2, seen.height / 2)) * (layout.settings().views + 1) - 1;
}

struct Case {
    double lpi, dpi;
    int views;
    double direction;
};

class ProofSweep : public testing::TestWithParam<Case> {};

TEST_P(ProofSweep, ShowsEveryViewOnceInOrderAcrossTheZoneAndStartsAgain)
{
    const Case c = GetParam();
    for (const Method method : {Method::nearest, Method::area}) {
        PrintSettings s = settingsFor(c.lpi, c.dpi, c.views, 7.0 * c.dpi / c.lpi, 7.0 * c.dpi / c.lpi);
        s.direction = c.direction;
        s.method = method;
        const PrintLayout layout(s);
        const render::Image raster = linearImage(layout, printOf(layout, solidViews(c.views)));
        const double slant = std::abs(c.direction) < 45 ? layout.cosine() : layout.sine();
        for (int k = 0; k < c.views; ++k) {
            // Along the picture's side the angle is larger than across a slanted lens.
            const double angle = std::atan(std::tan(angleOfView(layout, k)) / slant);
            EXPECT_NEAR(viewSeen(layout, raster, angle), k, 0.5) << k << ' ' << toString(method);
        }
        // Half a view beyond either end of the zone, the views repeat.
        const auto beyond = [&](double views) {
            const double target = views / c.views * s.sheet.pitch();
            double low = 0;
            double high = 1.3;
            for (int i = 0; i < 50; ++i) {
                const double middle = (low + high) / 2;
                (aperture(s.sheet, middle).mean > -target ? low : high) = middle;
            }
            return std::atan(std::tan(low) / slant);
        };
        const double past = beyond(c.views / 2.0 + 0.5);
        EXPECT_LT(viewSeen(layout, raster, past), 0.5 * (c.views - 1)) << toString(method);
        EXPECT_GT(viewSeen(layout, raster, -past), 0.5 * (c.views - 1)) << toString(method);
    }
}

INSTANTIATE_TEST_SUITE_P(Prints, ProofSweep,
                         testing::Values(Case{40, 600, 5, 0}, Case{60.12, 1440, 6, 0}, Case{20, 300, 4, 0},
                                         Case{75, 1200, 3, 0}, Case{40, 1200, 5, 90}, Case{40, 1200, 4, 18.4},
                                         Case{30, 600, 3, -12}));

TEST(Proof, AtItsDistanceThePrintPitchShowsOneViewEverywhereAndTheLensPitchDoesNot)
{
    const int n = 6;
    PrintSettings s = settingsFor(20, 300, n, 1500, 15);  // 100 lenses.
    s.distance = 500;
    const PrintLayout fitted(s);
    PrintSettings wrong = s;
    wrong.visualLpi = 20;  // Pitch of the sheet itself.
    const PrintLayout unfitted(wrong);
    const ViewSet views = solidViews(n);
    const auto spread = [&](const PrintLayout& layout) {
        const render::Image seen = lookThrough(layout, linearImage(layout, printOf(layout, views)),
                                               {.angle = angleOfView(layout, 2), .distance = 500});
        float least = 1;
        float most = 0;
        for (int x = 3; x < seen.width - 3; ++x) {
            least = std::min(least, seen.at(x, 0));
            most = std::max(most, seen.at(x, 0));
        }
        return static_cast<double>(most - least) * (n + 1);  // Spread in views.
    };
    // The mean over the aperture differs a little from the chief ray that determines the pitch.
    EXPECT_LT(spread(fitted), 1.1);
    EXPECT_GT(spread(unfitted), 1.9);
}

TEST(Proof, APitchErrorShowsAsManyFringesAsLensesAreMissed)
{
    // 0.2 LPI off over 20 inches: 4 fringes of a black and white pair.
    ViewSet views;
    views.add(render::Image(4, 4, 3, 0.0F));
    views.add(render::Image(4, 4, 3, 1.0F));
    PrintSettings s = settingsFor(20, 300, 2, 6000, 15);
    s.visualLpi = 20.2;
    const PrintLayout layout(s);
    const render::Image seen = lookThrough(layout, linearImage(layout, printOf(layout, views)), {.angle = 0.02});
    int changes = 0;
    for (int x = 1; x < seen.width; ++x) changes += (seen.at(x, 0) > 0.5F) != (seen.at(x - 1, 0) > 0.5F);
    EXPECT_NEAR(changes, 8, 1);
}

TEST(Proof, AMirroredPrintIsSeenAsTheFrontIs)
{
    PrintSettings s = settingsFor(30, 600, 4, 200, 40);
    const ViewSet views = test::noisyViews(4, 40, 20);
    const PrintLayout front(s);
    s.mirror = true;
    const PrintLayout back(s);
    const Eye eye{.angle = 0.1, .angleAlong = 0.2};
    EXPECT_EQ(lookThrough(front, linearImage(front, printOf(front, views)), eye).pixels,
              lookThrough(back, linearImage(back, printOf(back, views)), eye).pixels);
}

/// Returns the root mean square difference over the picture, except for a lens at either side.
double distance(const render::Image& a, const render::Image& b)
{
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 1; x + 1 < a.width; ++x)
            for (int c = 0; c < 3; ++c) sum += std::pow(static_cast<double>(a.at(x, y, c) - b.at(x, y, c)), 2);
    return std::sqrt(sum / (3.0 * a.height * (a.width - 2)));
}

/// Returns the mean of `image` over each cell of a grid.
render::Image meanOver(const render::Image& image, int columns, int rows)
{
    render::Image mean(columns, rows, 3);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            for (int c = 0; c < 3; ++c) {
                double sum = 0;
                int count = 0;
                for (int v = y * image.height / rows; v < (y + 1) * image.height / rows; ++v)
                    for (int u = x * image.width / columns; u < (x + 1) * image.width / columns; ++u, ++count)
                        sum += static_cast<double>(image.at(u, v, c));
                mean.at(x, y, c) = static_cast<float>(sum / count);
            }
        }
    }
    return mean;
}

// Uses freely licensed photographs of any size; Debian has some in lomiri-wallpapers-16.04.
TEST(Proof, OfAPrintOfPhotographsShowsEachFromItsOwnSide)
{
    const std::filesystem::path folder = "/usr/share/backgrounds";
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) files = picturesIn(folder);
    std::erase_if(files, [](const std::filesystem::path& file) { return file.extension() != ".jpg"; });
    constexpr int count = 4;
    if (files.size() < count)
        GTEST_SKIP() << "there are no photographs in " << folder << "; the package lomiri-wallpapers-16.04 has some";
    constexpr int lenses = 61;  // Odd, because an axis is in the middle: the sides then have whole lenses.
    constexpr int rows = 40;
    constexpr int pixels = 30;  // Pixels per lens and row.
    const PrintLayout layout(settingsFor(20, 20 * pixels, count, lenses * pixels, rows * pixels));
    ViewSet views;
    std::vector<render::Image> photographs;  // Photographs at the resolution of the lenses.
    for (int k = 0; k < count; ++k) {
        const render::Image view = meanOver(render::readImage(files[static_cast<std::size_t>(k)]), 4 * lenses, rows);
        views.add(view);
        photographs.push_back(meanOver(view, lenses, rows));
    }
    const ViewMatrix mixing = viewMixing(layout);
    const render::Image raster = linearImage(layout, printOf(layout, views));
    for (int k = 0; k < count; ++k) {
        const render::Image seen = lookThrough(layout, raster, {.angle = angleOfView(layout, k)});
        ASSERT_EQ(seen.width, lenses);
        ASSERT_EQ(seen.height, rows);
        // Expected is the view's own photograph with the crosstalk of the sheet's optics. The model assumes that
        // neighboring lenses show the same, so up to 0.023 remains with the photographs of Debian 12. Seen half a lens
        // beside its place, a photograph differs by up to 0.076.
        render::Image expected(lenses, rows, 3, 0.0F);
        for (int other = 0; other < count; ++other)
            for (std::size_t i = 0; i < expected.pixels.size(); ++i)
                expected.pixels[i] +=
                    static_cast<float>(mixing.at(k, other)) * photographs[static_cast<std::size_t>(other)].pixels[i];
        EXPECT_LT(distance(seen, expected), 0.03) << files[static_cast<std::size_t>(k)];
        for (int other = 0; other < count; ++other)
            if (other != k) {
                EXPECT_LT(distance(seen, photographs[static_cast<std::size_t>(k)]),
                          0.5 * distance(seen, photographs[static_cast<std::size_t>(other)]))
                    << files[static_cast<std::size_t>(k)];
            }
    }
}

}  // namespace
}  // namespace vitrine::printing
