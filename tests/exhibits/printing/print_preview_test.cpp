#include "exhibits/printing/print_plan.h"
#include "exhibits/printing/proof.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/exhibits/printing/set_up_print.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

using test::degree;

class Previews : public test::SetUpPrint {};

TEST_F(Previews, ThePreviewIsTheFileDotForDot)
{
    values_.set(table_.dotsPerInch, 300.0);
    values_.set(table_.dotsDown, 150.0);
    for (const double direction : {0.0, 90.0, -20.0}) {
        for (const bool mirror : {false, true}) {
            values_.set(table_.direction, direction * degree);
            values_.set(table_.mirror, mirror);
            const auto views = solid(5);
            const fs::path file = folder_.path() / "print.png";
            ASSERT_EQ(exportPrint(values_, views.get(), file), std::vector<fs::path>{file});
            const render::Image written = render::readImage(file, {.raw = true});
            const auto preview = printPreview(values_, views);
            ASSERT_EQ(preview->width(), written.width);
            const CodedPicture part = preview->raster({10, 5, 60, 40});
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x)
                    ASSERT_EQ(part.rgb[static_cast<std::size_t>(y * part.width + x) * 3],
                              std::lround(written.at(x + 10, y + 5) * 255))
                        << x << ' ' << y;
        }
    }
}

TEST_F(Previews, LensesAreDrawnWhereTheRasterChangesLens)
{
    // Two views, black and white: below every lens the raster changes from one to the other at the axis and back at the
    // cusp, where the grid must be a whole number.
    const auto views = std::make_shared<PrintViews>();
    views->add(render::Image(8, 8, 3, 0.0F));
    views->add(render::Image(8, 8, 3, 1.0F));
    for (const bool mirror : {false, true}) {
        values_.set(table_.mirror, mirror);
        values_.set(table_.phase, 0.3);
        const auto preview = printPreview(values_, views);
        const LensGrid grid = preview->lenses();
        const CodedPicture row = preview->raster({0, 3, preview->width(), 4});
        int edges = 0;
        for (int x = 1; x < row.width; ++x) {
            const int before = row.rgb[static_cast<std::size_t>(x - 1) * 3];
            const int after = row.rgb[static_cast<std::size_t>(x) * 3];
            if (std::abs(before - after) < 200) continue;
            // Below a lens the last view, white, is on the left, so black turns to white at a cusp.
            const double at = grid.at0 + grid.perX * x + grid.perY * 3.5;
            const bool cusp = (before < after) != mirror;
            EXPECT_LT(std::abs(at - std::round(at) - (cusp ? 0 : 0.5) * (at > std::round(at) ? 1 : -1)), 1.0 / 12) << x;
            ++edges;
        }
        EXPECT_GT(edges, 60);
    }
}

/// Returns the mean gray of a picture in linear light, without the outer eighth.
double middleLevel(const CodedPicture& picture)
{
    double sum = 0;
    int count = 0;
    for (int y = picture.height / 8; y < picture.height * 7 / 8; ++y)
        for (int x = picture.width / 8; x < picture.width * 7 / 8; ++x, ++count)
            sum += render::linearFromSrgb(picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3] / 255.0);
    return sum / count;
}

TEST_F(Previews, EveryViewIsSeenAtItsAngleInOrderAndTheZoneStartsAgain)
{
    values_.set(table_.distance, std::numeric_limits<double>::infinity());
    values_.set(table_.dotsPerInch, 1440.0);
    const int count = 6;
    for (const double direction : {0.0, 90.0, 15.0}) {
        values_.set(table_.direction, direction * degree);
        const PrintLayout layout(printSettings(values_, count));
        const auto preview = printPreview(values_, solid(count));
        for (int k = 0; k < count; ++k) {
            const double angle = angleOfView(layout, k);
            // Across the lenses: to the right for upright ones, downward for horizontal ones.
            const double slant = direction * degree;
            const double far = std::numeric_limits<double>::infinity();
            const Eye eye = direction == 90 ? preview->eyeAt(0, -angle, far)
                                            : preview->eyeAt(std::atan(std::tan(angle) * std::cos(slant)),
                                                             -std::atan(std::tan(angle) * std::sin(slant)), far);
            // Levels of neighboring views differ by 1/7; crosstalk comes from both neighbors and mostly cancels.
            EXPECT_NEAR(middleLevel(preview->seen(eye, 200)), (k + 1.0) / (count + 1), direction == 15 ? 0.06 : 0.04)
                << direction << " view " << k;
        }
    }
}

TEST_F(Previews, TheQuickLookAgreesWithTheProofOfTheFinishedFile)
{
    values_.set(table_.dotsPerInch, 600.0);
    values_.set(table_.width, 0.02);
    values_.set(table_.height, 0.015);
    const int count = 8;
    const auto views = std::make_shared<PrintViews>();
    // Each view has its own gradient, so that position and view both matter.
    for (int k = 0; k < count; ++k) {
        render::Image image(120, 90, 3);
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x)
                for (int c = 0; c < 3; ++c)
                    image.at(x, y, c) =
                        static_cast<float>((0.2 + 0.5 * x / 120 + 0.2 * y / 90) * (c == k % 3 ? 1 : 0.5));
        views->add(image);
    }
    const PrintLayout layout(printSettings(values_, count));
    const fs::path file = folder_.path() / "print.tif";
    exportPrint(values_, views.get(), file);
    const render::Image raster = render::readImage(file);
    const auto preview = printPreview(values_, views);
    for (const double angle : {-12.0, -5.0, 0.0, 3.0, 11.0, 22.0}) {
        const render::Image proof = lookThrough(layout, raster, {angle * degree, 4 * degree, 400});
        const CodedPicture quick = preview->seen(preview->eyeAt(angle * degree, 4 * degree, 400), 470);
        double difference = 0;
        for (int y = 2; y < proof.height - 2; ++y) {
            for (int x = 2; x < proof.width - 2; ++x) {
                const int u = (2 * x + 1) * quick.width / (2 * proof.width);
                const int v = (2 * y + 1) * quick.height / (2 * proof.height);
                for (int c = 0; c < 3; ++c)
                    difference += std::abs(
                        static_cast<double>(proof.at(x, y, c)) -
                        render::linearFromSrgb(
                            quick.rgb[static_cast<std::size_t>(v * quick.width + u) * 3 + static_cast<std::size_t>(c)] /
                            255.0));
            }
        }
        // 8-bit codes, 32 parts of the aperture in place of 128, 512 directions: about one percent of the light.
        EXPECT_LT(difference / (3.0 * (proof.width - 4) * (proof.height - 4)), 0.012) << angle;
    }
}

}  // namespace
}  // namespace vitrine::printing
