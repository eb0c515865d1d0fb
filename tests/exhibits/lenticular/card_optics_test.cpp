// Views that the simulated card shows in each direction: the shader compared with optics at float64.

#include "exhibits/lenticular/card_sheet.h"
#include "exhibits/printing/optics.h"
#include "tests/exhibits/lenticular/card_shot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

using lenticular::CardAxis;
using lenticular::CardEyes;
using lenticular::CardModel;
using lenticular::CardSheet;
using lenticular::LenticularTable;
using printing::Sheet;
using namespace test;

constexpr double half = std::numbers::pi / 2;
constexpr int middle = 12 * 25 + 12;  ///< Center of the 25 x 25 pixels.
constexpr double decoding = 0.002;    ///< llvmpipe decodes sRGB with a polynomial whose error is up to 0.0012.

class CardOptics : public test::GlTest {
protected:
    CardViews views;

    double seen(CardShot& shot, int count) { return shot.printed(views, views.solid(count))[middle]; }
};

/// Returns the gray of strips with solid views if a lens shows the print between `from` and `to`, in pitches.
double grayBetween(double from, double to, int count)
{
    const double low = std::min(from, to) + 0.5;
    const double high = std::max(std::max(from, to) + 0.5, low + 1e-12);
    double sum = 0;
    for (double strip = std::floor(low * count); strip < high * count; ++strip) {
        const double share = std::min(high, (strip + 1) / count) - std::max(low, strip / count);
        const int s = static_cast<int>(strip - count * std::floor(strip / count));
        sum += std::max(share, 0.0) * test::solidLevel(count - 1 - s, count);
    }
    return sum / (high - low);
}

/// Returns the same for a whole lens, with the table's model in double precision.
double expectedGray(const CardShot& shot, const Sheet& sheet, double theta, int count, double beta = 0)
{
    const ParameterValues& values = shot.sceneState.values[shot.exhibit];
    const LenticularTable& t = cardTable();
    const double m = values[t.magnification];
    if (values[t.model] == CardModel::linear) {
        const double at = -0.5 * std::tan(theta) / std::tan(values[t.intendedMaxAngle]);
        return grayBetween(at - 0.5 * m / count, at + 0.5 * m / count, count);
    }
    if (values[t.model] == CardModel::paraxial) {
        const double p = sheet.pitch();
        return grayBetween(m * printing::paraxial(sheet, -p / 2, 0) / p + printing::paraxial(sheet, 0, theta) / p,
                           m * printing::paraxial(sheet, p / 2, 0) / p + printing::paraxial(sheet, 0, theta) / p,
                           count);
    }
    const double at = (sheet.radius - sheet.thickness) * std::tan(theta);
    double sum = 0;
    for (const auto& part : printing::aperture(sheet, theta, beta, 1024).parts)
        sum += part.share * grayBetween((at + m * (part.from - at)) / sheet.pitch(),
                                        (at + m * (part.to - at)) / sheet.pitch(), count);
    return sum;
}

using LongCardOptics = CardOptics;

TEST_F(LongCardOptics, TheLinearAndTheParaxialModelShowEveryViewOnceInOrderAndStartAgain)
{
    for (const CardModel model : {CardModel::linear, CardModel::paraxial}) {
        for (const int count : {1, 2, 3, 16, 100}) {
            CardShot shot;
            shot.values().set(cardTable().model, model);
            if (model == CardModel::linear) {
                shot.values().set(cardTable().intendedMaxAngle, 0.5);
                // At 1 the spot fills its strip, and the width of the pixel reaches beyond it.
                shot.values().set(cardTable().magnification, 0.9);
            }
            const Sheet sheet = lenticular::cardSheet(cardTable(), shot.values()).sheet;
            // View k is visible in the middle of the k-th part of the zone. Before the first one is the last, after the
            // last the first.
            for (int k = -1; k <= count; ++k) {
                if (count == 100 && k % 9 != 0 && k != -1 && k != 100) continue;
                const double place = (k + 0.5) / count - 0.5;
                const double angle = model == CardModel::linear ? std::atan(2 * place * std::tan(0.5))
                                                                : place * sheet.pitch() * sheet.index / sheet.thickness;
                shot.from(angle, 2, 0.0016);
                const int view = (k + count) % count;
                EXPECT_NEAR(seen(shot, count), test::solidLevel(view, count), decoding)
                    << "model " << static_cast<int>(model) << ", view " << k << " of " << count;
            }
        }
    }
}

TEST_F(LongCardOptics, ExactSnellShowsWhatTheFloat64ApertureShows)
{
    for (const CardSheet sheetKind : {CardSheet::twenty3d, CardSheet(5), CardSheet(22)}) {
        for (const int count : {2, 3, 16, 100}) {
            CardShot shot;
            shot.values().set(cardTable().sheetKind, sheetKind);
            const Sheet sheet = lenticular::cardSheet(cardTable(), shot.values()).sheet;
            for (const double degrees : {0.0, 4.0, 11.3, 17.0, 25.0, 40.0, 62.0}) {
                const double theta = degrees * half / 90;
                shot.from(theta, 2, 0.0016);
                // At 62 degrees lenses hide each other, starting within one of the 64 parts.
                EXPECT_NEAR(seen(shot, count), expectedGray(shot, sheet, theta, count), degrees > 60 ? 1.0 / 64 : 0.003)
                    << sheet.name << ' ' << count << ' ' << degrees;
            }
        }
    }
}

TEST_F(CardOptics, SkewedRaysBendByTheEffectiveIndex)
{
    CardShot shot;
    const Sheet sheet = lenticular::cardSheet(cardTable(), shot.values()).sheet;
    double departs = 0;
    for (const double degrees : {2.0, 9.0, 13.0, 21.0}) {
        for (const double rise : {0.3, 0.6, 0.8}) {
            // `from` first rotates about the vertical, so its angle is the one across the lenses.
            shot.from(degrees * half / 90, 2, 0.0016, rise);
            const double gray = seen(shot, 16);
            EXPECT_NEAR(gray, expectedGray(shot, sheet, degrees * half / 90, 16, rise), 0.003)
                << degrees << ' ' << rise;
            departs = std::max(departs, std::abs(gray - expectedGray(shot, sheet, degrees * half / 90, 16)));
        }
    }
    EXPECT_GT(departs, 0.03);  // Control: the index of skewed rays has an effect.
}

TEST_F(CardOptics, AcrossTheZoneTheExactModelNeverStepsBackAndJumpsAtItsEdge)
{
    CardShot shot;
    // An elliptic lens is sharp straight ahead, where a sharp lens has hard transitions.
    const Sheet sheet = lenticular::cardSheet(cardTable(), shot.values()).sheet;
    const double edge = printing::zoneByAperture(sheet) / 2;
    const auto levelAt = [&](double share) {
        shot.from(share * edge, 2, 0.0016);
        return seen(shot, 8);
    };
    double before = levelAt(-0.75);
    for (double share = -0.65; share < 0.8; share += 0.1) {
        const double now = levelAt(share);
        EXPECT_GE(now, before - 0.004) << share;
        before = now;
    }
    EXPECT_GT(before, 0.7);
    EXPECT_LT(levelAt(1.3), 0.45);  // Not clamped: the first views again.
    EXPECT_GT(levelAt(-1.3), 0.55);
}

TEST_F(CardOptics, WithMagnificationZeroALensShowsOnePointOfOneStrip)
{
    CardViews files;
    for (const CardModel model : {CardModel::linear, CardModel::paraxial, CardModel::exact}) {
        CardShot shot;
        shot.values().set(cardTable().model, model);
        shot.values().set(cardTable().magnification, 0.0);
        shot.values().set(cardTable().slices, 10);
        shot.size(32, 32);
        // One lens of 6 cm fills the picture, from so far away that its angle is nearly constant.
        shot.from(0, 3.3, 0.058 / 32);
        const std::vector<double> flat = shot.printed(files, files.solid(5));
        for (const double level : flat) EXPECT_NEAR(level, flat.front(), 1e-3) << static_cast<int>(model);
        EXPECT_NEAR(flat.front(), test::solidLevel(static_cast<int>(std::lround(flat.front() * 6)) - 1, 5), decoding)
            << static_cast<int>(model);
        if (model != CardModel::linear)
            continue;  // This sheet is focused: straight ahead it shows little more than a point.
        shot.values().set(cardTable().magnification, 2.0);
        const std::vector<double> wide = shot.printed(files, files.solid(5));
        EXPECT_GT(*std::max_element(wide.begin(), wide.end()) - *std::min_element(wide.begin(), wide.end()), 0.1);
    }
}

TEST_F(CardOptics, EachEyeSeesItsOwnView)
{
    CardShot shot;
    shot.from(0, 0.6, 0.002);
    const auto level = [&](CardEyes eyes, int channel) {
        shot.values().set(cardTable().eyes, eyes);
        return shot.printed(views, views.solid(16), channel)[middle];
    };
    const double left = level(CardEyes::left, 1);
    const double right = level(CardEyes::right, 1);
    EXPECT_GT(right - left, 0.15);
    EXPECT_NEAR(level(CardEyes::anaglyph, 0), left, 0.01);
    EXPECT_NEAR(level(CardEyes::anaglyph, 2), right, 0.01);
    EXPECT_NEAR(level(CardEyes::off, 1), 0.5 * (left + right), 0.05);
    shot.values().set(cardTable().reverse, true);
    EXPECT_LT(level(CardEyes::right, 1), level(CardEyes::left, 1));
}

TEST_F(CardOptics, HorizontalLensesChangeAsTheEyeRisesAndNotAsItPasses)
{
    CardShot shot;
    shot.values().set(cardTable().axis, CardAxis::horizontal);
    const auto at = [&](double angle, double rise) {
        shot.from(angle, 2, 0.0016, rise);
        return seen(shot, 16);
    };
    EXPECT_NEAR(at(0.1, 0), at(-0.1, 0), 0.01);
    EXPECT_GT(std::abs(at(0, 0.1) - at(0, -0.1)), 0.2);
}

TEST_F(CardOptics, TheEvaluationsChannelCountsTheRaysTraced)
{
    CardShot shot;
    shot.values().set(cardTable().frontPrint, views.solid(2));
    shot.request.frame.channels.evaluations = true;
    shot.from(0.1, 1, 0.004);
    const auto traces = [&] {
        const render::Image image = shot.take().image;
        return image.at(12, 12, image.channels - 1);
    };
    // Each part is traced at its center and right edge, each piece of a lens at its left edge, too.
    shot.values().set(cardTable().apertureSamples, 8);
    EXPECT_GE(traces(), 2 * 8 + 1);
    EXPECT_LE(traces(), 2 * 9 + 2);  // Two pieces, if the pixel's window contains a cusp.
    shot.values().set(cardTable().prefilter, false);
    EXPECT_EQ(traces(), 3);
}

TEST_F(CardOptics, DispersionSendsRedAndBlueToDifferentPlaces)
{
    const glm::dvec3 index = lenticular::dispersedIndex(1.56, 30);
    EXPECT_LT(index.r, index.g);
    EXPECT_LT(index.g, index.b);
    // Definition of the Abbe number, by the same formula.
    const auto at = [](double micrometers, double b) {
        return 1.56 + b * (1 / (micrometers * micrometers) - 1 / (0.5876 * 0.5876));
    };
    const double b = (index.b - index.r) / (1 / (0.465 * 0.465) - 1 / (0.611 * 0.611));
    EXPECT_NEAR(0.56 / (at(0.4861, b) - at(0.6563, b)), 30, 1e-9);

    CardShot shot;
    const Sheet sheet = lenticular::cardSheet(cardTable(), shot.values()).sheet;
    shot.from(0.2, 2, 0.0016);
    const double gray = seen(shot, 16);
    shot.values().set(cardTable().dispersion, true);
    shot.values().set(cardTable().abbeNumber, 10.0);
    double apart = 0;
    for (int channel = 0; channel < 3; ++channel) {
        Sheet colored = sheet;
        colored.index = lenticular::dispersedIndex(sheet.index, 10)[channel];
        const double level = shot.printed(views, views.solid(16), channel)[middle];
        EXPECT_NEAR(level, expectedGray(shot, colored, 0.2, 16), 0.003) << channel;
        apart = std::max(apart, std::abs(level - gray));
    }
    EXPECT_GT(apart, 0.002);
}

}  // namespace
}  // namespace vitrine
