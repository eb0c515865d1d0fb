// Errors of a print as they appear through its sheet: the number of fringes is known in closed form.

#include "exhibits/printing/optics.h"
#include "exhibits/printing/proof.h"
#include "exhibits/printing/sheet.h"
#include "tests/exhibits/printing/samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::printing {
namespace {

using namespace test;

ViewSet blackAndWhite()
{
    ViewSet views;
    views.add(render::Image(4, 4, 3, 0.0F));
    views.add(render::Image(4, 4, 3, 1.0F));
    return views;
}

/// Returns the strongest frequency in a line of samples, in periods over the whole line.
double strongest(const std::vector<double>& line)
{
    double mean = 0;
    for (const double x : line) mean += x / static_cast<double>(line.size());
    double best = 0;
    double most = -1;
    for (double frequency = 0.5; frequency < 20; frequency += 0.05) {
        double re = 0;
        double im = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double angle =
                2 * 3.14159265358979 * frequency * (static_cast<double>(i) + 0.5) / static_cast<double>(line.size());
            re += (line[i] - mean) * std::cos(angle);
            im += (line[i] - mean) * std::sin(angle);
        }
        if (re * re + im * im > most) {
            most = re * re + im * im;
            best = frequency;
        }
    }
    return best;
}

int changes(const std::vector<double>& line)
{
    int count = 0;
    for (std::size_t i = 1; i < line.size(); ++i) count += (line[i] > 0.5) != (line[i - 1] > 0.5);
    return count;
}

std::vector<double> parameterOf(const render::Image& seen, int y)
{
    std::vector<double> line;
    for (int x = 0; x < seen.width; ++x) line.push_back(static_cast<double>(seen.at(x, y)));
    return line;
}

TEST(Fringes, APitchErrorShowsLengthTimesErrorOfThem)
{
    for (const double error : {-0.3, 0.2, 0.45}) {
        PrintSettings s = settingsFor(20, 300, 2, 6000, 15);  // 20 inches.
        s.visualLpi = 20 + error;
        const PrintLayout layout(s);
        const render::Image seen =
            lookThrough(layout, linearImage(layout, printOf(layout, blackAndWhite())), {.angle = 0.02});
        EXPECT_NEAR(strongest(parameterOf(seen, 0)), std::abs(error) * 20, 0.15) << error;
    }
}

TEST(Fringes, ARotationShowsHeightTimesTangentOverPitchOfThemAndNoneWithoutIt)
{
    const PrintSettings straight = settingsFor(20, 300, 2, 75, 2400);  // 8 inches high.
    const PrintLayout sheet(straight);
    const double height = 8 * 25.4;
    for (const double fringes : {2.0, 3.5, 6.0}) {
        const double delta = std::atan(fringes * straight.sheet.pitch() / height);
        PrintSettings turned = straight;
        turned.direction = delta / radiansPerDegree;
        const PrintLayout print(turned);
        const render::Image seen =
            lookThrough(sheet, linearImage(print, printOf(print, blackAndWhite())), {.angle = 0.05});
        std::vector<double> line;
        for (int y = 0; y < seen.height; ++y) line.push_back(static_cast<double>(seen.at(seen.width / 2, y)));
        EXPECT_NEAR(strongest(line), fringes, 0.2);
        EXPECT_NEAR(changes(line), 2 * fringes, 1);
    }
    const render::Image seen = lookThrough(sheet, linearImage(sheet, printOf(sheet, blackAndWhite())), {.angle = 0.05});
    for (int y = 1; y < seen.height; ++y) EXPECT_EQ(seen.at(seen.width / 2, y), seen.at(seen.width / 2, 0));
}

TEST(Fringes, TheSheetsOwnPitchShowsThemFromNearAndThePrintPitchDoesNot)
{
    // A narrow zone, so that the eye passes several zones between the edges: L |1/p - 1/p'|.
    PrintSettings s = settingsFor(20, 600, 2, 3000, 30);
    s.sheet = derivedSheet("narrow", 20, 20);
    s.distance = 127 / 2 / std::tan(18 * radiansPerDegree);
    const auto seenWith = [&](double visualLpi) {
        PrintSettings own = s;
        own.visualLpi = visualLpi;
        // Straight ahead, a quarter of a lens from the border between strips.
        own.phase = 0.25;
        const PrintLayout shifted(own);
        std::vector<double> line = parameterOf(
            lookThrough(shifted, linearImage(shifted, printOf(shifted, blackAndWhite())), {.distance = s.distance}), 0);
        // At the edges the paper beside the print is visible.
        return std::vector<double>(line.begin() + 3, line.end() - 3);
    };
    const double pitch = s.sheet.pitch();
    const double fringes = 127 * std::abs(1 / pitch - 1 / printPitch(s.sheet, s.distance));
    ASSERT_GT(fringes, 1.5);
    EXPECT_NEAR(changes(seenWith(s.sheet.lpi())), 2 * fringes, 1);
    EXPECT_EQ(changes(seenWith(0)), 0);
}

struct Sweep {
    double lpi, dpi;
    int views;
    double direction;
    Method method;
};
class AngleSweep : public testing::TestWithParam<Sweep> {};

TEST_P(AngleSweep, ShowsViewsZeroToLastOnceEachInOrderAndWrapsOnBothSides)
{
    const Sweep c = GetParam();
    PrintSettings s = settingsFor(c.lpi, c.dpi, c.views, 7.0 * c.dpi / c.lpi, 7.0 * c.dpi / c.lpi);
    s.direction = c.direction;
    s.method = c.method;
    const PrintLayout layout(s);
    std::vector<render::Image> rasters;  // In each raster only one view is white.
    for (int k = 0; k < c.views; ++k) {
        ViewSet views;
        for (int i = 0; i < c.views; ++i) views.add(render::Image(4, 4, 3, i == k ? 1.0F : 0.0F));
        rasters.push_back(linearImage(layout, printOf(layout, views)));
    }
    const double slant = std::abs(c.direction) < 45 ? layout.cosine() : layout.sine();
    const int steps = 12 * c.views;
    std::vector<int> order;
    for (int step = 0; step <= steps; ++step) {
        // From the middle of the view before the zone to the middle of the one behind it.
        const double strips = (static_cast<double>(step) / steps - 0.5) * (c.views + 1);
        double low = -1.4;
        double high = 1.4;
        for (int i = 0; i < 40; ++i) {
            const double middle = (low + high) / 2;
            (aperture(s.sheet, middle).mean > -strips / c.views * s.sheet.pitch() ? low : high) = middle;
        }
        const Eye eye{.angle = std::atan(std::tan(low) / slant)};
        int best = -1;
        float most = -1;
        for (int k = 0; k < c.views; ++k) {
            const render::Image seen = lookThrough(layout, rasters[static_cast<std::size_t>(k)], eye, 64);
            const float share = seen.at(seen.width / 2, seen.height / 2);
            if (share > most) {
                most = share;
                best = k;
            }
        }
        if (order.empty() || order.back() != best) order.push_back(best);
    }
    std::vector<int> expected{c.views - 1};
    for (int k = 0; k < c.views; ++k) expected.push_back(k);
    expected.push_back(0);
    EXPECT_EQ(order, expected);
}

INSTANTIATE_TEST_SUITE_P(Prints, AngleSweep,
                         testing::Values(Sweep{40, 600, 5, 0, Method::area}, Sweep{40.15, 600, 7, 0, Method::nearest},
                                         Sweep{60.12, 1440, 6, 0, Method::area}, Sweep{20, 300, 8, 0, Method::area},
                                         Sweep{75, 1200, 4, 90, Method::area}, Sweep{30, 720, 5, 18.4, Method::area},
                                         Sweep{30, 720, 4, -26.6, Method::nearest},
                                         Sweep{40, 1200, 6, 45, Method::guard}));

}  // namespace
}  // namespace vitrine::printing
