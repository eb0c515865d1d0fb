#include "exhibits/printing/crosstalk.h"

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/proof.h"
#include "tests/exhibits/printing/samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine::printing {
namespace {

using namespace test;

TEST(CrossTalk, EveryRowOfTheMixingSumsToOneAndItsOwnViewIsLargest)
{
    for (const int n : {1, 2, 5, 12}) {
        for (const double ink : {0.0, 0.03}) {
            PrintSettings s = settingsFor(40, 1200, n, 300, 10);
            s.inkSpread = ink;
            s.reverse = n == 5;
            s.phase = n == 2 ? 0.3 : 0;
            const ViewMatrix m = viewMixing(PrintLayout(s));
            for (int i = 0; i < n; ++i) {
                double sum = 0;
                for (int k = 0; k < n; ++k) {
                    sum += m.at(i, k);
                    EXPECT_GE(m.at(i, k), 0);
                    EXPECT_LE(m.at(i, k), m.at(i, i)) << n << ' ' << i << ' ' << k;
                }
                EXPECT_NEAR(sum, 1, 1e-12);
            }
        }
    }
}

TEST(CrossTalk, TheMixingIsWhatTheSimulatedSheetShowsOfTheRaster)
{
    const int n = 6;
    const PrintLayout layout(settingsFor(40, 1200, n, 270, 60));
    const ViewMatrix mixing = viewMixing(layout);
    for (int k = 0; k < n; ++k) {
        ViewSet views;
        for (int i = 0; i < n; ++i) views.add(render::Image(4, 4, 3, i == k ? 1.0F : 0.0F));
        const render::Image raster = linearImage(layout, printOf(layout, views));
        for (int i = 0; i < n; ++i) {
            const render::Image seen = lookThrough(layout, raster, {.angle = angleOfView(layout, i)}, 256);
            EXPECT_NEAR(static_cast<double>(seen.at(seen.width / 2, seen.height / 2)), mixing.at(i, k), 0.02)
                << i << ' ' << k;
        }
    }
}

TEST(CrossTalk, MoreInkMixesMore)
{
    PrintSettings s = settingsFor(60, 1200, 8, 300, 10);
    double before = 1;
    for (const double ink : {0.0, 0.01, 0.02, 0.04}) {
        s.inkSpread = ink;
        const double own = viewMixing(PrintLayout(s)).at(3, 3);
        EXPECT_LT(own, before);
        before = own;
    }
}

TEST(CrossTalk, CompensationUndoesTheMixingAsItsWeightVanishes)
{
    const ViewMatrix mixing = viewMixing(PrintLayout(settingsFor(40, 1200, 7, 300, 10)));
    const ViewMatrix inverse = compensation(mixing, 1e-12);
    for (int i = 0; i < 7; ++i) {
        for (int k = 0; k < 7; ++k) {
            double sum = 0;
            for (int j = 0; j < 7; ++j) sum += mixing.at(i, j) * inverse.at(j, k);
            EXPECT_NEAR(sum, i == k ? 1 : 0, 1e-6);
        }
    }
    const ViewMatrix none = compensation(mixing, 1e12);
    for (int i = 0; i < 7; ++i) {
        double sum = 0;
        for (int k = 0; k < 7; ++k) {
            EXPECT_NEAR(none.at(i, k), i == k ? 1 : 0, 1e-9);
            sum += compensation(mixing).at(i, k);
        }
        EXPECT_NEAR(sum, 1, 1e-9);  // Gray stays gray.
    }
}

TEST(CrossTalk, CompensatedViewsLookMoreLikeThemselvesThroughTheSheet)
{
    const int n = 8;
    PrintSettings s = settingsFor(40.15, 600, n, 600, 60);
    ViewSet views;
    std::vector<double> levels;
    for (int k = 0; k < n; ++k) {
        levels.push_back(k % 2 == 0 ? 0.35 : 0.6);  // Neighbors differ as much as mid tones can.
        views.add(render::Image(4, 4, 3, static_cast<float>(levels.back())));
    }
    const auto error = [&](bool compensate) {
        s.compensate = compensate;
        const PrintLayout layout(s);
        const render::Image raster = linearImage(layout, printOf(layout, views));
        double sum = 0;
        for (int k = 0; k < n; ++k) {
            const render::Image seen = lookThrough(layout, raster, {.angle = angleOfView(layout, k)}, 256);
            // Pixels have different positions below every lens, so their mean is used.
            double mean = 0;
            for (int x = 3; x < seen.width - 3; ++x)
                mean += static_cast<double>(seen.at(x, seen.height / 2)) / (seen.width - 6);
            sum += std::pow(mean - levels[static_cast<std::size_t>(k)], 2);
        }
        return std::sqrt(sum / n);
    };
    const double before = error(false);
    const double after = error(true);
    EXPECT_LT(after, 0.5 * before);
    const PrintLayout layout(s);
    const ViewMatrix mixing = viewMixing(layout);
    const CrossTalk told = crossTalkOf(views, mixing, compensation(mixing));
    EXPECT_NEAR(told.before, before, 0.15 * before);
    EXPECT_NEAR(told.after, after, 0.15 * before);
}

TEST(CrossTalk, CompensationLeavesGrayAlone)
{
    ViewSet views;
    for (int k = 0; k < 6; ++k)
        views.add(render::Image(20, 31, 3, static_cast<float>(render::linearFromSrgb(77 / 255.0))));
    for (const double direction : {0.0, 20.0}) {
        PrintSettings s = settingsFor(40.15, 600, 6, 150, 90);
        s.direction = direction;
        s.compensate = true;
        for (const std::uint8_t code : printOf(PrintLayout(s), views)) ASSERT_EQ(code, 77);
    }
}

TEST(Dither, CodesThatEightBitsHaveStayAndOthersKeepTheirMean)
{
    const Region region{1000, 3000, 1064, 3064};
    std::vector<std::uint16_t> fine(64 * 64 * 3);
    std::vector<std::uint8_t> coarse(fine.size());
    for (int code = 0; code < 256; ++code) {
        std::fill(fine.begin(), fine.end(), static_cast<std::uint16_t>(code * 257));
        ditherRows(region, fine.data(), coarse.data());
        for (const std::uint8_t x : coarse) ASSERT_EQ(x, code);
    }
    for (const int value : {100, 12345, 32767, 50000, 65400}) {
        std::fill(fine.begin(), fine.end(), static_cast<std::uint16_t>(value));
        ditherRows(region, fine.data(), coarse.data());
        double sum = 0;
        for (const std::uint8_t x : coarse) {
            sum += x;
            ASSERT_LT(std::abs(x - value / 257.0), 1);
        }
        EXPECT_NEAR(sum / static_cast<double>(coarse.size()), value / 257.0, 0.02);
        EXPECT_GT(std::abs(std::round(value / 257.0) - value / 257.0), 0.02);  // Rounding would have this error.
    }
}

TEST(Dither, DependsOnThePlaceOnlySoThatTilesAndThreadsAgree)
{
    const ViewSet views = noisyViews(5, 61, 47);
    for (const double direction : {0.0, 12.3}) {
        PrintSettings s = settingsFor(40.15, 600, 5, 203, 180);
        s.direction = direction;
        s.dither = true;
        s.compensate = true;
        s.border = 0.7;
        const PrintLayout layout(s);
        const std::vector<std::uint8_t> whole = printOf(layout, views);
        EXPECT_EQ(printOf(layout, views, 3), whole);
        const Interlacer maker(layout, views);
        const auto width = static_cast<std::size_t>(layout.width());
        for (std::int64_t y = 0; y < layout.height(); y += 37) {
            for (std::int64_t x = 0; x < layout.width(); x += 50) {
                const Region tile{x, y, std::min(x + 50, layout.width()), std::min(y + 37, layout.height())};
                const auto tileWidth = static_cast<std::size_t>(tile.x1 - tile.x0) * 3;
                std::vector<std::uint8_t> part(tileWidth * static_cast<std::size_t>(tile.y1 - tile.y0));
                maker.fill(tile, part.data());
                for (std::size_t row = 0; row * tileWidth < part.size(); ++row) {
                    const auto from = part.begin() + static_cast<std::ptrdiff_t>(row * tileWidth);
                    ASSERT_TRUE(std::equal(
                        from, from + static_cast<std::ptrdiff_t>(tileWidth),
                        whole.begin() +
                            static_cast<std::ptrdiff_t>(
                                ((static_cast<std::size_t>(y) + row) * width + static_cast<std::size_t>(x)) * 3)));
                }
            }
        }
    }
}

TEST(Border, IsWhiteAndMovesNothing)
{
    const ViewSet views = noisyViews(4, 50, 30);
    for (const double direction : {0.0, 30.0, 90.0}) {
        PrintSettings s = settingsFor(37, 600, 4, 211, 120);
        s.direction = direction;
        s.mirror = direction == 30.0;
        const PrintLayout bare(s);
        const std::vector<std::uint8_t> inside = printOf(bare, views);
        s.border = 1;
        const PrintLayout layout(s);
        EXPECT_EQ(layout.borderX(), 24);
        ASSERT_EQ(layout.width(), bare.width() + 48);
        ASSERT_EQ(layout.height(), bare.height() + 48);
        const std::vector<std::uint8_t> whole = printOf(layout, views);
        for (std::int64_t y = 0; y < layout.height(); ++y) {
            for (std::int64_t x = 0; x < layout.width(); ++x) {
                const std::int64_t ix = x - 24;
                const std::int64_t iy = y - 24;
                const bool within = ix >= 0 && iy >= 0 && ix < bare.width() && iy < bare.height();
                const int expected = within ? inside[static_cast<std::size_t>(iy * bare.width() + ix) * 3] : 255;
                ASSERT_EQ(whole[static_cast<std::size_t>(y * layout.width() + x) * 3], expected) << x << ' ' << y;
            }
        }
    }
}

}  // namespace
}  // namespace vitrine::printing
