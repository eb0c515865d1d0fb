#include "tests/exhibits/printing/samples.h"

#include "exhibits/printing/print_numbers.h"
#include "exhibits/printing/view_weights.h"
#include "render/failure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace vitrine::printing {
namespace {

using namespace test;

constexpr std::array<Method, 3> methods{Method::nearest, Method::area, Method::guard};

/// Returns the views in the first row, identified by solid colors.
std::vector<int> viewsOfRow(const PrintLayout& layout)
{
    std::vector<int> row;
    std::vector<ViewWeight> taps;
    for (std::int64_t x = 0; x < layout.width(); ++x) {
        viewWeightsAt(layout, static_cast<double>(x) + 0.5, 0.5, taps);
        row.push_back(taps.size() == 1 ? taps[0].view : -1);
    }
    return row;
}

TEST(Lenticular, WeightsOfEveryPixelSumToOne)
{
    std::vector<ViewWeight> taps;
    std::mt19937 random(3);
    for (int i = 0; i < 400; ++i) {
        const double dpi = 300 + static_cast<double>(random() % 2400);
        PrintSettings s =
            settingsFor(10 + static_cast<double>(random() % 140), dpi, 1 + static_cast<int>(random() % 40), 5000, 5000);
        s.direction = i % 3 == 0 ? 0 : i % 3 == 1 ? 90 : static_cast<double>(random() % 180) - 90 + 0.37;
        if (s.direction > 90) s.direction = 90;
        s.phase = static_cast<double>(random() % 1000) / 500 - 1;
        s.method = methods.at(static_cast<std::size_t>(i) % 3);
        s.guard = static_cast<double>(random() % 100) / 100;
        const PrintLayout layout(s);
        for (int at = 0; at < 50; ++at) {
            viewWeightsAt(layout, static_cast<double>(random() % 5000) + 0.5,
                          static_cast<double>(random() % 5000) + 0.5, taps);
            double sum = 0;
            for (const ViewWeight& tap : taps) {
                sum += tap.weight;
                ASSERT_GE(tap.view, 0);
                ASSERT_LT(tap.view, s.views);
            }
            ASSERT_NEAR(sum, 1, 1e-12);
        }
    }
}

TEST(Lenticular, EveryViewCoversTheSameShareOfTheLenses)
{
    // 6000 columns at 600 dpi and 40 LPI are exactly 400 lenses.
    for (const double phase : {0.0, 0.31}) {
        PrintSettings s = settingsFor(40, 600, 7, 6000, 1);
        s.phase = phase;
        const PrintLayout layout(s);
        std::map<int, double> covered;
        std::vector<ViewWeight> taps;
        for (int x = 0; x < 6000; ++x) {
            viewWeightsAt(layout, x + 0.5, 0.5, taps);
            for (const ViewWeight& tap : taps) covered[tap.view] += tap.weight;
        }
        for (const auto& [view, columns] : covered) EXPECT_NEAR(columns / 400, 15.0 / 7, 1e-9) << view;
    }
}

TEST(Lenticular, TheFirstViewLiesOnTheRight)
{
    const auto row = [](int views, double phase, bool reverse) {
        PrintSettings s = settingsFor(100, 600, views, 6, 1);
        s.method = Method::nearest;
        s.phase = phase;
        s.reverse = reverse;
        return viewsOfRow(PrintLayout(s));
    };
    EXPECT_EQ(row(2, 0, false), (std::vector<int>{1, 1, 1, 0, 0, 0}));
    EXPECT_EQ(row(3, 0, false), (std::vector<int>{2, 2, 1, 1, 0, 0}));
    EXPECT_EQ(row(2, 0.5, false), (std::vector<int>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(row(3, 1, false), row(3, 0, false));
    EXPECT_EQ(row(3, 0, true), (std::vector<int>{0, 0, 1, 1, 2, 2}));
}

TEST(Lenticular, TheLastColumnIsWhereTheClosedFormSays)
{
    PrintSettings s = settingsFor(60.12, 1440, 12, 200000, 200000);
    s.method = Method::nearest;
    const PrintLayout layout(s);  // 4e10 pixels, for which no memory is allocated.
    ASSERT_EQ(layout.width(), 200000);
    std::vector<ViewWeight> taps;
    for (const std::int64_t x : {std::int64_t{0}, std::int64_t{99999}, std::int64_t{199999}}) {
        viewWeightsAt(layout, static_cast<double>(x) + 0.5, 199999.5, taps);
        const long double u = (static_cast<long double>(x) + 0.5L - 100000.0L) * 60.12L / 1440.0L + 0.5L;
        EXPECT_EQ(taps.at(0).lens, static_cast<std::int64_t>(std::floor(u)));
        EXPECT_NEAR(static_cast<double>(static_cast<long double>(layout.lensAt(static_cast<double>(x) + 0.5, 0)) - u),
                    0, 1e-9);
    }
}

TEST(Lenticular, StripsTilesAndThreadsGiveTheSameBits)
{
    const ViewSet views = noisyViews(5, 61, 47);
    for (const double direction : {0.0, 90.0, 12.3, -70.0})
        for (const Method method : methods)
            for (const double rows : {40.0, 180.0}) {  // Fewer and more rows than the views have.
                PrintSettings s = settingsFor(40.15, 600, 5, 203, rows);
                s.direction = direction;
                s.method = method;
                s.mirror = method == Method::guard;
                const PrintLayout layout(s);
                const std::vector<std::uint8_t> whole = printOf(layout, views);
                EXPECT_EQ(printOf(layout, views, 3), whole);
                const Interlacer maker(layout, views);
                for (std::int64_t y = 0; y < layout.height(); y += 13)
                    for (std::int64_t x = 0; x < layout.width(); x += 50) {
                        const Region tile{x, y, std::min(x + 50, layout.width()), std::min(y + 13, layout.height())};
                        const auto tileWidth = static_cast<std::size_t>(tile.x1 - tile.x0);
                        std::vector<std::uint8_t> part(tileWidth * static_cast<std::size_t>(tile.y1 - tile.y0) * 3);
                        maker.fill(tile, part.data());
                        for (std::int64_t row = tile.y0; row < tile.y1; ++row) {
                            const std::uint8_t* from =
                                part.data() + static_cast<std::size_t>(row - tile.y0) * tileWidth * 3;
                            const std::uint8_t* to =
                                whole.data() + static_cast<std::size_t>(row * layout.width() + x) * 3;
                            ASSERT_TRUE(std::equal(from, from + tileWidth * 3, to))
                                << direction << ' ' << toString(method) << ' ' << x << ' ' << row;
                        }
                    }
            }
}

TEST(Lenticular, GrayStaysGray)
{
    ViewSet views;
    for (int k = 0; k < 6; ++k)
        views.add(render::Image(20 + k, 31, 3, static_cast<float>(render::linearFromSrgb(77 / 255.0))));
    for (const double direction : {0.0, 90.0, 20.0, -33.3})
        for (const Method method : methods)
            for (const double lpi : {33.3, 60.12}) {
                PrintSettings s = settingsFor(lpi, 600, 6, 150, 90);
                s.direction = direction;
                s.method = method;
                s.phase = 0.123;
                for (const std::uint8_t code : printOf(PrintLayout(s), views)) ASSERT_EQ(code, 77);
            }
}

TEST(Lenticular, HalfBlackHalfWhiteIs188)
{
    // One pixel contains the center of the lens, where black and white meet.
    ViewSet views;
    views.add(render::Image(4, 4, 3, 0.0F));
    views.add(render::Image(4, 4, 3, 1.0F));
    PrintSettings s = settingsFor(100, 500, 2, 5, 4);
    const PrintLayout layout(s);
    EXPECT_EQ(printOf(layout, views)[2 * 3], 188);
}

TEST(Lenticular, MirroredIsTheRowTurnedRound)
{
    const ViewSet views = noisyViews(4, 50, 20);
    PrintSettings s = settingsFor(37, 600, 4, 211, 20);
    const std::vector<std::uint8_t> front = printOf(PrintLayout(s), views);
    s.mirror = true;
    const std::vector<std::uint8_t> back = printOf(PrintLayout(s), views);
    for (std::size_t y = 0; y < 20; ++y)
        for (std::size_t x = 0; x < 211; ++x) ASSERT_EQ(front[(y * 211 + x) * 3], back[(y * 211 + 210 - x) * 3]);
}

TEST(Lenticular, SixteenBitsAgreeWithEight)
{
    const ViewSet views = noisyViews(4, 50, 20);
    const PrintLayout layout(settingsFor(37, 600, 4, 211, 60));
    const std::vector<std::uint8_t> eight = printOf(layout, views);
    std::vector<std::uint16_t> sixteen(eight.size());
    Interlacer(layout, views).fill({0, 0, layout.width(), layout.height()}, sixteen.data(), 2);
    for (std::size_t i = 0; i < eight.size(); ++i) ASSERT_NEAR(eight[i], sixteen[i] / 257.0, 0.9);
}

TEST(Lenticular, APlainLoopInDoubleGivesTheSamePrint)
{
    // Interpolated rows, a box over one lens, and area weights, in an independent implementation.
    const int n = 4;
    const ViewSet views = noisyViews(n, 120, 30);
    const PrintLayout layout(settingsFor(30, 400, n, 300, 90));
    const std::vector<std::uint8_t> fast = printOf(layout, views);
    for (std::int64_t y = 0; y < 90; ++y)
        for (std::int64_t x = 0; x < 300; x += 3) {
            const double a = layout.lensAt(static_cast<double>(x), 0) * n;
            const double b = layout.lensAt(static_cast<double>(x + 1), 0) * n;
            double sum = 0;
            for (double strip = std::floor(a); strip < b; ++strip) {
                const double weight = (std::min(b, strip + 1) - std::max(a, strip)) / (b - a);
                const double lens = std::floor(strip / n);
                const int k = n - 1 - static_cast<int>(strip - lens * n);
                const int width = views.view(k).width;
                const double scale = width / 300.0;
                const double from = std::clamp(((lens - 0.5) / layout.lensesPerPixelX() + 150) * scale, 0.0,
                                               static_cast<double>(width));
                const double to = std::clamp(((lens + 0.5) / layout.lensesPerPixelX() + 150) * scale, 0.0,
                                             static_cast<double>(width));
                const double at = std::clamp((static_cast<double>(y) + 0.5) / 3 - 0.5, 0.0, 29.0);
                const int top = std::min(static_cast<int>(at), 28);
                for (int i = 0; i < width; ++i) {
                    const double part =
                        std::max(0.0, std::min<double>(to, i + 1) - std::max<double>(from, i)) / (to - from);
                    if (part <= 0) continue;
                    const auto column = static_cast<std::size_t>(i) * 3;
                    sum += weight * part *
                           ((1 - (at - top)) * views.row(k, top)[column] + (at - top) * views.row(k, top + 1)[column]);
                }
            }
            const int expected = render::srgb8FromLinear(static_cast<float>(sum / 65535));
            ASSERT_NEAR(fast[static_cast<std::size_t>(y * 300 + x) * 3], expected, 1) << x << ' ' << y;
        }
}

std::string refusal(const PrintSettings& settings)
{
    try {
        const PrintLayout layout(settings);
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::usage);
        return failure.what();
    }
    return {};
}

TEST(Lenticular, RefusesWhatCannotBePrinted)
{
    const PrintSettings good = settingsFor(60, 600, 8, 100, 100);
    EXPECT_EQ(refusal(good), "");
    const auto with = [&](auto change) {
        PrintSettings s = good;
        change(s);
        return refusal(s);
    };
    const double nan = std::nan("");
    EXPECT_NE(with([](auto& s) { s.views = 0; }).find("no views"), std::string::npos);
    EXPECT_NE(with([](auto& s) { s.views = 257; }).find("256"), std::string::npos);
    for (const double bad : {0.0, -5.0, nan, HUGE_VAL}) {
        EXPECT_NE(with([&](auto& s) { s.dpiX = bad; }), "");
        EXPECT_NE(with([&](auto& s) { s.width = bad; }), "");
        EXPECT_NE(with([&](auto& s) { s.height = bad; }), "");
    }
    EXPECT_NE(with([](auto& s) { s.dpiX = 60; }).find("one pixel for a lens"), std::string::npos);
    EXPECT_NE(with([](auto& s) { s.distance = 0.1; }).find("distance"), std::string::npos);
    EXPECT_NE(with([&](auto& s) { s.distance = nan; }).find("distance"), std::string::npos);
    EXPECT_NE(with([](auto& s) { s.bleed = -1; }).find("bleed"), std::string::npos);
    EXPECT_NE(with([](auto& s) { s.width = 1e9; }).find("2147483647"), std::string::npos);
    EXPECT_NE(with([](auto& s) { s.direction = 91; }).find("direction"), std::string::npos);
    EXPECT_NE(with([&](auto& s) { s.phase = nan; }).find("phase"), std::string::npos);
    EXPECT_EQ(with([](auto& s) { s.width = 0.05; }), "");  // One pixel.
}

TEST(Lenticular, WarnsOfWhatWillDisappoint)
{
    EXPECT_TRUE(warningsOf(PrintLayout(settingsFor(40, 600, 12, 100, 100))).empty());
    EXPECT_EQ(warningsOf(PrintLayout(settingsFor(40, 600, 16, 100, 100))).size(), 1U);
    EXPECT_EQ(warningsOf(PrintLayout(settingsFor(400, 600, 16, 100, 100))).size(), 1U);
    // PNG stores whole pixels per meter: 28346 of them are 719.988 to the inch, and 12 views still fit under a lens.
    const PrintLayout stored(settingsFor(60, 28346 * 0.0254, 12, 100, 100));
    EXPECT_TRUE(warningsOf(stored).empty());
    EXPECT_EQ(numbersOf(stored, 720).effectiveViews, 12);
    EXPECT_EQ(warningsOf(PrintLayout(settingsFor(60, 719, 12, 100, 100))).size(), 1U);
}

}  // namespace
}  // namespace vitrine::printing
