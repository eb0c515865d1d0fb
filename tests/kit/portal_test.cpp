// A world behind a deep frame: what is seen of it, where, and what hides it, against the projection at float64.

#include "tests/kit/ball_shot.h"
#include "tests/kit/floor/floor.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine {
namespace {

using glm::dvec3;
using namespace test;

}  // namespace

Portal test::Floor::portal()
{
    Portal portal;
    portal.workFromExhibit =
        glm::scale(glm::rotate(glm::translate(glm::dmat4(1), dvec3(0.3, 0.4, 7)), 0.3, dvec3(0, 1, 0)), dvec3(3));
    return portal;
}

namespace {

const Museum& floorMuseum()
{
    static const auto opened = [] {
        std::ifstream file(std::filesystem::path(VITRINE_SOURCE_DIR) / "tests/kit/floor/floor.frag");
        auto shaders = std::make_shared<render::ShaderSources>(
            std::map<std::string, std::string>{{"floor/floor.frag", {std::istreambuf_iterator<char>(file), {}}}});
        return test::museumOf(std::make_unique<test::Floor>(shaders));
    }();
    return *opened;
}

/// Appearance of the floor on a ray beyond `start` meters, at float64.
struct Seen {
    dvec3 color{0, 0, 0.5};
    double distance = std::numeric_limits<double>::infinity();  ///< Distance of the hall, in meters.
    bool nearEdge = false;  ///< The point is near the edge of a square of the floor: rounding decides.
};

Seen seenAlong(const dvec3& eye, const dvec3& ray, const glm::dmat4& worldFromExhibit, double pixel, double start)
{
    const glm::dmat4 work = test::Floor::portal().workFromExhibit * glm::inverse(worldFromExhibit);
    const dvec3 origin(work * glm::dvec4(eye, 1));
    const dvec3 direction = glm::normalize(dvec3(work * glm::dvec4(ray, 0)));
    const double t = (-1 - origin.y) / direction.y;
    Seen seen;
    seen.nearEdge = std::abs(direction.y) < pixel;
    if (!(direction.y < 0) || t <= 3 * start) return seen;
    const dvec3 p = origin + direction * t;
    const double blur = pixel * t / -direction.y * 0.02 + 1e-4;
    const auto fromEdge = [](double x) { return std::abs(x - std::round(x)); };
    seen.nearEdge = seen.nearEdge || fromEdge(p.x) < blur || fromEdge(p.z) < blur || blur > 0.1;
    const double square = std::fmod(std::abs(std::floor(p.x) + std::floor(p.z)), 2.0);
    seen.color = {square, 0.25, 0};
    seen.distance = t / 3;
    return seen;
}

class PortalTest : public test::GlTest {
protected:
    static BallShot shot()
    {
        BallShot shot(floorMuseum(), "floor");
        shot.request.frame.raster.size = {160, 100};
        return shot;
    }
};

TEST_F(PortalTest, ShowsTheWorldBeyondInTheVisitorsPerspective)
{
    constexpr double adaptation = 7.5;  // Adaptation of the hall.
    for (const dvec3& eye : {dvec3(0, 0, 1.5), dvec3(1.2, -0.2, 1.0), dvec3(-2.5, 0.4, 3)}) {
        BallShot s = shot();
        s.inHall();
        const glm::dmat4 world = s.worldFromExhibit();
        s.request.frame.camera = {dvec3(world * glm::dvec4(eye, 1)), dvec3(world * glm::dvec4(0, 0, 0, 1)), 0.9};
        const Picture p = s.take();
        int open = 0, hidden = 0, wrong = 0, wrongDepth = 0, leaked = 0;
        p.each([&](int x, int y) {
            const dvec3 ray = p.ray(x, y);
            const dvec3 d(glm::inverse(world) * glm::dvec4(ray, 0));
            const auto at = [&](double z) { return eye + d * ((z - eye.z) / d.z); };
            const double margin = 0.02;
            const auto inside = [&](const dvec3& q, double by) {
                return std::abs(q.x) < 1.2 + by && std::abs(q.y) < 0.8 + by;
            };
            // The mouth of the frame is a little narrower than the recess, and stands out by 7 cm.
            const bool through = d.z < 0 && inside(at(-0.495), -margin) && inside(at(0.09), -margin - 0.03);
            const bool beside = d.z >= 0 || !inside(at(-0.495), margin) || !inside(at(0.0), margin);
            const Seen seen =
                seenAlong(p.view.eye, ray, world, p.view.tanHalfFov.y * 2 / p.height(), glm::length(at(-0.495) - eye));
            const dvec3 color = p.color(x, y) * adaptation;
            if (through) {
                ++open;
                wrong += !seen.nearEdge && glm::length(color - seen.color) > 2e-3;
                wrongDepth += std::abs(p.depth(x, y) * glm::length(ray) - glm::length(at(-0.495) - eye)) > 2e-3;
            } else if (beside) {
                ++hidden;
                leaked += glm::length(color - seen.color) < 2e-3;
            }
        });
        EXPECT_GT(open, 300);
        EXPECT_GT(hidden, 300);
        EXPECT_EQ(wrong, 0) << "of " << open;
        EXPECT_EQ(wrongDepth, 0);
        EXPECT_EQ(leaked, 0) << "outside the frame";
    }
}

TEST_F(PortalTest, FillsThePictureWhereItStandsAloneWithDepthAndNormals)
{
    BallShot s = shot();
    s.request.frame.camera = {{0.2, 0.1, 1.5}, {0, -0.1, -0.5}, 1.2};
    s.request.frame.channels.evaluations = true;
    const Picture p = s.take();
    int floor = 0, wrong = 0;
    p.each([&](int x, int y) {
        const dvec3 ray = p.ray(x, y);
        const Seen seen = seenAlong(p.view.eye, ray, glm::dmat4(1), p.view.tanHalfFov.y * 2 / p.height(), 0);
        ASSERT_TRUE(p.hit(x, y));
        if (seen.nearEdge) return;
        wrong += glm::length(p.color(x, y) * 1.04 - seen.color) > 2e-3;
        if (!std::isfinite(seen.distance)) return;
        ++floor;
        EXPECT_NEAR(p.depth(x, y) * glm::length(ray) / seen.distance, 1, 1e-3);
        EXPECT_GT(p.normal(x, y).y, 0.999);
    });
    EXPECT_GT(floor, 1000);
    EXPECT_EQ(wrong, 0);
}

TEST_F(PortalTest, IsTheSameInTheLightOfNoonAndOfNight)
{
    BallShot s = shot();
    s.inHall();
    s.hall().set(test::hallTable().spotStrength, 0.0);
    const Picture day = s.take();
    s.hall().set(test::hallTable().sunStrength, 0.0);
    s.hall().set(test::hallTable().skyStrength, 0.1);
    const Picture night = s.take();
    EXPECT_EQ(day.color(80, 60), night.color(80, 60));
    EXPECT_LT(night.luminance(2, 2), 0.5 * day.luminance(2, 2)) << "the wall is not";
    s.values().set(test::FloorTable().green, 0.75);
    EXPECT_NEAR(s.take().color(80, 60).y, 3 * day.color(80, 60).y, 1e-3);
}

TEST_F(PortalTest, IsNotDrawnWhereItsOpeningIsOutOfView)
{
    BallShot s = shot();
    s.inHall();
    const dvec3 eye = s.request.frame.camera.eye;
    s.request.frame.camera.target = 2.0 * eye - s.request.frame.camera.target;
    const Museum& museum = floorMuseum();
    const Prepared prepared = museum.prepare(s.sceneState, s.request.frame);
    const render::FramePlan plan = museum.plan(prepared, s.request.frame, {});
    EXPECT_EQ(plan.find("floor/world"), nullptr);
    ASSERT_NE(plan.findSkipped("floor"), nullptr);
    EXPECT_EQ(plan.findSkipped("floor")->reason, "out of view");
}

}  // namespace
}  // namespace vitrine
