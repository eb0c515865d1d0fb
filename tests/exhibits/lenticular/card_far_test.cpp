// The card from far and near: no moire, no seam between both methods, and only finite values.

#include "exhibits/lenticular/card_sheet.h"
#include "exhibits/printing/interlace.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/sheet.h"
#include "render/image/image_io.h"
#include "tests/exhibits/lenticular/card_shot.h"
#include "tests/exhibits/printing/values_of.h"
#include "tests/support/write_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace vitrine {
namespace {

using lenticular::CardAxis;
using lenticular::CardModel;
using lenticular::CardSheet;
using lenticular::LenticularTable;

using namespace test;

class CardFar : public test::GlTest {
protected:
    CardViews views;
    test::TemporaryFolder folder;
};

struct Spread {
    double mean = 0, most = 0;  ///< Mean of the levels, and the largest difference from it.
};

Spread spreadOf(const std::vector<double>& levels)
{
    Spread s;
    for (const double level : levels) s.mean += level / static_cast<double>(levels.size());
    for (const double level : levels) s.most = std::max(s.most, std::abs(level - s.mean));
    return s;
}

double meanOfViews(int count)
{
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += test::solidLevel(k, count) / count;
    return sum;
}

using LongCardFar = CardFar;

TEST_F(CardFar, WhereAPixelHoldsManyFringesItShowsTheMeanOfAllViews)
{
    // A print with a pitch 10 percent off turns through all views every ten lenses; each pixel contains about forty.
    for (const int count : {2, 16}) {
        for (const CardModel model : {CardModel::linear, CardModel::paraxial, CardModel::exact}) {
            CardShot shot;
            shot.values().set(cardTable().model, model);
            shot.values().set(cardTable().pitchError, 0.1);
            shot.values().set(cardTable().sheetKind, CardSheet(9));
            shot.size(16, 8);
            shot.from(0.2, 6, 0.026);
            const Spread far = spreadOf(shot.printed(views, views.solid(count)));
            // The ratio of fringes to pixels is not a whole number, so a fraction of a fringe remains.
            EXPECT_NEAR(far.mean, meanOfViews(count), 1.0 / 255)
                << count << " views, model " << static_cast<int>(model);
            shot.values().set(cardTable().prefilter, false);
            EXPECT_GT(spreadOf(shot.printed(views, views.solid(count))).most, 0.15) << "one ray a pixel gives moire";
        }
    }
}

TEST_F(CardFar, LensesSmallerThanAPixelLeaveNoMoire)
{
    // At its distance the whole card shows the same strips, so every difference between pixels is moire. The lens is
    // out of focus: one ray per pixel hits a random point of the spot.
    for (const double pixel : {0.0007, 0.0011, 0.0033}) {
        CardShot shot;
        shot.values().set(cardTable().model, CardModel::paraxial);
        shot.values().set(cardTable().sheetKind, CardSheet::custom);
        shot.values().set(cardTable().customLpi, 20.0);
        shot.values().set(cardTable().radius, 0.0012);
        shot.values().set(cardTable().thickness, 0.0019);
        shot.values().set(cardTable().distance, 1.0);
        shot.size(64, 32);
        shot.from(0, 1, pixel);
        const Spread filtered = spreadOf(shot.printed(views, views.solid(16)));
        EXPECT_LT(filtered.most, 1.0 / 255) << pixel;
        shot.values().set(cardTable().prefilter, false);
        EXPECT_GT(spreadOf(shot.printed(views, views.solid(16))).most, 0.05) << pixel;
    }
}

TEST_F(LongCardFar, FromOneLensInAPixelToManyThePictureChangesWithoutASeam)
{
    CardShot shot;
    shot.values().set(cardTable().sheetKind, CardSheet(5));
    shot.size(33, 33);
    double before = -1;
    double largest = 0;
    // From 0.1 lenses in a pixel to one, which includes both ends of the transition between methods.
    for (double lenses = 0.1; lenses < 1.0; lenses *= 1.04) {
        shot.from(0.21, 2, lenses * 0.00127);
        shot.request.frame.camera.fovY = 2 * std::atan(0.5 * lenses * 0.00127 * 33 / 2);
        const double now = shot.printed(views, views.solid(16))[33 * 16 + 16];
        if (before >= 0) largest = std::max(largest, std::abs(now - before));
        before = now;
    }
    EXPECT_LT(largest, 0.03);
}

/// Returns noise, of two frames and four views, so that positions can be distinguished.
render::Image noise(int k, int width, int height)
{
    std::mt19937 random(static_cast<unsigned>(k + 1));
    render::Image image(width, height, 3);
    for (int y = 0; y < height; y += 8)
        for (int x = 0; x < width; x += 8) {
            const float level = static_cast<float>(random() % 1000) / 1000;
            for (int j = y; j < std::min(y + 8, height); ++j)
                for (int i = x; i < std::min(x + 8, width); ++i)
                    for (int c = 0; c < 3; ++c) image.at(i, j, c) = level;
        }
    return image;
}

TEST_F(LongCardFar, ThePrintedRasterLooksAsItsViewsDo)
{
    constexpr int count = 4;
    printing::ViewSet set;
    std::filesystem::create_directories(folder / "views");
    for (int k = 0; k < count; ++k) {
        const render::Image image = noise(k, 96, 64);
        set.add(image);
        render::writePicture(folder / ("views/view" + std::to_string(k) + ".png"), image, render::PictureFormat::png8);
    }
    for (const double direction : {0.0, 90.0}) {
        printing::PrintSettings settings;
        settings.sheet = printing::knownSheet("20-3d");
        settings.dpiX = settings.dpiY = 400;
        settings.width = 152.4;  // 120 lenses with 20 pixels each.
        settings.height = 101.6;
        settings.views = count;
        settings.direction = direction;
        const printing::PrintLayout layout(settings);
        const printing::ViewSet& made = set;
        printing::PrintFile file{folder / ("print" + std::to_string(static_cast<int>(direction)) + ".tif")};
        file.json = printing::printJson(printing::test::valuesOf(settings), layout, 400, {}).dump();
        printing::writePrint(layout, made, file);
        for (const double angle : {-0.15, 0.0, 0.08}) {
            CardShot shot;
            shot.values().set(cardTable().axis, direction == 0 ? CardAxis::vertical : CardAxis::horizontal);
            shot.values().set(cardTable().slices, direction == 0 ? 120 : 80);
            shot.size(48, 32);
            if (direction == 0)
                shot.from(angle, 5, 0.0125);
            else
                shot.from(0, 5, 0.0125, angle);
            const std::vector<double> fromViews = shot.printed(views, (folder / "views").string());
            const std::vector<double> fromPrint = shot.printed(views, file.path.string());
            double difference = 0;
            double contrast = 0;
            for (std::size_t i = 0; i < fromViews.size(); ++i) {
                if (!std::isfinite(fromViews[i]) || !std::isfinite(fromPrint[i])) continue;  // Outside of the card.
                difference += std::abs(fromViews[i] - fromPrint[i]) / static_cast<double>(fromViews.size());
                contrast += std::abs(fromViews[i] - 0.5) / static_cast<double>(fromViews.size());
            }
            EXPECT_LT(difference, 0.03) << direction << ' ' << angle;
            EXPECT_GT(contrast, 0.15);
        }
    }
}

TEST_F(CardFar, NothingIsEverNotANumber)
{
    CardShot shot;
    const LenticularTable& t = cardTable();
    shot.values().set(t.frontPrint, views.solid(3));
    shot.values().set(t.backPrint, views.solid(2));
    shot.values().set(t.specular, 1.0);
    shot.size(24, 16);
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
        ParameterValues& values = shot.values();
        for (std::size_t row = 0; row < values.rows().size(); ++row) {
            const ParameterInfo& info = values.rows()[row];
            // Permutations take seconds to build; the loop below tests the choices.
            if (info.kind != Kind::real) continue;
            const double share = static_cast<double>(random() % 5) / 4;
            values.setParameter(row, info.range.low + share * (info.range.high - info.range.low));
        }
        values.set(t.model, static_cast<CardModel>(i % 3));
        values.set(t.sheetKind, CardSheet::custom);
        values.set(t.slices, i % 4 == 0 ? 8000 : i % 4 == 1 ? 1 : 0);
        values.set(t.apertureSamples, i % 2 == 0 ? 1 : 8);
        // Edge on, from behind, from inside, from very near and very far.
        const double angle = (static_cast<double>(random() % 7) - 3) * 0.5235;
        shot.from(angle, std::array{0.004, 0.3, 3.0, 300.0}[static_cast<std::size_t>(i) % 4], 0.03,
                  i % 5 == 0 ? 1.57 : 0.1);
        EXPECT_EQ(test::notFinite(shot.take().image, 4), "") << "case " << i;
    }
}

TEST_F(CardFar, WhileItRollsOnePrintFollowsTheOther)
{
    CardShot shot;
    shot.values().set(cardTable().backPrint, views.level(0.25));
    shot.values().set(cardTable().scroll, true);
    shot.values().set(cardTable().period, 10.0);
    shot.values().set(cardTable().hold, 0.0);
    shot.size(4, 41);
    shot.from(0, 2, 0.009);
    shot.request.frame.time = 5;  // Half way.
    const std::vector<double> levels = shot.printed(views, views.level(0.75));
    // The front print moves upward. Black and white both used its slot, so below it nothing changes.
    EXPECT_NEAR(levels[41 / 4 * 4 + 1], 0.75, 0.01);
    EXPECT_FALSE(std::isfinite(levels[(41 - 41 / 4) * 4 + 1]));
    shot.request.frame.time = 10;  // The back print is at rest.
    EXPECT_FALSE(std::isfinite(shot.printed(views, views.level(0.75))[41 / 4 * 4 + 1]));
    shot.request.frame.time = 20;
    EXPECT_NEAR(shot.printed(views, views.level(0.75))[(41 - 41 / 4) * 4 + 1], 0.75, 0.01);
}

}  // namespace
}  // namespace vitrine
