// An exhibit of three small files (ball/ball.h, ball/ball.glsl, a line in a list) has what every exhibit has: a slider,
// a body that is marched, a shadow, presets, studies, and its lines in the frame report.

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/study/study.h"
#include "tests/kit/ball_shot.h"
#include "tests/support/museum_on_paper.h"

namespace vitrine {
namespace {

using glm::dvec3;
using namespace test;

class Ball : public test::GlTest {};

using LongBall = Ball;

TEST_F(Ball, ShowsTheCircleOfItsSphereToAPixel)
{
    for (const double radius : {0.1, 0.3, 0.45}) {
        BallShot shot;
        shot.values().set(ballTable().radius, radius);
        shot.request.frame.camera.target = {0.1, 0.05, 0};  // Off the middle, where the circle is an ellipse.
        const Picture p = shot.take();
        int inside = 0, wrong = 0;
        p.each([&](int x, int y) {
            const dvec3 ray = p.ray(x, y);
            // A pixel is as wide as this where the ray passes the ball.
            const double pixel = 2 * p.view.tanHalfFov.y / p.height() * glm::length(p.view.eye);
            const double beyond = test::distanceOf(p.view.eye, ray, dvec3(0)) - radius;
            if (std::abs(beyond) < pixel) return;
            inside += beyond < 0;
            wrong += p.hit(x, y) != (beyond < 0);
            if (!p.hit(x, y) || beyond > -2 * pixel) return;
            // The nearer point of the line on the sphere, and its normal; a hit may lie half a pixel before it.
            const dvec3 d = glm::normalize(ray);
            const double middle = -glm::dot(p.view.eye, d);
            const double half = std::sqrt(radius * radius - glm::dot(p.view.eye, p.view.eye) + middle * middle);
            const dvec3 point = p.view.eye + d * (middle - half);
            EXPECT_NEAR(p.depth(x, y) * glm::length(ray), middle - half, pixel * radius / half);
            EXPECT_GT(glm::dot(p.normal(x, y), point / radius), 0.999) << x << ',' << y;
        });
        EXPECT_GT(inside, 60) << radius;
        EXPECT_EQ(wrong, 0) << radius;
    }
}

TEST_F(Ball, IsTheSameAsAMesh)
{
    BallShot shot;
    shot.values().set(ballTable().hitTolerance, 0.02);  // Or rays end on the outline's half pixel.
    const Picture marched = shot.take();
    shot.values().set(ballTable().shownAs, SdfShown::mesh);
    shot.values().set(ballTable().tessellation, 64);
    const Picture mesh = shot.take();
    int different = 0;
    double largest = 0;
    marched.each([&](int x, int y) {
        different += marched.hit(x, y) != mesh.hit(x, y);
        if (marched.hit(x, y) && mesh.hit(x, y) && marched.normal(x, y).z > 0.3)
            largest = std::max(largest, glm::length(marched.normal(x, y) - mesh.normal(x, y)));
    });
    EXPECT_LT(different, marched.hits() / 50);
    EXPECT_LT(largest, 0.05);
}

TEST_F(LongBall, ThrowsItsShadowWhereTheSphereHidesTheSun)
{
    constexpr double radius = 0.4;
    BallShot shot;
    shot.inHall();
    shot.hall().set(hallTable().sunAzimuth, 0.0);
    shot.hall().set(hallTable().sunElevation, 0.21);
    shot.hall().set(hallTable().shadowMapSize, 2048);
    shot.values().set(ballTable().radius, radius);
    shot.request.frame.camera = {{0.01, 6, 6.9}, {0, 0, 6.8}, 0.7};
    const dvec3 center(shot.worldFromExhibit()[3]);
    const Picture with = shot.take();
    shot.request.frame.exhibitTransform[3] = {0, -500, 0, 1};
    const Picture without = shot.take();
    shot.hall().set(hallTable().sunShadows, false);
    const Picture lit = shot.take();

    const dvec3 towardsSun(0, std::sin(0.21), -std::cos(0.21));
    int dark = 0, open = 0, wrong = 0;
    with.each([&](int x, int y) {
        // Only where the sun reaches the floor when the ball is not there.
        if (!with.hit(x, y) || without.luminance(x, y) < 0.99 * lit.luminance(x, y)) return;
        const dvec3 floor = with.view.eye + with.ray(x, y) * with.depth(x, y);
        const double beyond = test::distanceOf(floor, towardsSun, center) - radius;
        if (std::abs(beyond) < 0.06) return;  // The width of the filter: five texels.
        const double ratio = with.luminance(x, y) / without.luminance(x, y);
        ++(beyond < 0 ? dark : open);
        wrong += beyond < 0 ? ratio > 0.85 : ratio < 0.99;
    });
    EXPECT_GT(dark, 50);
    EXPECT_GT(open, 100);
    EXPECT_EQ(wrong, 0);
}

TEST_F(Ball, GrowsWithItsSliderAndWithWhatIsTyped)
{
    BallShot shot;
    const auto hitsAt = [&](const char* typed) {
        const std::size_t row = *shot.values().table().find("radius");
        EXPECT_TRUE(shot.values().setParameter(row, parseValue(shot.values().rows()[row], typed).value()));
        return static_cast<double>(shot.take().hits());
    };
    const double small = hitsAt("15 cm");
    // A ball of twice the radius covers four times the picture; a little more, as it comes nearer.
    EXPECT_NEAR(hitsAt("0.3") / small, 4, 0.3);
}

TEST_F(Ball, StaysFiniteWhateverIsSet)
{
    RandomNumbers numbers(5);
    for (int i = 0; i < 24; ++i) {
        BallShot shot;
        shot.values() = randomValues(ballTable(), numbers);
        shot.request.frame.raster.size = {32, 24};
        EXPECT_EQ(test::notFinite(shot.take().image, 4), "") << i;
    }
}

TEST_F(Ball, IsStudiedAndErrsLessTheFinerItIsMarched)
{
    BallShot shot;
    study::StudyRequest request;
    request.subject = shot.exhibit;
    request.sceneState = shot.sceneState;
    request.axes = {{shot.exhibit, ballTable().hitTolerance.row, {0.25, 1, 4, 16}}};
    request.size = {64, 48};
    request.runs = 1;
    request.views = 1;
    request.alone = true;
    request.modelError = false;
    render::gl::Renderer renderer;
    study::Study study(shot.museum, renderer, request);
    while (study.step()) {
    }
    const study::StudyResult& result = study.result();
    ASSERT_EQ(result.points.size(), 4U);
    EXPECT_GT(result.points[0].error, 0);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(result.points[i].error, 1.3 * result.points[i - 1].error) << i;
}

TEST(BallOnPaper, ComesBackFromAPreset)
{
    ParameterValues values = ballTable().initial();
    values.set(ballTable().radius, 0.45);
    values.set(ballTable().material, SdfMaterial::glass);
    values.set(ballTable().stepLimit, 64);
    const std::string text =
        presetText({.exhibit = "ball", .name = "A glass ball", .values = values, .camera = std::nullopt});
    const Preset read = parsePreset(text, "a-glass-ball.json", "ball", ballTable());
    EXPECT_TRUE(read.values == values);
    EXPECT_TRUE(read.notes.empty());
}

TEST(BallOnPaper, OutOfViewTheFrameReportSaysWhyInOneLine)
{
    BallShot shot;
    shot.inHall();
    shot.hall().set(hallTable().sunShadows, false);
    EXPECT_TRUE(test::runs(test::planned(shot.museum, shot.sceneState, shot.request.frame), "ball/march"));
    shot.request.frame.camera = {{0, 1.65, 3}, {0, 1.65, 12}, 0.96};
    const render::FramePlan plan = test::planned(shot.museum, shot.sceneState, shot.request.frame);
    EXPECT_EQ(test::reasonFor(plan, "ball"), "out of view");
    EXPECT_EQ(test::reasonFor(plan, "ball/shadow"), "sun shadows are switched off");
    EXPECT_FALSE(test::runs(plan, "ball"));
    for (const render::CulledPass& skipped : plan.skipped())
        EXPECT_TRUE(skipped.name == "ball/shadow" || !skipped.name.starts_with("ball/")) << skipped.name;
}

TEST(LongBallOnPaper, StandsBesideTheOthersAndLeavesThemAsTheyAre)
{
    auto list = allExhibits();
    list.push_back(std::make_unique<test::Ball>(5, test::ballShaders()));
    const Museum museum(std::move(list));
    BallShot shot(museum);
    shot.inHall();
    const render::FramePlan plan = test::planned(museum, shot.sceneState, shot.request.frame);
    EXPECT_TRUE(test::runs(plan, "ball/march"));
    EXPECT_EQ(plan.errors(), std::vector<std::string>());

    test::Scene scene;  // The same museum without the ball, and the best view of another exhibit.
    shot.request.frame = scene.request;
    SceneState state = museum.initialSceneState();
    state.values[hallIndex].set(hallTable().spotStrength, 0.0);  // A spotlight at the ball is one light more for all.
    scene.hall().set(hallTable().spotStrength, 0.0);
    const render::FramePlan with = test::planned(museum, state, shot.request.frame);
    const render::FramePlan without = scene.plan();
    const auto march = [](const render::FramePlan& p) { return p.find("sdf_morph/march"); };
    ASSERT_TRUE(march(with) && march(without));
    EXPECT_EQ(march(with)->shader, march(without)->shader);
    EXPECT_EQ(march(with)->blocks, march(without)->blocks);
}

TEST(BallOnPaper, SaysHowItsDepthAloneIsFound)
{
    BallShot shot;
    const render::FramePlan plan = test::planned(shot.museum, shot.sceneState, shot.request.frame);
    const render::Pass* march = plan.find("ball/march");
    ASSERT_TRUE(march && march->depthOnly);
    EXPECT_EQ(march->depthOnly->shader.sources, march->shader.sources) << "by the same field";
    const std::vector<std::string> needed{"SHADOW_METHOD 0", "CONE_PREPASS 8", "DEPTH_ONLY"};
    EXPECT_EQ(march->depthOnly->shader.defines, needed) << "and no permutations of the light";
    ASSERT_EQ(march->depthOnly->inputs.size(), 1U) << "the cones, and no light";
    EXPECT_EQ(std::get<std::string>(march->depthOnly->inputs.front().source), "ball.cone");
}

TEST(BallOnPaper, IsPointedAtWhereItsSphereIs)
{
    const test::Ball ball;
    const ParameterValues values = ballTable().initial();
    const ExhibitState state{values};
    EXPECT_NEAR(ball.firstHit(state, {{0, 0, 2}, {0, 0, -1}}), 1.7, 2e-4);
    EXPECT_NEAR(ball.firstHit(state, {{0, 0, 2}, {0, 0, -0.5}}), 3.4, 4e-4);
    EXPECT_EQ(ball.firstHit(state, {{0, 0.31, 2}, {0, 0, -1}}), std::numeric_limits<double>::infinity());
}

/// An exhibit without a place leaves the hall as it is, and is shown alone.
TEST(BallInTheDepot, IsShownAloneAndNotInTheHall)
{
    std::vector<std::unique_ptr<Exhibit>> exhibits;
    exhibits.push_back(std::make_unique<test::Ball>(0));
    const Museum museum(std::move(exhibits));
    EXPECT_FALSE(museum.isInHall(1));
    const SceneState sceneState = museum.initialSceneState();
    FrameRequest request;
    request.camera = sceneState.camera;
    request.raster.size = {64, 36};
    const auto ofBall = [](const render::FramePlan& plan) {
        return std::count_if(plan.passes().begin(), plan.passes().end(),
                             [](const render::Pass& pass) { return pass.name.starts_with("ball"); });
    };
    const render::FramePlan hall = test::planned(museum, sceneState, request);
    EXPECT_EQ(ofBall(hall), 0);
    EXPECT_TRUE(std::any_of(hall.skipped().begin(), hall.skipped().end(), [](const render::CulledPass& pass) {
        return pass.name == "ball" && pass.reason == "it is not placed in the hall";
    }));
    request.alone = 1;
    request.camera = museum.bestView(1, sceneState.values[1]);
    EXPECT_GT(ofBall(test::planned(museum, sceneState, request)), 0);
}

}  // namespace
}  // namespace vitrine
