#include "exhibits/lenticular/chart.h"

#include "render/failure.h"
#include "tests/exhibits/lenticular/samples.h"

#include <gtest/gtest.h>

namespace vitrine::lenticular {
namespace {

TEST(Chart, ThePitchChartsMiddleBandHasTheSheetsPitchAndHalfTheInk)
{
    for (const double direction : {0.0, 90.0}) {
        PrintSettings s = test::settingsFor(40, 300, 12, 1200, 1200);
        s.direction = direction;
        const PrintLayout layout(s);
        const Chart chart(layout, ChartKind::pitch, 0.01);
        ASSERT_EQ(chart.bands().size(), 9U);  // What fits on 101.6 mm.
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
            ASSERT_TRUE(std::equal(part.begin() + static_cast<std::ptrdiff_t>(y * 300), part.begin() + static_cast<std::ptrdiff_t>((y + 1) * 300),
                                   whole.begin() + static_cast<std::ptrdiff_t>(((200 + y) * 700 + 300) * 3)));
    }
}

TEST(Chart, RefusesAPrintThatIsTooSmall)
{
    const PrintLayout layout(test::settingsFor(40, 300, 6, 300, 300));
    EXPECT_THROW(Chart(layout, ChartKind::pitch, 0.01), Failure);
    EXPECT_THROW(Chart(PrintLayout(test::settingsFor(40, 300, 6, 700, 700)), ChartKind::pitch, -1), Failure);
}

}  // namespace
}  // namespace vitrine::lenticular
