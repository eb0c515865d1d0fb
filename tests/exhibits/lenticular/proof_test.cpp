#include "exhibits/lenticular/proof.h"

#include "exhibits/lenticular/numbers.h"
#include "exhibits/lenticular/optics.h"
#include "tests/exhibits/lenticular/samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::lenticular {
namespace {

using test::linearImage;
using test::printOf;
using test::settingsFor;
using test::solidViews;

/// The view that the middle of the print shows, as a real number.
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
        // Half a view beyond the zone on either side, the views start again.
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
                         testing::Values(Case{40, 600, 5, 0}, Case{60.12, 1440, 6, 0}, Case{20, 300, 4, 0}, Case{75, 1200, 3, 0}, Case{40, 1200, 5, 90},
                                         Case{40, 1200, 4, 18.4}, Case{30, 600, 3, -12}));

TEST(Proof, AtItsDistanceThePrintPitchShowsOneViewEverywhereAndTheLensPitchDoesNot)
{
    const int n = 6;
    PrintSettings s = settingsFor(20, 300, n, 1500, 15);  // 100 lenses.
    s.distance = 500;
    const PrintLayout fitted(s);
    PrintSettings wrong = s;
    wrong.visualLpi = 20;  // The sheet's own pitch.
    const PrintLayout unfitted(wrong);
    const ViewSet views = solidViews(n);
    const auto spread = [&](const PrintLayout& layout) {
        const render::Image seen = lookThrough(layout, linearImage(layout, printOf(layout, views)), {.angle = angleOfView(layout, 2), .distance = 500});
        float least = 1;
        float most = 0;
        for (int x = 3; x < seen.width - 3; ++x) {
            least = std::min(least, seen.at(x, 0));
            most = std::max(most, seen.at(x, 0));
        }
        return static_cast<double>(most - least) * (n + 1);  // In views.
    };
    // The aperture's mean departs a little from the chief ray for which the pitch is made.
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
    EXPECT_EQ(lookThrough(front, linearImage(front, printOf(front, views)), eye).pixels, lookThrough(back, linearImage(back, printOf(back, views)), eye).pixels);
}

}  // namespace
}  // namespace vitrine::lenticular
