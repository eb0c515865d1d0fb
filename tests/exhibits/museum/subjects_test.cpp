// Tables of a museum, and optional capabilities of its exhibits.
#include "tests/support/museum_on_paper.h"

#include <cmath>
#include <memory>

namespace vitrine {
namespace {

/// Exhibit in the middle of the hall, in the sunlight of the window, that draws nothing.
class Bare : public Exhibit {
public:
    [[nodiscard]] std::string_view name() const override { return "bare"; }
    [[nodiscard]] std::string_view title() const override { return "Bare"; }
    [[nodiscard]] std::string_view summary() const override { return "Does nothing."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const Parameters& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override
    {
        return {{-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3}};
    }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override
    {
        return {{0.2, 0.1, 1.6}, {0, -0.3, 0}, 0.9};
    }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return INFINITY; }

private:
    struct Table final : Parameters {
        Real size = real("size", 1, none, {0, 1}, "Of nothing.");
    } table_;
};

/// The same with a pass over the frame.
class Glow final : public Bare, public OverFrame {
public:
    void planOverFrame(const PlanContext&, render::FramePlan& plan) const override
    {
        plan.skip("bare/glow", "it was asked");
    }
};

class WithButton final : public Bare, public HasButton {
public:
    [[nodiscard]] std::string_view buttonText() const override { return "do nothing"; }
};

template <typename Kind> Museum museumOf()
{
    std::vector<std::unique_ptr<Exhibit>> exhibits;
    exhibits.push_back(std::make_unique<Kind>());
    return Museum(std::move(exhibits));
}

/// Returns a plan from its best view.
render::FramePlan planOf(const Museum& museum)
{
    SceneState sceneState = museum.initialSceneState();
    test::letTheSunIn(sceneState.hall());
    FrameRequest request;
    request.raster.size = {64, 36};
    request.camera = museum.bestView(1, sceneState.values[1]);
    return test::planned(museum, sceneState, request);
}

TEST(Subjects, AreTheHallAndTheExhibitsInOrder)
{
    const Museum& museum = test::museum();
    const SceneState sceneState = museum.initialSceneState();
    ASSERT_EQ(museum.subjects().size(), museum.exhibits().size() + 1);
    ASSERT_EQ(sceneState.values.size(), museum.subjects().size());
    EXPECT_EQ(&museum.subject(hallIndex), &museum.hall());
    EXPECT_FALSE(capability<Exhibit>(museum.hall())) << "the building is no exhibit";
    for (const auto& [i, exhibit] : museum.exhibits()) {
        EXPECT_EQ(&museum.subject(i), &exhibit);
        EXPECT_EQ(&museum.exhibit(i), &exhibit);
    }
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        EXPECT_EQ(museum.find(museum.subject(i).name()), i);
        EXPECT_EQ(&sceneState.values[i].table(), &museum.subject(i).parameters()) << museum.subject(i).name();
    }
    EXPECT_EQ(museum.bestView(hallIndex, sceneState.hall()), museum.hall().bestView(sceneState.hall()));
}

TEST(Capabilities, AreWhatAnExhibitHasAndNothingElse)
{
    const render::FramePlan bare = planOf(museumOf<Bare>());
    EXPECT_TRUE(bare.find("exhibits/shadow"));
    EXPECT_EQ(bare.findSkipped("hall/buttons")->reason, "no button is in view");
    EXPECT_FALSE(bare.findSkipped("bare/glow"));

    const render::FramePlan withButton = planOf(museumOf<WithButton>());
    EXPECT_TRUE(withButton.find("hall/buttons"));
    EXPECT_TRUE(withButton.find("exhibits/shadow"));

    const render::FramePlan glow = planOf(museumOf<Glow>());
    ASSERT_TRUE(glow.findSkipped("exhibits/shadow"));
    EXPECT_EQ(glow.findSkipped("exhibits/shadow")->reason, "it is made of light");
    EXPECT_TRUE(glow.findSkipped("bare/glow"));
}

/// The part of a picture of 16:9 that a rectangle takes in the exhibit's best view; 0 if it does not fit.
double partOfTheView(const Exhibit& exhibit, const glm::dvec2& half, double z)
{
    const render::Camera camera = exhibit.bestView(exhibit.parameters().initial());
    const double reach = (camera.eye.z - z) * std::tan(0.5 * camera.fovY);
    const double high = half.y / reach, wide = half.x / (reach * 16 / 9);
    return high > 1 || wide > 1 ? 0 : high * wide;
}

TEST(BestViews, ShowTheWorkAndLittleOfItsFrame)
{
    for (const char* name : {"noise", "paper_lanterns", "sdf_scenes"}) {
        const Exhibit& exhibit = museum().exhibit(*museum().find(name));
        const render::Box box = exhibit.bounds(exhibit.parameters().initial());
        EXPECT_GE(partOfTheView(exhibit, 0.5 * glm::dvec2(box.high - box.low), box.low.z), 0.75) << name;
    }
    // The opening of the pixel art is larger than its screen.
    EXPECT_GE(partOfTheView(museum().exhibit(*museum().find("pixel_art")), {1.12, 0.63}, -0.545), 0.75);
}

}  // namespace
}  // namespace vitrine
