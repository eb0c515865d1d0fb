// Pictures with two halves of different settings: their content, the divider, and their cost.

#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "tests/exhibits/sdf_scenes/scene_shot.h"
#include "tests/support/planned.h"

#include <cmath>
#include <random>

namespace vitrine {
namespace {

using namespace test;

class SceneHalves : public test::GlTest {};

/// Function that sets a parameter of the whole picture, or of the right half.
struct HalvesCase {
    const char* name;
    std::function<void(ParameterValues&)> whole, right;
};

std::vector<HalvesCase> halvesCases()
{
    const scenes::SdfScenesTable& t = scenesTable();
    const auto both = [](const char* name, const auto& row, const auto& rightParameter, const auto& value) {
        return HalvesCase{name, [&row, value](ParameterValues& v) { v.set(row, value); },
                          [&rightParameter, value](ParameterValues& v) { v.set(rightParameter, value); }};
    };
    return {both("shadows", t.shadowMethod, t.rightShadowMethod, scenes::SceneShadow::none),
            both("occlusion", t.occlusionMethod, t.rightOcclusionMethod, scenes::SceneOcclusion::cones),
            both("bounces", t.bounces, t.rightBounces, 0),
            both("evaluation", t.evaluation, t.rightEvaluation, scenes::SceneEvaluation::near),
            both("step limit", t.stepLimit, t.rightStepLimit, 12),
            both("hit tolerance", t.hitTolerance, t.rightHitTolerance, 24.0)};
}

/// Returns whether all channels of a pixel are equal.
bool sameAt(const render::Image& a, const render::Image& b, int x, int y)
{
    for (int c = 0; c < a.channels; ++c) {
        const float p = a.at(x, y, c), q = b.at(x, y, c);
        if (p != q && !(std::isnan(p) && std::isnan(q))) return false;
    }
    return true;
}

struct HalvesFound {
    int apart = 0;            ///< Pixels in which the two settings differ.
    int ofNeither = 0;        ///< Pixels of the divided picture that equal neither.
    int left = 0, right = 0;  ///< Pixels in which they differ and that equal that one.
    int beyond = 0;           ///< Pixels of these on the wrong side of the divider.
};

/// `columnAt` returns the column of the divider in a row.
HalvesFound compareHalves(SceneShot shot, const HalvesCase& setting, double divider,
                          const std::function<double(int y)>& columnAt)
{
    shot.request.frame.channels.evaluations = true;
    const render::Image left = shot.take().image;
    SceneShot other = shot;
    setting.whole(other.values());
    const render::Image right = other.take().image;
    shot.values().set(scenesTable().rightShadowMethod, scenes::SceneShadow::look);  // The same as on the left.
    setting.right(shot.values());
    shot.values().set(scenesTable().split, true);
    shot.values().set(scenesTable().divider, divider);
    const render::Image both = shot.take().image;
    HalvesFound found;
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x) {
            const bool ofLeft = sameAt(both, left, x, y), ofRight = sameAt(both, right, x, y);
            found.ofNeither += !ofLeft && !ofRight;
            if (ofLeft == ofRight) continue;
            ++found.apart;
            ++(ofLeft ? found.left : found.right);
            found.beyond += ofLeft ? x + 0.5 > columnAt(y) + 0.01 : x + 0.5 < columnAt(y) - 0.01;
        }
    return found;
}

/// Returns the column of the divider in a row of the picture, counted from the top.
std::function<double(int)> dividerIn(const SceneShot& shot, double divider, const glm::dmat4& world)
{
    const render::View view = render::makeView(shot.request.frame.camera, shot.request.frame.raster);
    const Portal portal;
    const auto seen = [=](double y) {
        const glm::dvec4 clip =
            view.clipFromWorld * (world * glm::dvec4((2 * divider - 1) * portal.halfSize.x, y, -portal.behind, 1));
        return glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * glm::dvec2(view.raster.size);
    };
    return [a = seen(-0.5), b = seen(0.5)](int y) { return a.x + (y + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x); };
}

using LongSceneHalves = SceneHalves;

TEST_F(LongSceneHalves, AreEachTheWholePictureWithItsSettings)
{
    SceneShot shot(shippedScene("primitives"));
    shot.values().set(scenesTable().look, scenes::SceneLook::physical);
    for (const HalvesCase& setting : halvesCases()) {
        const HalvesFound found = compareHalves(shot, setting, 0.45, dividerIn(shot, 0.45, glm::dmat4(1)));
        EXPECT_EQ(found.ofNeither, 0) << setting.name;
        EXPECT_EQ(found.beyond, 0) << setting.name;
        EXPECT_GT(found.left, 40) << setting.name << ": control: the settings differ to the left";
        EXPECT_GT(found.right, 40) << setting.name << ": and to the right";
    }
}

TEST_F(SceneHalves, MeetWhereTheDividerStandsFromAnywhereInTheHall)
{
    SceneShot shot(shippedScene("primitives"));
    shot.inHall();
    const glm::dmat4 world = test::gallery().museum.worldFromExhibit(shot.exhibit);
    const auto at = [&](const glm::dvec3& p) { return glm::dvec3(world * glm::dvec4(p, 1)); };
    shot.request.frame.camera.eye = at({0.9, 0.5, 1.6});
    shot.request.frame.camera.target = at({0.1, -0.1, -0.5});
    const HalvesFound found = compareHalves(shot, halvesCases()[0], 0.6, dividerIn(shot, 0.6, world));
    EXPECT_EQ(found.ofNeither, 0);
    EXPECT_EQ(found.beyond, 0);
    EXPECT_GT(found.left, 40);
    EXPECT_GT(found.right, 40);
}

TEST_F(SceneHalves, CostOnePictureNotTwo)
{
    SceneShot shot(shippedScene("torus"));
    const auto plan = [&] { return test::planned(test::gallery().museum, shot.sceneState, shot.request.frame); };
    EXPECT_FALSE(plan().find("sdf_scenes/scene")->columns);
    EXPECT_EQ(plan().findSkipped("sdf_scenes/right")->reason, "the picture is not divided");
    shot.values().set(scenesTable().split, true);
    const int width = shot.request.frame.raster.size.x;
    for (const double divider : {0.1, 0.5, 0.83}) {
        shot.values().set(scenesTable().divider, divider);
        const render::FramePlan divided = plan();
        const glm::ivec2 left = divided.find("sdf_scenes/scene")->columns.value();
        const glm::ivec2 right = divided.find("sdf_scenes/right")->columns.value();
        const auto columns = [](const glm::ivec2& c) { return c.y - c.x; };
        EXPECT_GE(columns(left) + columns(right), width);
        EXPECT_LE(columns(left) + columns(right), width + 4) << divider;
    }
    // A tile that is entirely in one half.
    shot.request.frame.raster.tile = {16, 64};
    EXPECT_EQ(plan().find("sdf_scenes/right"), nullptr);
    EXPECT_EQ(plan().findSkipped("sdf_scenes/right")->reason, "its half is out of view");
    EXPECT_TRUE(plan().find("sdf_scenes/scene"));
}

TEST(SceneDivider, LiesUnderThePointer)
{
    const scenes::SdfScenes exhibit;
    const scenes::SdfScenesTable& t = exhibit.parameters();
    ParameterValues values = t.initial();
    EXPECT_TRUE(exhibit.draggedLines({values}, {0, 0, 2}).empty()) << "there is none without halves";
    values.set(t.split, true);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 eye(2 * any(random), any(random), 1.5 + any(random));
        const glm::dvec3 wanted(1.1 * any(random), 0.6 * any(random), -Portal().behind);
        values.set(t.divider, exhibit.valueUnder({values}, t.divider.row, {eye, glm::normalize(wanted - eye)}));
        const std::vector<DraggedLine> lines = exhibit.draggedLines({values}, eye);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_EQ(lines[0].row, t.divider.row);
        EXPECT_NEAR(lines[0].from.x, wanted.x, 1e-9);
        EXPECT_EQ(lines[0].from.x, lines[0].to.x);
    }
    EXPECT_EQ(exhibit.valueUnder({values}, 0, {{0, 0, 2}, {0.9, 0, -0.1}}), 1) << "beyond the edge it stays at it";
}

}  // namespace
}  // namespace vitrine
