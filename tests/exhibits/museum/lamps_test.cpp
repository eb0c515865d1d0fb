// Lamps of exhibits: collected by the museum, drawn into shadow maps, and lighting the picture.
#include "exhibits/framework/scene/capabilities.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <set>

namespace vitrine {
namespace {

class LampsTest : public test::GlTest {};

struct BulbTable final : Parameters {
    Real strength = real("strength", 4, none, {0, 100}, "W/sr.");
    Toggle shadow = toggle("shadow", true, "Whether it throws shadows.");
    Toggle moves = toggle("moves", false, "Whether anything moves.");
    Toggle pulses = toggle("pulses", true, "Whether its light does.");
};

/// Exhibit with a lamp and nothing visible.
class Bulb final : public Exhibit, public HasLocalLights {
public:
    [[nodiscard]] std::string_view name() const override { return "bulb"; }
    [[nodiscard]] std::string_view title() const override { return "Bulb"; }
    [[nodiscard]] std::string_view summary() const override { return "A lamp."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const Parameters& parameters() const override { return table; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override
    {
        return {glm::dvec3(-0.05), glm::dvec3(0.05)};
    }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 1, 4}, {0, 0, 0}, 0.9}; }
    [[nodiscard]] double nextChange(const ParameterValues& values, double) const override
    {
        return values[table.moves] ? 0 : INFINITY;
    }
    [[nodiscard]] std::vector<render::LocalLight> localLights(const ExhibitState& state) const override
    {
        // The period of its pulse is the difference of the times that a test compares.
        const double pulse = state.values[table.moves] && state.values[table.pulses]
                                 ? 1.5 + std::sin(2 * std::numbers::pi * state.time / period)
                                 : 1;
        return {{.position = {0, 2, 0},
                 .intensity = glm::dvec3(pulse * state.values[table.strength]),
                 .castsShadow = state.values[table.shadow]}};
    }
    [[nodiscard]] bool lightsChange(const ExhibitState& state) const override { return state.values[table.pulses]; }

    static constexpr double period = 0.37;  ///< Period in seconds.

    inline static const BulbTable table;
};

/// The bulb above the middle of the hall, without sun, sky and reflections, so that only its light is visible.
struct BulbHall {
    BulbHall() : museum(exhibits())
    {
        sceneState = museum.initialSceneState();
        sceneState.hall().set(test::hallTable().sunStrength, 0.0);
        sceneState.hall().set(test::hallTable().skyStrength, 0.0);
        sceneState.hall().set(test::hallTable().reflectionProbe, false);
        sceneState.hall().set(test::hallTable().bakedLight, false);
        sceneState.hall().set(test::hallTable().shadowMapSize, 256);
        frame.raster.size = {96, 54};
        frame.averageIn = AverageIn::radiance;
        see({0, 8, 2.2}, {0, 0, 2});
    }
    static std::vector<std::unique_ptr<Exhibit>> exhibits()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<Bulb>());
        return all;
    }
    void see(const glm::dvec3& eye, const glm::dvec3& target) { sceneState.camera = frame.camera = {eye, target, 0.6}; }
    [[nodiscard]] ParameterValues& bulb() { return sceneState.values[1]; }
    [[nodiscard]] render::FramePlan plan(const render::PersistentState& kept = {})
    {
        return test::planned(museum, sceneState, frame, kept);
    }
    [[nodiscard]] render::Image draw(render::gl::Renderer& renderer)
    {
        (void)renderer.draw(plan(renderer.persistentState()));
        return renderer.read("frame");
    }

    Museum museum;
    SceneState sceneState;
    FrameRequest frame;
};

std::set<std::string> lampPasses(const render::FramePlan& plan)
{
    std::set<std::string> names;
    for (const render::Pass& pass : plan.passes())
        if (pass.name.rfind("lamps/", 0) == 0) names.insert(pass.name);
    return names;
}

using LongLampsTest = LampsTest;

TEST_F(LampsTest, CostNothingWhereThereIsNone)
{
    test::Shot shot;
    shot.inHall();
    // The lamps are the glow of the lanterns' frame, those above the pit and in front of the card, and picture lights.
    EXPECT_FALSE(test::planned(test::gallery().museum, shot.sceneState, shot.request.frame).findSkipped("lamps"));
    for (const auto& [exhibit, row] :
         {std::pair("paper_lanterns", "hallGlow"), {"fur", "lamp"}, {"lenticular", "lamp"}}) {
        ParameterValues& values = shot.sceneState.values[test::gallery().museum.find(exhibit).value()];
        values.setParameter(values.table().find(row).value(), 0.0);
    }
    shot.hall().setParameter(shot.hall().table().find("spotStrength").value(), 0.0);
    const render::FramePlan plan = test::planned(test::gallery().museum, shot.sceneState, shot.request.frame);
    EXPECT_TRUE(lampPasses(plan).empty());
    ASSERT_TRUE(plan.findSkipped("lamps"));
    EXPECT_EQ(plan.findSkipped("lamps")->reason, "no lamp shines here");
    for (const render::Pass& pass : plan.passes())
        for (const std::string& define : pass.shader.defines) EXPECT_NE(define, "LOCAL_LIGHTS") << pass.name;
}

TEST_F(LampsTest, ThatAreOffCostNothingAndThoseWithoutShadowsNoMaps)
{
    BulbHall hall;
    hall.bulb().set(Bulb::table.shadow, false);
    EXPECT_TRUE(lampPasses(hall.plan()).empty());
    EXPECT_EQ(hall.plan().findSkipped("lamps/shadow")->reason, "no lamp throws shadows");
    hall.bulb().set(Bulb::table.strength, 0.0);
    EXPECT_EQ(hall.plan().findSkipped("lamps")->reason, "no lamp shines here");
}

TEST_F(LampsTest, KeepTheirShadowMapsWhileNothingInThemChanges)
{
    BulbHall hall;
    render::gl::Renderer renderer;
    (void)hall.draw(renderer);
    EXPECT_GE(lampPasses(hall.plan()).size(), 6U);
    EXPECT_TRUE(lampPasses(hall.plan(renderer.persistentState())).empty());
    hall.see({1, 8, 2.2}, {0, 0, 2});
    EXPECT_TRUE(lampPasses(hall.plan(renderer.persistentState())).empty()) << "the eye moved, the shadows did not";
    hall.bulb().set(Bulb::table.strength, 5.0);
    EXPECT_FALSE(lampPasses(hall.plan(renderer.persistentState())).empty()) << "its exhibit changed";
}

TEST_F(LampsTest, GiveSurfacesLightInProportionToTheirStrength)
{
    BulbHall hall;
    hall.bulb().set(Bulb::table.shadow, false);
    render::gl::Renderer renderer;
    const render::Image lit = hall.draw(renderer);
    hall.bulb().set(Bulb::table.strength, 0.0);
    const render::Image dark = hall.draw(renderer);
    hall.bulb().set(Bulb::table.strength, 8.0);
    const render::Image twice = hall.draw(renderer);
    double most = 0;
    for (int y = 0; y < lit.height; ++y) {
        for (int x = 0; x < lit.width; ++x) {
            const double one = static_cast<double>(lit.at(x, y, 1)) - static_cast<double>(dark.at(x, y, 1));
            const double two = static_cast<double>(twice.at(x, y, 1)) - static_cast<double>(dark.at(x, y, 1));
            most = std::max(most, one);
            EXPECT_NEAR(two, 2 * one, 1e-3 + 4e-3 * two) << x << ',' << y;
        }
    }
    EXPECT_GT(most, 0.01);
}

TEST_F(LampsTest, ThrowTheShadowOfThePlinth)
{
    // The lamp hangs over the plinth of place 1, 0.8 m wide and 0.9 m high. From 3.45 m the plinth shades the floor up
    // to 0.4 * 3.45 / (3.45 - 0.9) = 0.54 m from the center.
    BulbHall hall;
    hall.see({1.6, 6, 0.01}, {0.9, 0, 0});
    render::gl::Renderer renderer;
    const render::Image shadowed = hall.draw(renderer);
    hall.bulb().set(Bulb::table.shadow, false);
    const render::Image open = hall.draw(renderer);
    const render::View view = render::makeView(hall.frame.camera, hall.frame.raster);
    const auto at = [&](const render::Image& image, const glm::dvec3& world) {
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
        const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.raster.size);
        return static_cast<double>(
            image.at(static_cast<int>(pixel.x), image.height - 1 - static_cast<int>(pixel.y), 1));
    };
    EXPECT_LT(at(shadowed, {0.47, 0, 0}), 0.3 * at(open, {0.47, 0, 0})) << "beside the plinth, in its shadow";
    for (const double x : {0.75, 1.2, 1.6}) {
        EXPECT_GT(at(open, {x, 0, -0.2}), 0);
        EXPECT_NEAR(at(shadowed, {x, 0, -0.2}), at(open, {x, 0, -0.2}), 0.02 * at(open, {x, 0, -0.2})) << x;
    }
}

TEST_F(LampsTest, ThatChangeChangeTheWholePictureAndOthersOnlyTheirExhibit)
{
    BulbHall hall;
    hall.bulb().set(Bulb::table.shadow, false);
    hall.bulb().set(Bulb::table.moves, true);
    // From the side, so that the bulb is in view.
    hall.see({0, 1.6, 5}, {0, 1.2, 0});
    const auto region = [&] {
        return hall.museum.movingRegion(hall.museum.prepare(hall.sceneState, hall.frame), hall.frame);
    };
    EXPECT_FALSE(region().has_value());
    hall.bulb().set(Bulb::table.pulses, false);
    ASSERT_TRUE(region().has_value());
    EXPECT_LT(region()->size.x * region()->size.y, 96 * 54);
    // Control: after a whole period, the lamps are the same.
    hall.bulb().set(Bulb::table.pulses, true);
    const Bulb bulb;
    const ExhibitState now{hall.bulb(), 1}, later{hall.bulb(), 1 + Bulb::period};
    EXPECT_NEAR(bulb.localLights(now)[0].intensity.x, bulb.localLights(later)[0].intensity.x, 1e-9);
}

TEST_F(LampsTest, AreSeenByTheProbeWhereTimeDoesNotChangeThem)
{
    BulbHall hall;
    hall.sceneState.hall().set(test::hallTable().reflectionProbe, true);
    hall.sceneState.hall().set(test::hallTable().probeSize, 16);
    const auto lit = [&] {
        const render::FramePlan plan = hall.plan();
        const render::Pass* walls = plan.find("probe/walls/0");
        return walls && std::find(walls->shader.defines.begin(), walls->shader.defines.end(), "LOCAL_LIGHTS") !=
                            walls->shader.defines.end();
    };
    EXPECT_FALSE(lit());
    hall.bulb().set(Bulb::table.pulses, false);
    EXPECT_TRUE(lit());
    const std::optional<std::uint64_t> key = hall.plan().find("probe/walls/0")->contentHash;
    hall.see({1, 8, 2.2}, {0, 0, 2});
    EXPECT_EQ(hall.plan().find("probe/walls/0")->contentHash, key) << "the eye moved, the lamp did not";
    hall.bulb().set(Bulb::table.strength, 5.0);
    EXPECT_NE(hall.plan().find("probe/walls/0")->contentHash, key);
}

TEST_F(LongLampsTest, OfExhibitsLightWhatIsNearThem)
{
    // At night, from above: the lamp's light on the pad around the pit, on the floor beside it, and farther away.
    test::Shot shot;
    shot.inHall();
    shot.size(96, 96);
    shot.request.frame.averageIn = AverageIn::radiance;
    shot.see({3.3, 8.5, 3.01}, {3.3, 0, 3});
    shot.request.frame.camera.fovY = 1.1;
    shot.hall().set(test::hallTable().sunStrength, 0.0);
    ParameterValues& fur = shot.sceneState.values[*test::gallery().museum.find("fur")];
    const test::Picture lit = shot.take();
    fur.setParameter(fur.table().find("lamp").value(), 0.0);
    const test::Picture dark = shot.take();
    const auto added = [&](double x, double y, double z) {
        const glm::dvec4 clip = lit.view.clipFromWorld * glm::dvec4(x, y, z, 1);
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        const int column = static_cast<int>((ndc.x * 0.5 + 0.5) * lit.width());
        const int row = static_cast<int>((0.5 - ndc.y * 0.5) * lit.height());
        return lit.luminance(column, row) / dark.luminance(column, row) - 1;
    };
    EXPECT_GT(added(3.3 - 1.2, 0.18, 3 - 1.2), 0.5) << "the pad";
    EXPECT_GT(added(3.3 - 1.5, 0, 3 - 1.5), 0.2) << "the floor beside it";
    EXPECT_NEAR(added(0.2, 0, 4.6), 0, 0.01) << "but not the middle of the hall";
}

}  // namespace
}  // namespace vitrine
