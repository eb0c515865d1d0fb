#include "exhibits/printing/view_rig.h"

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/quilt.h"
#include "exhibits/printing/view_files.h"

#include "tests/exhibits/printing/samples.h"
#include "tests/support/failures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vitrine::printing {
namespace {

using vitrine::test::refusalOf;

const render::Camera middle{{0.3, 1.6, 2.5}, {0.1, 1.4, 0.2}, 0.7};
const glm::ivec2 size(900, 600);

/// Returns settings with a sheet in focus, 3 mm thick, with space for `views` views at 1200 dpi.
PrintSettings cardSettings(int views, double lpi = 40)
{
    PrintSettings s;
    s.sheet = {"test", lpi, 0, 3.0 * 0.56 / 1.56, 3.0, 1.56, 0};
    s.dpiX = s.dpiY = 1200;
    s.width = 150;
    s.height = 100;
    s.views = views;
    return s;
}

glm::dvec3 forwardOf(const render::Camera& camera)
{
    return glm::normalize(camera.target - camera.eye);
}

/// Returns the point at `distance` along the view axis of the middle camera, shifted by parts of the picture.
glm::dvec3 pointAt(double distance, double x = 0, double y = 0)
{
    return middle.eye + render::makeView(middle, {.size = size}).direction({x, y}) * distance;
}

/// Returns a position in pixels from the lower left corner.
glm::dvec2 pixelOf(const render::Camera& camera, const glm::dvec3& point)
{
    const glm::dvec4 clip = render::makeView(camera, {.size = size}).clipFromWorld * glm::dvec4(point, 1);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size);
}

TEST(ViewRig, CamerasStandAtEqualDistancesFromLeftToRightAndLookTheSameWay)
{
    const ViewRig rig(PrintLayout(cardSettings(9)), middle, size);
    EXPECT_EQ(rig.count(), 9);
    EXPECT_LT(glm::length(rig.camera(4).eye - middle.eye), 1e-12);
    const glm::dvec3 right = glm::normalize(glm::cross(forwardOf(middle), glm::dvec3(0, 1, 0)));
    for (int k = 0; k + 1 < 9; ++k) {
        const glm::dvec3 step = rig.camera(k + 1).eye - rig.camera(k).eye;
        EXPECT_LT(glm::length(step - right * (rig.baseline() / 8)), 1e-12) << k;
        EXPECT_LT(glm::length(forwardOf(rig.camera(k)) - forwardOf(middle)), 1e-12) << k;
    }
}

TEST(ViewRig, TheBaselineOfThe20LpiSheetAtOneMeterIs58Centimeters)
{
    // B = C p / (t - r) (N - 1) / N, for 3.2 mm of index 1.56 in focus: 1.27 / (3.2 / 1.56) * 15 / 16.
    PrintSettings s = cardSettings(16, 20);
    s.sheet.thickness = 3.2;
    s.sheet.radius = 3.2 * 0.56 / 1.56;
    EXPECT_NEAR(ViewRig(PrintLayout(s), middle, size, {1, 1}).baseline(), 0.58042, 1e-5);
    EXPECT_NEAR(ViewRig(PrintLayout(s), middle, size, {0.25, 3}).baseline(), 0.58042 * 0.75, 1e-5);
    EXPECT_EQ(ViewRig(PrintLayout(s), middle, size, {0, 1}).baseline(), 0);
    EXPECT_LT(glm::length(ViewRig(PrintLayout(s), middle, size, {0, 1}).camera(3).eye - middle.eye), 1e-12);
}

TEST(ViewRig, TheConvergencePlaneStaysOnItsPixelsWhereToedInCamerasKeystone)
{
    const ViewRig rig(PrintLayout(cardSettings(16)), middle, size, {1, 1.8});
    double worstToedIn = 0;
    for (int k = 0; k < 16; ++k) {
        for (const double x : {-0.9, 0.0, 0.8}) {
            for (const double y : {-0.9, 0.1, 0.9}) {
                const glm::dvec3 point = pointAt(1.8, x, y);
                EXPECT_LT(glm::length(pixelOf(rig.camera(k), point) - pixelOf(middle, point)), 1e-6);
                render::Camera toedIn{rig.camera(k).eye, pointAt(1.8), middle.fovY};
                worstToedIn = std::max(worstToedIn, glm::length(pixelOf(toedIn, point) - pixelOf(middle, point)));
            }
        }
    }
    EXPECT_GT(worstToedIn, 10);
}

TEST(ViewRig, WhatLiesBehindMovesWithTheEyeAndWhatLiesBeforeAgainstItInEqualSteps)
{
    const ViewRig rig(PrintLayout(cardSettings(16)), middle, size, {1, 1.8});
    for (const double distance : {0.9, 1.5, 2.5, 40.0}) {
        const glm::dvec3 point = pointAt(distance, 0.2, -0.3);
        const double first = pixelOf(rig.camera(1), point).x - pixelOf(rig.camera(0), point).x;
        EXPECT_GT(first * (distance - 1.8), 0) << distance;
        for (int k = 1; k + 1 < 16; ++k) {
            const glm::dvec2 step = pixelOf(rig.camera(k + 1), point) - pixelOf(rig.camera(k), point);
            EXPECT_NEAR(step.x, first, 1e-6);
            EXPECT_NEAR(step.y, 0, 1e-6);
        }
    }
}

TEST(ViewRig, DepthNearThePlaneIsAsDeepAsThePictureIsWide)
{
    // An eye at angle theta sees a point z behind the print shifted by z tan(theta) on it. Farther away, the rig's
    // perspective reduces the shift by C / (C + Z).
    const PrintLayout layout(cardSettings(16));
    const ViewRig rig(layout, middle, size, {1, 1.8});
    const double lever = 3.0 / 1.56;
    for (const double z : {0.01, -0.01, 10.0, -10.0}) {  // Millimeters of the print.
        const glm::dvec3 point = pointAt(1.8 + z * rig.scale());
        for (const int k : {0, 5, 15}) {
            const double tangent = ((k + 0.5) / 16 - 0.5) * layout.printPitch() / lever;
            const double onPrint = (pixelOf(rig.camera(k), point).x - pixelOf(middle, point).x) / size.x * 150;
            EXPECT_NEAR(onPrint, z * tangent * 1.8 / (1.8 + z * rig.scale()), 1e-9);
        }
    }
}

TEST(ViewRig, AtTheEndsOfTheBudgetNeighborsDifferByExactlyOneLens)
{
    for (const double strength : {0.3, 0.1, 0.02}) {
        const PrintLayout layout(cardSettings(12));
        const ViewRig rig(layout, middle, size, {strength, 1.8});
        const DepthRange budget = rig.budget();
        const auto lenses = [&](double distance) {
            const glm::dvec3 point = pointAt(distance);
            return (pixelOf(rig.camera(7), point).x - pixelOf(rig.camera(6), point).x) / size.x * 150 /
                   layout.printPitch();
        };
        EXPECT_NEAR(lenses(budget.nearest), -1, 1e-9) << strength;
        if (std::isinf(budget.farthest)) {
            EXPECT_LT(lenses(1e9), 1) << strength;
        } else {
            EXPECT_NEAR(lenses(budget.farthest), 1, 1e-9) << strength;
        }
    }
}

TEST(ViewRig, OnALargePrintTheBudgetIsWeissmans2NTOverN)
{
    PrintSettings s = cardSettings(12);
    s.width = 3000;
    s.height = 2000;
    const ViewRig rig(PrintLayout(s), middle, size, {1, 1.8});
    const DepthRange budget = rig.budget();
    const double onPrint = (budget.farthest - budget.nearest) / rig.scale();
    EXPECT_NEAR(onPrint / (2 * 12 * 3.0 / 1.56), 1, 1e-3);
    // Views beyond the print's resolution add nothing: 1200 dpi has 30 pixels per lens.
    s.views = 60;
    const DepthRange many = ViewRig(PrintLayout(s), middle, size, {1, 1.8}).budget();
    EXPECT_NEAR((many.farthest - many.nearest) / rig.scale() / (2 * 30 * 3.0 / 1.56), 1, 3e-3);
}

TEST(ViewRig, NamesTheStrengthThatHoldsTheScene)
{
    const PrintLayout layout(cardSettings(12));
    const double infinity = std::numeric_limits<double>::infinity();
    for (const DepthRange scene : {DepthRange{1.2, 2.0}, DepthRange{1.7, 14}, DepthRange{1.0, infinity}}) {
        const double strength = ViewRig(layout, middle, size, {1, 1.8}).strengthThatHolds(scene);
        const ViewRig fitting(layout, middle, size, {strength, 1.8});
        EXPECT_LE(fitting.budget().nearest, scene.nearest);
        EXPECT_GE(fitting.budget().farthest, scene.farthest);
        EXPECT_TRUE(warningsOf(fitting, scene).empty());
        const ViewRig wider(layout, middle, size, {strength * 1.01, 1.8});
        EXPECT_TRUE(wider.budget().nearest > scene.nearest || wider.budget().farthest < scene.farthest);
        ASSERT_EQ(warningsOf(wider, scene).size(), 1U);
    }
    const std::string warning = warningsOf(ViewRig(layout, middle, size, {1, 1.8}), {1.0, infinity}).at(0);
    for (const char* part : {"from 1 m to the horizon", "without doubled contours", "A baseline scale of 0."})
        EXPECT_NE(warning.find(part), std::string::npos) << warning;
    EXPECT_TRUE(warningsOf(ViewRig(layout, middle, size, {0, 1.8}), {0.1, infinity}).empty());
    EXPECT_TRUE(std::isinf(ViewRig(layout, middle, size, {1, 1.8}).strengthThatHolds({1.8, 1.8})));
}

TEST(ViewRig, ForHorizontalLensesTheLineIsVerticalAndStartsAtTheTop)
{
    PrintSettings s = cardSettings(8);
    s.direction = 90;
    const ViewRig rig(PrintLayout(s), middle, size, {1, 1.8});
    EXPECT_GT(rig.camera(0).eye.y, rig.camera(7).eye.y);
    EXPECT_NEAR(rig.camera(0).lensShift.x, 0, 1e-15);
    EXPECT_LT(rig.camera(0).lensShift.y, 0);  // From above, the picture's center is below the axis.
    const glm::dvec3 point = pointAt(1.8, 0.5, 0.5);
    EXPECT_LT(glm::length(pixelOf(rig.camera(0), point) - pixelOf(middle, point)), 1e-6);
    s.direction = -80;  // Strips are numbered in the opposite order.
    EXPECT_LT(ViewRig(PrintLayout(s), middle, size, {1, 1.8}).camera(0).eye.y, middle.eye.y);
}

TEST(ViewRig, OnSlantedLensesTheCamerasStayOnTheLevelAndStandFartherApart)
{
    PrintSettings s = cardSettings(8);
    const double upright = ViewRig(PrintLayout(s), middle, size).baseline();
    s.direction = 20;
    const ViewRig slanted(PrintLayout(s), middle, size);
    EXPECT_NEAR(slanted.baseline() / upright, 1 / std::cos(20 * 3.14159265358979 / 180), 1e-12);
    EXPECT_NEAR(slanted.camera(0).eye.y, middle.eye.y, 1e-12);
    s.direction = -20;
    EXPECT_NEAR(ViewRig(PrintLayout(s), middle, size).baseline(), slanted.baseline(), 1e-12);
}

TEST(ViewRig, RefusesWhatCannotBe)
{
    const PrintLayout layout(cardSettings(8));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refusal = [&](const RigSettings& settings) {
        return refusalOf([&] { return ViewRig(layout, middle, size, settings); });
    };
    EXPECT_NE(refusal({-1, 1}).find("-1"), std::string::npos);
    EXPECT_NE(refusal({nan, 1}), "");
    EXPECT_NE(refusal({1, -2}).find("in front of the camera"), std::string::npos);
    EXPECT_NE(refusal({1, 0.01}), "");
    EXPECT_NE(refusal({1, nan}), "");
    EXPECT_NE(refusal({1, std::numeric_limits<double>::infinity()}), "");
    render::Camera nowhere = middle;
    nowhere.target = nowhere.eye;
    EXPECT_NE(refusalOf([&] { return ViewRig(layout, nowhere, size); }), "");
    PrintSettings thin = cardSettings(8, 20);
    thin.sheet.radius = 0.7;
    thin.sheet.thickness = 0.65;
    EXPECT_NE(refusalOf([&] { return ViewRig(PrintLayout(thin), middle, size); }).find("thicker"), std::string::npos);
}

TEST(DepthRange, LeavesOutTheStrayPixelsAndKnowsTheHorizon)
{
    render::Image image(100, 10, 5);
    image.channelNames = {"R", "G", "B", "A", "depth.Z"};
    for (int i = 0; i < 1000; ++i) image.at(i % 100, i / 100, 4) = 1.0F + static_cast<float>((i * 7) % 1000) / 1000.0F;
    image.at(3, 3, 4) = 0.01F;
    image.at(50, 5, 4) = std::numeric_limits<float>::infinity();
    EXPECT_NEAR(depthRange(image).nearest, 1.005, 0.002);
    EXPECT_NEAR(depthRange(image).farthest, 1.995, 0.002);
    EXPECT_NEAR(depthRange(image, 1).nearest, 0.01, 1e-6);
    EXPECT_TRUE(std::isinf(depthRange(image, 1).farthest));
    EXPECT_THROW((void)depthRange(render::Image(2, 2, 4)), std::out_of_range);
}

TEST(Quilt, HasItsGridInItsName)
{
    using printing::QuiltGrid;
    EXPECT_EQ(printing::quiltPath("a/cat.png", {8, 6, 0.75}), "a/cat_qs8x6a0.75.png");
    EXPECT_EQ(printing::quiltPath("cat_qs5x9a1.77.jpg", {11, 6, 0.56249}), "cat_qs11x6a0.5625.jpg");
    EXPECT_EQ(printing::quiltNamed("a/cat_qs8x6a0.75.png"), (QuiltGrid{8, 6, 0.75}));
    EXPECT_EQ(printing::quiltNamed("my_qs_cat_qs5x9a1.77777.mp4"), (QuiltGrid{5, 9, 1.77777}));
    EXPECT_EQ(printing::quiltNamed("cat_qs3x2a.5.png"), (QuiltGrid{3, 2, 0.5}));
    for (const char* none : {"cat.png", "cat_qs8x6.png", "cat_qs0x6a1.png", "cat_qs8x6a0.png", "cat_qs9999x6a1.png",
                             "cat_qs8x6a0.75_small.png", "cat_qs8x6a1e9.png"})
        EXPECT_EQ(printing::quiltNamed(none), std::nullopt) << none;

    // A quilt that is chosen brings its grid; another name leaves the grid.
    const printing::PrintTable& table = printing::printTable();
    ParameterValues values = table.initial();
    values.set(table.origin, printing::ViewOrigin::quilt);
    values = printing::withPictures(std::move(values), {"cat_qs5x9a1.77.png"});
    EXPECT_EQ(values[table.quiltColumns], 5);
    EXPECT_EQ(values[table.quiltRows], 9);
    values = printing::withPictures(std::move(values), {"cat.png"});
    EXPECT_EQ(values[table.quiltColumns], 5);
}

TEST(Quilt, HasItsFirstViewAtTheBottomLeftAsItIsReadBack)
{
    render::Image quilt(6, 6, 3);
    const printing::QuiltGrid grid{2, 3, 1.5};
    for (int k = 0; k < grid.count(); ++k)
        printing::placeInQuilt(quilt, render::Image(3, 2, 3, static_cast<float>(k)), grid, k);
    EXPECT_EQ(quilt.at(0, 5, 0), 0);
    EXPECT_EQ(quilt.at(5, 5, 0), 1);
    EXPECT_EQ(quilt.at(0, 0, 0), 4);
    for (int k = 0; k < grid.count(); ++k)
        EXPECT_EQ(printing::viewOfQuilt(quilt, 2, 3, k).pixels, render::Image(3, 2, 3, static_cast<float>(k)).pixels);
}

TEST(Quilt, TheCamerasSeeTheirTargetOnTheSamePixel)
{
    render::Camera center;
    center.eye = {1, 2, 5};
    center.target = {0, 1, 0};
    const double cone = 0.7;
    constexpr int count = 5;
    double last = -1;
    for (int k = 0; k < count; ++k) {
        const render::Camera camera = printing::quiltCamera(center, k, count, cone);
        const auto at = [&](const glm::dvec3& p) {
            const glm::dvec4 clip = render::makeView(camera, {{640, 480}}).clipFromWorld * glm::dvec4(p, 1);
            return glm::dvec2(clip) / clip.w;
        };
        EXPECT_LT(glm::length(at(center.target)), 1e-9) << k;
        // Directions from the target are evenly spaced. View 0 is seen from the left.
        const glm::dvec3 to = glm::normalize(camera.eye - center.target);
        const glm::dvec3 ahead = glm::normalize(center.eye - center.target);
        EXPECT_NEAR(std::acos(std::min(glm::dot(to, ahead), 1.0)), std::abs(k - 2) * cone / 4, 1e-6) << k;
        const double right = glm::dot(camera.eye, glm::cross(glm::dvec3(0, 1, 0), ahead));
        if (k > 0) {
            EXPECT_GT(right, last);
        }
        last = right;
        // A point nearer than the target moves against the camera.
        if (k != 2) {
            EXPECT_LT(at(center.target + ahead).x * (k - 2), 0);
        }
    }
    EXPECT_EQ(printing::quiltCamera(center, 0, 1, cone), center);
}

}  // namespace
}  // namespace vitrine::printing
