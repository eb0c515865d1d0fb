// What accuracy of a coat is worth: the same in every order, closed at the silhouette, near the reference, and worse
// where a method is known to be worse.

#include "tests/exhibits/fur/fur_shot.h"

namespace vitrine::test {
namespace {

class FurQuality : public GlTest {};

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

/// Share of the pixels where one coat is seen and the other is not.
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
    // With no strand to speak of, all that is seen is the skin: it must be there once, wherever the shells end.
    const auto shot = [](FurSilhouette silhouette, FurOrder order, int density) {
        FurShot s;
        s.shells(7, silhouette, order);
        for (int i = 0; i < furBodyCount; ++i)
            s.object().set(table().coats[static_cast<std::size_t>(i)].density, density);
        return s.take();
    };
    const Picture bare = shot(FurSilhouette::none, FurOrder::outerFirst, 1);
    const Picture byAngle = shot(FurSilhouette::byAngle, FurOrder::outerFirst, 1);
    EXPECT_GT(bare.hits(), 300);
    EXPECT_LT(gaps(byAngle, bare), 0.01);
    const Picture outer = shot(FurSilhouette::byAngle, FurOrder::outerFirst, 60000);
    EXPECT_EQ(largestDifference(outer.image, shot(FurSilhouette::byAngle, FurOrder::innerFirst, 60000).image), 0);
}

TEST_F(FurQuality, IsNearTheReferenceAtSixteenSamplesPerPixel)
{
    FurShot usual, reference, sparse;
    usual.request.samples = reference.request.samples = sparse.request.samples = 16;
    usual.request.frame.averageIn = reference.request.frame.averageIn = sparse.request.frame.averageIn =
        AverageIn::display;
    usual.object().set(table().levelOfDetail, false);  // The picture is small; the coat is to be measured in full.
    const Picture truth = reference.reference().take();
    const double error = colorDifference(usual.take(), truth);
    std::printf("error of the initial coat against 256 shells: %.4f\n", error);
    EXPECT_LT(error, 0.06);
    sparse.shells(4, FurSilhouette::none);
    EXPECT_GT(colorDifference(sparse.take(), truth), 0.06);
}

TEST_F(FurQuality, EachStudyHasAViewThatTellsItsMethodsApart)
{
    const Exhibit& exhibit = gallery().museum.exhibit(*gallery().museum.find("fur"));
    const auto shot = [&](std::string_view name, const auto& change) {
        FurShot s;
        for (const StudyView& view : exhibit.studyViews(s.object())) {
            if (view.name != name) continue;
            s.object() = view.values;
            s.request.frame.camera = view.camera;
            s.request.frame.time = view.time;
            change(s.object());
            return s.take();
        }
        ADD_FAILURE() << "no view " << name;
        return s.take();
    };
    const auto rotation = [&](FurRotation model) {
        return shot("spin of 120 degrees", [&](ParameterValues& v) { v.set(table().rotationModel, model); });
    };
    const Picture slerp = rotation(FurRotation::slerp);
    const double nlerp = colorDifference(rotation(FurRotation::nlerp), slerp);
    EXPECT_GT(nlerp, 0.005);
    EXPECT_GT(colorDifference(rotation(FurRotation::matrixMix), slerp), 1.2 * nlerp);

    const auto springs = [&](FurSpring model) {
        return shot("stiff fur in long steps", [&](ParameterValues& v) { v.set(table().springModel, model); });
    };
    const Picture exact = springs(FurSpring::closedForm);
    const double semiImplicit = colorDifference(springs(FurSpring::semiImplicit), exact);
    EXPECT_GT(semiImplicit, 0.005);
    EXPECT_GT(colorDifference(springs(FurSpring::explicitEuler), exact), 1.2 * semiImplicit);

    const auto shells = [&](int count) {
        return shot("silhouette", [&](ParameterValues& v) { v.set(table().shellCount, count); });
    };
    const Picture many = shells(256);
    const double few = colorDifference(shells(4), many);
    EXPECT_GT(few, 1.2 * colorDifference(shells(32), many));
}

}  // namespace
}  // namespace vitrine::test
