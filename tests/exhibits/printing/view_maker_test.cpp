#include "exhibits/printing/view_maker.h"

#include "exhibits/crepuscular_rays/sun_in_picture.h"
#include "tests/exhibits/printing/samples.h"
#include "tests/support/failures.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vitrine::printing {
namespace {

using namespace vitrine::test;

std::vector<ViewShot> shots(int count)
{
    const Scene scene;
    ViewShot base{scene.sceneState, {scene.request}};
    base.request.frame.subject = scene.sdf;
    base.request.frame.seed = 7;
    const PrintLayout layout(test::settingsFor(40, 1200, count, 900, 600));
    return shotsOf(ViewRig(layout, scene.sceneState.camera, {90, 60}), base);
}

/// Returns the position of the exhibit's own point `p` in a view.
glm::dvec3 placed(const ViewShot& shot, const glm::dvec3& p)
{
    return glm::dvec3(shot.request.frame.exhibitTransform * glm::dvec4(p, 1));
}

TEST(Shots, EachHasItsOwnCameraAndItsOwnNoise)
{
    std::set<std::uint32_t> seeds;
    std::set<double> places;
    for (const ViewShot& shot : shots(12)) {
        EXPECT_EQ(shot.sceneState.camera, shot.request.frame.camera);
        seeds.insert(shot.request.frame.seed);
        places.insert(shot.sceneState.camera.eye.x);
    }
    EXPECT_EQ(seeds.size(), 12U);
    EXPECT_EQ(*seeds.begin(), 7U);
    EXPECT_EQ(places.size(), 12U);
}

TEST(Shots, SeeTheSunWhereTheirShiftedLensesPutIt)
{
    for (const ViewShot& shot : shots(5)) {
        const render::View view = render::makeView(shot.sceneState.camera, {.size = {90, 60}});
        const glm::dvec2 ndc(0.3, -0.6);
        const crepuscular_rays::SunInPicture sun =
            crepuscular_rays::sunInPicture(view, glm::normalize(view.direction(ndc)));
        EXPECT_TRUE(sun.inFront);
        EXPECT_LT(glm::length(sun.pixel - (ndc * 0.5 + 0.5) * glm::dvec2(90, 60)), 1e-9);
    }
}

TEST(Turn, GoesInEqualStepsAroundTheMiddleAndAFullTurnHasNoDouble)
{
    std::vector<ViewShot> row = shots(12);
    turn(row, 2 * 3.14159265358979323846);
    const glm::dvec3 front(0, 0.3, 1);
    for (std::size_t k = 0; k < 12; ++k) {
        const glm::dvec3 a = placed(row[k], front);
        const glm::dvec3 b = placed(row[(k + 1) % 12], front);
        EXPECT_NEAR(a.y, 0.3, 1e-12);
        EXPECT_NEAR(glm::length(b - a), 2 * std::sin(3.14159265358979323846 / 12), 1e-9) << k;  // Chord of 30 degrees.
    }
    std::vector<ViewShot> odd = shots(5);
    turn(odd, 1);
    EXPECT_LT(glm::length(placed(odd[2], front) - front), 1e-12);
}

TEST(Turn, ShowsDepthTheRightWayRoundAsAWalkToTheRightDoes)
{
    std::vector<ViewShot> row = shots(9);
    turn(row, 0.5);
    // Seen along -z, the near side moves to the left and the far side to the right, like with the cameras of a rig.
    EXPECT_LT(placed(row[8], {0, 0, 0.3}).x, placed(row[0], {0, 0, 0.3}).x);
    EXPECT_GT(placed(row[8], {0, 0, -0.3}).x, placed(row[0], {0, 0, -0.3}).x);
}

TEST(Turn, NeedsAnExhibit)
{
    std::vector<ViewShot> row = shots(3);
    for (ViewShot& shot : row) shot.request.frame.subject.reset();
    EXPECT_NE(refusalOf([&] { turn(row, 1); }).find("name an exhibit"), std::string::npos);
    EXPECT_NE(refusalOf([&] { turn(row, std::nan("")); }), "");
}

TEST(Sweep, RunsFromOneEndToTheOther)
{
    std::vector<ViewShot> row = shots(5);
    const Scene scene;
    Scene from, to;
    from.object().set(sdfTable().morph, 0.2);
    to.object().set(sdfTable().morph, 0.8);
    from.object().set(sdfTable().hitTolerance, 0.5);  // A parameter with a logarithmic scale.
    to.object().set(sdfTable().hitTolerance, 8.0);
    to.object().set(sdfTable().baseColor, ColorValue{{0, 0, 0}});
    to.hall().set(hallTable().exposure, scene.sceneState.hall()[hallTable().exposure] + 1);
    sweep(row, from.sceneState, to.sceneState);
    for (std::size_t k = 0; k < 5; ++k) {
        const ParameterValues& object = row[k].sceneState.values[scene.sdf];
        const double part = static_cast<double>(k) / 4;
        EXPECT_NEAR(object[sdfTable().morph], 0.2 + 0.6 * part, 1e-12);
        EXPECT_NEAR(object[sdfTable().hitTolerance], 0.5 * std::pow(16, part), 1e-9);
        EXPECT_NEAR(object[sdfTable().baseColor].value.x, (1 - part) * from.object()[sdfTable().baseColor].value.x,
                    1e-12);
        EXPECT_NEAR(row[k].sceneState.hall()[hallTable().exposure], from.hall()[hallTable().exposure] + part, 1e-12);
        EXPECT_EQ(object[sdfTable().roughness], from.object()[sdfTable().roughness]);
    }
}

TEST(Sweep, RefusesWhatHasNothingBetween)
{
    std::vector<ViewShot> row = shots(3);
    Scene from, to;
    EXPECT_NE(refusalOf([&] { sweep(row, from.sceneState, to.sceneState); }).find("the same"), std::string::npos);
    to.object().set(sdfTable().material, SdfMaterial::glass);
    EXPECT_NE(refusalOf([&] { sweep(row, from.sceneState, to.sceneState); }).find("material"), std::string::npos);
    Scene on;
    on.object().set(sdfTable().conePrepass, !from.object()[sdfTable().conePrepass]);
    EXPECT_NE(refusalOf([&] { sweep(row, from.sceneState, on.sceneState); }).find("conePrepass"), std::string::npos);
}

}  // namespace
}  // namespace vitrine::printing
