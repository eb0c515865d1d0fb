// The ledger's promises: running everything changes no bit of any picture, and what is off is not there.

#include "tests/gl/gallery.h"

namespace vitrine {
namespace {

using namespace test;

using Ledger = GlTest;

/// The exhibit (or the hall, 0) from its best view, small; shadow map and probe small.
Shot shotOf(std::size_t exhibit, bool alone)
{
    Shot shot;
    FrameRequest& frame = shot.request.frame;
    frame.transparent = false;
    frame.averageIn = AverageIn::display;
    frame.raster.size = {64, 36};
    frame.alone = alone ? std::optional(exhibit) : std::nullopt;
    frame.subject = alone || exhibit == 0 ? std::nullopt : std::optional(exhibit);
    const Museum& museum = gallery().museum;
    frame.camera = alone || exhibit == 0 ? museum.exhibits()[exhibit]->bestView(shot.look.values[exhibit]) : museum.bestView(exhibit, shot.look.values[exhibit]);
    return shot;
}

double changeByRunningEverything(Shot shot)
{
    const Picture needed = shot.take();
    shot.request.frame.runEverything = true;
    const Picture everything = shot.take();
    EXPECT_GT(needed.mean(), 0.001) << "an empty picture proves nothing";
    return largestDifference(everything.image, needed.image);
}

TEST_F(Ledger, RunningEverythingChangesNoBitOfTheHall)
{
    EXPECT_EQ(changeByRunningEverything(shotOf(0, false)), 0);
}

TEST_F(Ledger, RunningEverythingChangesNoBitOfAnyExhibit)
{
    const Museum& museum = gallery().museum;
    for (std::size_t i = 1; i < museum.exhibits().size(); ++i) {
        EXPECT_EQ(changeByRunningEverything(shotOf(i, false)), 0) << museum.exhibits()[i]->name() << " in the hall";
        EXPECT_EQ(changeByRunningEverything(shotOf(i, true)), 0) << museum.exhibits()[i]->name() << " alone";
    }
}

/// What a renderer of its own holds after this picture.
std::map<std::string, std::int64_t> heldFor(const Shot& shot)
{
    render::gl::Renderer renderer;
    return renderer.draw(gallery().museum.plan(shot.look, shot.request.frame, renderer.kept())).counters;
}

TEST_F(Ledger, AnEffectThatIsOffHasNoPassNoProgramAndNoTexture)
{
    Shot on = shotOf(gallery().museum.find("sdf_morph").value(), true);
    Shot off = on;
    on.object().set(sdfTable().conePrepass, true);
    off.object().set(sdfTable().conePrepass, false);
    auto with = heldFor(on);
    auto without = heldFor(off);
    EXPECT_EQ(with["passes"], without["passes"] + 1);
    EXPECT_EQ(with["programs"], without["programs"] + 1);
    EXPECT_EQ(with["images"], without["images"] + 1);
}

TEST_F(Ledger, SwitchedOffWhileItRunsAnEffectGivesItsTextureBack)
{
    Shot shot = shotOf(gallery().museum.find("sdf_morph").value(), true);
    render::gl::Renderer renderer;
    const auto images = [&](bool prepass) {
        shot.object().set(sdfTable().conePrepass, prepass);
        std::int64_t held = 0;
        // Images are given back a few frames after they were last wanted.
        for (int frame = 0; frame < 12; ++frame) held = renderer.draw(gallery().museum.plan(shot.look, shot.request.frame, renderer.kept())).counters.at("images");
        return held;
    };
    const std::int64_t with = images(true);
    EXPECT_EQ(images(false), with - 1);
    EXPECT_EQ(images(true), with);
}

TEST_F(Ledger, ASunOfNoStrengthCastsNoShadowPass)
{
    Shot shot = shotOf(0, false);
    shot.hall().set(hallTable().sunStrength, 0.0);
    const render::FramePlan plan = gallery().museum.plan(shot.look, shot.request.frame);
    EXPECT_EQ(plan.find("hall/shadow"), nullptr);
    ASSERT_NE(plan.findSkipped("hall/shadow"), nullptr);
    EXPECT_TRUE(plan.findSkipped("hall/shadow")->boundIsZero);
    EXPECT_EQ(plan.findSkipped("hall/shadow")->reason, "the sun's strength is 0");
    EXPECT_EQ(changeByRunningEverything(shot), 0);
}

}  // namespace
}  // namespace vitrine
