// The divider of the two halves, which is dragged in the picture.

#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/pixel_art/pixel_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vitrine::pixel_art {
namespace {

TEST(PixelDivider, LiesUnderThePointerToHalfATexel)
{
    const PixelArt exhibit;
    const PixelArtTable& t = exhibit.parameters();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 300; ++i) {
        ParameterValues values = t.initial();
        values.set(t.split, true);
        values.set(t.snap, i % 3 != 0);
        values.set(t.resolution, static_cast<PixelResolution>(i % 6));
        values.set(t.panX, 2 * any(random));
        const glm::dvec3 eye(2 * any(random), any(random), 1.5 + any(random));
        const glm::dvec3 wanted(1.1 * any(random), 0.6 * any(random), -0.545);
        const ExhibitState state{values};
        const double value = exhibit.valueUnder(state, t.divider.row, {eye, glm::normalize(wanted - eye)});
        const double columns = value * sizeOf(values[t.resolution]).x;
        EXPECT_NEAR(columns, std::round(columns), 1e-9);
        values.set(t.divider, value);
        const std::vector<DraggedLine> lines = exhibit.draggedLines(state, eye);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].row, t.divider.row);
        const double texel = 2.24 / sizeOf(values[t.resolution]).x;
        EXPECT_LE(std::abs(lines[0].from.x - wanted.x), 0.5 * texel + 1e-9) << i;
        EXPECT_EQ(lines[0].from.x, lines[0].to.x);
    }
}

TEST(PixelDivider, IsThereOnlyBetweenTwoHalves)
{
    const PixelArt exhibit;
    ParameterValues values = exhibit.parameters().initial();
    EXPECT_TRUE(exhibit.draggedLines({values}, {0, 0, 2}).empty());
    values.set(exhibit.parameters().split, true);
    EXPECT_EQ(exhibit.draggedLines({values}, {0, 0, 2}).size(), 1U);
    // Far beyond the edges it stays at them.
    const auto under = [&](double x) {
        return exhibit.valueUnder({values}, 0, {{0, 0, 2}, glm::normalize(glm::dvec3(x, 0, -2.545))});
    };
    EXPECT_EQ(under(-5), 0);
    EXPECT_EQ(under(5), 1);
    EXPECT_EQ(under(0), 0.5);
}

}  // namespace
}  // namespace vitrine::pixel_art
