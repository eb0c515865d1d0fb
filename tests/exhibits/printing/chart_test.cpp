#include "exhibits/printing/chart.h"

#include "render/failure.h"
#include "tests/exhibits/printing/samples.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

namespace vitrine::printing {
namespace {

constexpr double dpi = 300;

/// Chart for upright lenses, 40 LPI, as linear light; a square with sides of `pixels` pixels.
struct Drawn {
    Drawn(ChartKind kind, int views, int pixels)
        : side(static_cast<std::size_t>(pixels)),
          chart(PrintLayout(test::settingsFor(40, dpi, views, pixels, pixels)), kind, 0.01), codes(side * side * 3)
    {
        chart.fill({0, 0, pixels, pixels}, codes.data());
    }
    [[nodiscard]] double at(std::size_t x, std::size_t y) const
    {
        return render::linearFromSrgb(codes[(y * side + x) * 3] / 65535.0);
    }
    [[nodiscard]] std::size_t middleOf(const Chart::Band& band) const
    {
        return static_cast<std::size_t>((band.from + band.to) / 2 / 25.4 * dpi);
    }
    /// Returns the mean of a row over 96 lenses of 7.5 pixels.
    [[nodiscard]] double meanOf(std::size_t row) const
    {
        double sum = 0;
        for (std::size_t x = 200; x < 920; ++x) sum += at(x, row);
        return sum / 720;
    }

    std::size_t side;
    Chart chart;
    std::vector<std::uint16_t> codes;
};

TEST(Chart, ThePitchChartsMiddleBandHasTheSheetsPitchAndHalfTheInk)
{
    for (const double direction : {0.0, 90.0}) {
        PrintSettings s = test::settingsFor(40, 300, 12, 1200, 1200);
        s.direction = direction;
        const PrintLayout layout(s);
        const Chart chart(layout, ChartKind::pitch, 0.01);
        ASSERT_EQ(chart.bands().size(), 9U);  // All that fit on 101.6 mm.
        EXPECT_NEAR(chart.bands().front().layout.printLpi(), 39.6, 1e-9);
        EXPECT_NEAR(chart.bands().at(4).layout.printLpi(), 40, 1e-9);
        EXPECT_NEAR(chart.bands().back().layout.printLpi(), 40.4, 1e-9);
        std::vector<std::uint16_t> out(1200 * 1200 * 3);
        chart.fill({0, 0, 1200, 1200}, out.data());
        for (const Chart::Band& band : chart.bands()) {
            const auto row = static_cast<std::size_t>((band.from + band.to) / 2 / 25.4 * 300);
            double sum = 0;
            for (std::size_t x = 150; x < 1050; ++x) {
                const std::size_t at = direction == 0 ? row * 1200 + x : x * 1200 + row;
                sum += render::linearFromSrgb(out[at * 3] / 65535.0);
            }
            EXPECT_NEAR(sum / 900, 0.5, 0.01) << band.label;
        }
    }
}

TEST(Chart, IsTheSameHoweverItIsCut)
{
    const PrintLayout layout(test::settingsFor(40, 300, 6, 700, 700));
    for (const ChartKind kind : {ChartKind::phase, ChartKind::views, ChartKind::rotation}) {
        const Chart chart(layout, kind, 0.01);
        std::vector<std::uint8_t> whole(700 * 700 * 3);
        chart.fill({0, 0, 700, 700}, whole.data());
        std::vector<std::uint8_t> part(100 * 50 * 3);
        chart.fill({300, 200, 400, 250}, part.data());
        for (std::size_t y = 0; y < 50; ++y)
            ASSERT_TRUE(std::equal(part.begin() + static_cast<std::ptrdiff_t>(y * 300),
                                   part.begin() + static_cast<std::ptrdiff_t>((y + 1) * 300),
                                   whole.begin() + static_cast<std::ptrdiff_t>(((200 + y) * 700 + 300) * 3)));
    }
}

TEST(Chart, ThePhaseChartsBandsAreOneLensApartInEqualSteps)
{
    const Drawn drawn(ChartKind::phase, 12, 1200);
    const std::size_t count = drawn.chart.bands().size();
    ASSERT_GE(count, 8U);
    // First harmonic of a row at lens pitch: the position of the white half below its lenses.
    const auto harmonic = [&](const Chart::Band& band) {
        std::complex<double> sum = 0;
        for (std::size_t x = 200; x < 920; ++x)
            sum += drawn.at(x, drawn.middleOf(band)) *
                   std::polar(1.0, -2 * std::numbers::pi * (static_cast<double>(x) + 0.5) / 7.5);
        return sum / 720.0;
    };
    const std::complex<double> first = harmonic(drawn.chart.bands().front());
    for (std::size_t i = 0; i < count; ++i) {
        const Chart::Band& band = drawn.chart.bands()[i];
        const std::complex<double> turned = harmonic(band) / first;
        const double expected = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        EXPECT_NEAR(std::abs(turned - std::polar(1.0, expected)), 0, 0.02) << band.label;
        EXPECT_EQ(band.label.rfind(
                      "PHASE " + std::to_string(static_cast<double>(i) / static_cast<double>(count)).substr(0, 6), 0),
                  0U)
            << band.label;
        // Half of every lens: a square wave has a first harmonic of 1 / pi, reduced by the width of a pixel to sinc(1 /
        // 7.5) of it.
        EXPECT_NEAR(std::abs(harmonic(band)),
                    std::sin(std::numbers::pi / 7.5) / (std::numbers::pi / 7.5) / std::numbers::pi, 0.005)
            << band.label;
    }
}

TEST(Chart, TheViewsChartHasOneWhiteViewOfMoreAndMore)
{
    const Drawn drawn(ChartKind::views, 8, 1200);
    ASSERT_EQ(drawn.chart.bands().size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) {
        const Chart::Band& band = drawn.chart.bands()[i];
        const double views = static_cast<double>(i + 2);
        EXPECT_EQ(band.label, std::to_string(i + 2) + " VIEWS");
        EXPECT_NEAR(drawn.meanOf(drawn.middleOf(band)), 1 / views, 0.005) << band.label;
        EXPECT_EQ(std::count(band.views.begin(), band.views.end(), 1.0), 1) << band.label;
    }
}

TEST(Chart, TheRotationChartHasOneBlackViewOverItsWholeHeight)
{
    const Drawn drawn(ChartKind::rotation, 6, 1200);
    ASSERT_EQ(drawn.chart.bands().size(), 1U);
    const auto top = static_cast<std::size_t>(drawn.chart.bands().front().from / 25.4 * dpi) + 2;
    const auto bottom = static_cast<std::size_t>(drawn.chart.bands().front().to / 25.4 * dpi) - 2;
    EXPECT_GT(bottom - top, 900U);
    for (const std::size_t row : {top, (top + bottom) / 2, bottom}) {
        EXPECT_NEAR(drawn.meanOf(row), 1 - 1.0 / 6, 0.005) << row;
        for (std::size_t x = 200; x < 920; ++x)
            ASSERT_EQ(drawn.at(x, row), drawn.at(x, top)) << "lenses that run straight up show the same everywhere";
    }
}

TEST(Chart, HasARulerInMillimetersAlongBothSides)
{
    const Drawn drawn(ChartKind::phase, 6, 1200);
    const double millimeter = dpi / 25.4;
    // Two millimeters from the edge are all ticks, at 3.5 those of 5 and 10, at 4.5 those of 10 only.
    for (const bool across : {true, false}) {
        for (const auto& [depth, step] : {std::pair{2.0, 1}, {3.5, 5}, {4.5, 10}}) {
            std::vector<double> ticks;  // Center of each tick.
            const auto line = static_cast<std::size_t>(depth * millimeter);
            std::size_t start = 0;
            for (std::size_t i = 110; i < 1070; ++i) {  // From 9.3 to 90.6 mm, because the ruler's zero is at 10.
                const bool ink = (across ? drawn.at(i, line) : drawn.at(line, i)) < 0.5;
                if (ink && start == 0) start = i;
                if (!ink && start > 0) {
                    ticks.push_back(static_cast<double>(start + i) / 2 / millimeter - 10);
                    start = 0;
                }
            }
            ASSERT_EQ(ticks.size(), static_cast<std::size_t>(80 / step + 1)) << depth;
            for (std::size_t i = 0; i < ticks.size(); ++i)
                // Within half a pixel.
                EXPECT_NEAR(ticks[i], static_cast<double>(i) * step, 0.5 / millimeter) << depth;
        }
    }
}

TEST(Chart, RefusesAPrintThatIsTooSmall)
{
    const PrintLayout layout(test::settingsFor(40, 300, 6, 300, 300));
    EXPECT_THROW(Chart(layout, ChartKind::pitch, 0.01), Failure);
    EXPECT_THROW(Chart(PrintLayout(test::settingsFor(40, 300, 6, 700, 700)), ChartKind::pitch, -1), Failure);
}

}  // namespace
}  // namespace vitrine::printing
