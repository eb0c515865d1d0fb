// Accuracy of coats: independent of the order of drawing, closed at the silhouette, close to the reference, and worse
// with methods that are known to be worse.

#include "tests/exhibits/fur/fur_shot.h"

#include <algorithm>
#include <cmath>

namespace vitrine::fur {
namespace {

using namespace test;

class FurQuality : public GlTest {};
class LongFurQuality : public FurQuality {};

TEST_F(FurQuality, LooksTheSameToTheBitFromOutsideInAndFromInsideOut)
{
    FurShot outer, inner;
    outer.shells(24, FurSilhouette::none);
    inner.shells(24, FurSilhouette::none, FurOrder::innerFirst);
    EXPECT_EQ(largestDifference(outer.take().image, inner.take().image), 0);
}

TEST_F(FurQuality, NeedsFewerSamplesThanShellsFromInsideOutForALesserError)
{
    FurShot reference, naive, good;
    const Picture truth = reference.reference().take();
    naive.shells(64, FurSilhouette::none, FurOrder::innerFirst);
    const double naiveError = colorDifference(naive.take(), truth);
    const double goodError = colorDifference(good.shells(16, FurSilhouette::march).take(), truth);
    EXPECT_LE(goodError, naiveError * 1.02);
    EXPECT_GE(static_cast<double>(naive.samplesPassed()), 2.5 * static_cast<double>(good.samplesPassed()));
}

/// Returns the share of pixels in which one coat is visible and the other is not.
double gaps(const Picture& p, const Picture& truth)
{
    int wrong = 0, fringe = 0;
    p.each([&](int x, int y) {
        wrong += p.hit(x, y) != truth.hit(x, y);
        fringe += truth.hit(x, y);
    });
    return static_cast<double>(wrong) / fringe;
}

TEST_F(FurQuality, HasNoGapsBetweenShellsAtTheSilhouette)
{
    const auto shot = [](const auto& change) {
        FurShot s;
        s.see({-1.05, 0.75, 1.1}, {-1.0, 0.62, 0}).request.frame.camera.fovY = 0.5;
        s.size(160, 120);
        change(s);
        return s.take();
    };
    const Picture truth = shot([](FurShot& s) { s.reference(); });
    const double none = gaps(shot([](FurShot& s) { s.shells(10, FurSilhouette::none); }), truth);
    const double fins = gaps(shot([](FurShot& s) { s.shells(10, FurSilhouette::fins); }), truth);
    const double byAngle = gaps(shot([](FurShot& s) { s.shells(10, FurSilhouette::byAngle); }), truth);
    const double march = gaps(shot([](FurShot& s) { s.shells(10, FurSilhouette::march); }), truth);
    std::printf("pixels that differ from the reference's silhouette, 10 shells: none %.2f %%, fins %.2f %%, by angle "
                "%.2f %%, march %.2f %%\n",
                100 * none, 100 * fins, 100 * byAngle, 100 * march);
    EXPECT_LT(march, 0.6 * none);
    EXPECT_LT(byAngle, 0.7 * none);
    EXPECT_LT(march, fins);
    EXPECT_LT(march, byAngle);
}

TEST_F(FurQuality, ShellsByAngleLeaveNoHoleInTheSkinAndAreTheSameInBothOrders)
{
    // Almost without strands only the skin is visible. It must be there once, wherever the shells end.
    const auto shot = [](FurSilhouette silhouette, FurOrder order, int density) {
        FurShot s;
        s.shells(7, silhouette, order);
        for (int i = 0; i < furBodyCount; ++i)
            s.values().set(furTable().coats[static_cast<std::size_t>(i)].density, density);
        return s.take();
    };
    const Picture bare = shot(FurSilhouette::none, FurOrder::outerFirst, 1);
    const Picture byAngle = shot(FurSilhouette::byAngle, FurOrder::outerFirst, 1);
    EXPECT_GT(bare.hits(), 300);
    EXPECT_LT(gaps(byAngle, bare), 0.01);
    const Picture outer = shot(FurSilhouette::byAngle, FurOrder::outerFirst, 60000);
    EXPECT_EQ(largestDifference(outer.image, shot(FurSilhouette::byAngle, FurOrder::innerFirst, 60000).image), 0);
}

TEST_F(LongFurQuality, IsNearTheReferenceAtSixteenSamplesPerPixel)
{
    FurShot usual, reference, sparse;
    usual.request.samples = reference.request.samples = sparse.request.samples = 16;
    usual.request.frame.averageIn = reference.request.frame.averageIn = sparse.request.frame.averageIn =
        AverageIn::display;
    usual.values().set(furTable().levelOfDetail, false);  // The picture is small, but the full coat has to be measured.
    const Picture truth = reference.reference().take();
    const double error = colorDifference(usual.take(), truth);
    std::printf("error of the initial coat against 256 shells: %.4f\n", error);
    EXPECT_LT(error, 0.06);
    sparse.shells(4, FurSilhouette::none);
    EXPECT_GT(colorDifference(sparse.take(), truth), 0.06);
}

/// Returns the level of a display, 0 to 255.
double level(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

double levelsApart(const Picture& a, const Picture& b)
{
    double sum = 0;
    a.each([&](int x, int y) {
        for (int k = 0; k < 3; ++k) sum += std::pow(level(a.color(x, y)[k]) - level(b.color(x, y)[k]), 2);
    });
    return std::sqrt(sum / (3.0 * a.width() * a.height()));
}

/// Returns the standard deviation of all channels, in levels of a display.
double deviationOf(const Picture& p)
{
    double sum = 0, squares = 0;
    p.each([&](int x, int y) {
        for (int k = 0; k < 3; ++k) {
            const double value = level(p.color(x, y)[k]);
            sum += value;
            squares += value * value;
        }
    });
    const double count = 3.0 * p.width() * p.height();
    return std::sqrt(squares / count - sum / count * (sum / count));
}

/// Shot from a few decimeters, with pixels as large as in a picture 640 wide with the field of view of a 25 mm lens.
struct CloseShot : FurShot {
    CloseShot()
    {
        see({-0.25, 0.75, 1.0}, {-0.35, 0.35, 0.25}).request.frame.camera.fovY = 0.24;
        size(136, 96);
        request.samples = 4;
        request.frame.averageIn = AverageIn::display;
        values().set(furTable().levelOfDetail, false);
    }
};

TEST_F(LongFurQuality, SeenFromNearIsWithinEightLevelsOfShellsWithoutNumber)
{
    CloseShot usual, reference, bare;
    const Picture truth = reference.reference().take();
    EXPECT_GT(truth.hits(), 0.9 * truth.width() * truth.height());
    const double error = levelsApart(usual.take(), truth);
    const double bareError = levelsApart(bare.shells(10, FurSilhouette::none).take(), truth);
    std::printf("from near, RMSE in levels: the initial coat %.2f, 10 bare shells %.2f\n", error, bareError);
    EXPECT_LE(error, 8);
    EXPECT_GT(bareError, 16);
}

TEST_F(LongFurQuality, WithFewerShellsFromItsBestViewIsNearShellsWithoutNumber)
{
    // Fur everywhere: a part of the picture with pixels as large as in one of 640 x 360.
    struct PartOfBestView : FurShot {
        PartOfBestView()
        {
            render::Camera& camera = request.frame.camera;
            camera.target = {-0.2, 0.4, 0.2};
            camera.fovY = 2 * std::atan(std::tan(0.5 * camera.fovY) * 112 / 360);
            size(168, 112);
            // The tips of strands are drawn in a share of the supersamples.
            request.samples = 8;
            request.frame.averageIn = AverageIn::display;
        }
    };
    PartOfBestView usual, all, reference, bare;
    const Picture truth = reference.reference().take();
    const double error = levelsApart(usual.take(), truth);
    all.values().set(furTable().levelOfDetail, false);
    const double allError = levelsApart(all.take(), truth);
    const double bareError = levelsApart(bare.shells(5, FurSilhouette::none).take(), truth);
    std::printf(
        "from the best view, RMSE in levels: the initial coat %.2f, with all its shells %.2f, 5 bare shells %.2f\n",
        error, allError, bareError);
    // Relative to the picture's own contrast, which the tone curve decides.
    const double contrast = deviationOf(truth);
    EXPECT_LE(error, 0.25 * contrast);
    EXPECT_GT(bareError, 0.4 * contrast);
    EXPECT_LE(allError, 0.17 * contrast);
}

TEST_F(LongFurQuality, SpinesAreSmooth)
{
    const auto shot = [](const auto& change) {
        CloseShot s;
        s.see({-0.62, 0.9, 1.8}, {-0.62, 0.45, 0});
        ParameterValues& v = s.values();
        const CoatParameters ball = furTable().coats[furBall];
        v.set(ball.density, 900);
        v.set(ball.length, 0.26);
        v.set(ball.thickness, 0.017);
        v.set(ball.uniformity, 0.75);
        for (const Real none : {furTable().clump, furTable().comb, furTable().gravity}) v.set(none, 0.0);
        v.set(furTable().disorder, 0.08);
        v.set(furTable().strandRoundness, 0.1);
        change(s);
        return s.take();
    };
    const Picture truth = shot([](CloseShot& s) { s.reference(); });
    const double usual = levelsApart(shot([](CloseShot& s) { s.shells(16, FurSilhouette::march); }), truth);
    const double disks = levelsApart(shot([](CloseShot& s) { s.shells(16, FurSilhouette::none); }), truth);
    std::printf("spines, RMSE in levels: %.2f, as disks %.2f\n", usual, disks);
    EXPECT_LE(usual, 8);
    EXPECT_GT(disks, 16);
}

TEST_F(FurQuality, EachStudyHasAViewThatTellsItsMethodsApart)
{
    const Exhibit& exhibit = gallery().museum.exhibit(*gallery().museum.find("fur"));
    const auto shot = [&](std::string_view name, const auto& change) {
        FurShot s;
        for (const StudyView& view : exhibit.studyViews(s.values())) {
            if (view.name != name) continue;
            s.values() = view.values;
            s.request.frame.camera = view.camera;
            s.request.frame.time = view.time;
            change(s.values());
            return s.take();
        }
        ADD_FAILURE() << "no view " << name;
        return s.take();
    };
    const auto rotation = [&](FurRotation model) {
        return shot("spin of 120 degrees", [&](ParameterValues& v) { v.set(furTable().rotationModel, model); });
    };
    const Picture slerp = rotation(FurRotation::slerp);
    const double nlerp = colorDifference(rotation(FurRotation::nlerp), slerp);
    EXPECT_GT(nlerp, 0.005);
    EXPECT_GT(colorDifference(rotation(FurRotation::matrixMix), slerp), 1.2 * nlerp);

    const auto springs = [&](FurSpring model) {
        return shot("stiff fur in long steps", [&](ParameterValues& v) { v.set(furTable().springModel, model); });
    };
    const Picture exact = springs(FurSpring::closedForm);
    const double semiImplicit = colorDifference(springs(FurSpring::semiImplicit), exact);
    EXPECT_GT(semiImplicit, 0.005);
    EXPECT_GT(colorDifference(springs(FurSpring::explicitEuler), exact), 1.2 * semiImplicit);

    const auto shells = [&](int count) {
        return shot("silhouette", [&](ParameterValues& v) { v.set(furTable().shellCount, count); });
    };
    const Picture many = shells(256);
    const double few = colorDifference(shells(4), many);
    EXPECT_GT(few, 1.2 * colorDifference(shells(32), many));
}

}  // namespace
}  // namespace vitrine::fur
