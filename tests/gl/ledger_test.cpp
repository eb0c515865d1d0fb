// The ledger's promises: running everything changes no bit of any picture, and what is off is not there.

#include "tests/gl/gallery.h"

#include <algorithm>
#include <functional>
#include <set>

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

/// How many different programs a plan draws with.
std::size_t programsOf(const render::FramePlan& plan)
{
    std::set<std::string> programs;
    for (const render::Pass& pass : plan.passes()) {
        std::string program = pass.shader.vertex + ' ' + pass.shader.fragment + ' ' + pass.shader.compute;
        for (const std::string& define : pass.shader.defines) program += ' ' + define;
        programs.insert(std::move(program));
    }
    return programs.size();
}

/// An effect, what its passes and images are called, and its switch.
struct Switched {
    const char* passes;
    const char* image;
    std::size_t exhibit;
    bool alone;
    std::function<void(Shot&, bool on)> with;
};

TEST_F(Ledger, AnEffectThatIsOffHasNoPassNoProgramAndNoTexture)
{
    const Museum& museum = gallery().museum;
    const std::size_t sdf = *museum.find("sdf_morph");
    const std::size_t rays = *museum.find("crepuscular_rays");
    const auto beams = [rays](RayTechnique technique) {
        return [=](Shot& s, bool on) { s.look.values[rays].set(raysTable().technique, on ? technique : RayTechnique::none); };
    };
    const Switched effects[] = {
        {"sdf_morph/cone", "sdf_morph.cone", sdf, true, [](Shot& s, bool on) { s.object().set(sdfTable().conePrepass, on); }},
        {"hall/shadow", "shadow.hall", 0, false, [](Shot& s, bool on) { s.hall().set(hallTable().sunShadows, on); }},
        {"probe/", "probe", 0, false, [](Shot& s, bool on) { s.hall().set(hallTable().reflectionProbe, on); }},
        {"crepuscular_rays/mask", "crepuscular_rays.mask", rays, false, beams(RayTechnique::screen)},
        {"crepuscular_rays/", "crepuscular_rays.scattered", rays, false, beams(RayTechnique::volume)},
    };
    for (const Switched& effect : effects) {
        SCOPED_TRACE(effect.passes);
        Shot on = shotOf(effect.exhibit, effect.alone);
        Shot off = on;
        effect.with(on, true);
        effect.with(off, false);
        const render::FramePlan with = museum.plan(on.look, on.request.frame);
        const render::FramePlan without = museum.plan(off.look, off.request.frame);
        const auto passes = [&](const render::FramePlan& plan) {
            return std::count_if(plan.passes().begin(), plan.passes().end(), [&](const render::Pass& pass) { return pass.name.starts_with(effect.passes); });
        };
        EXPECT_GE(passes(with), 1);
        EXPECT_EQ(passes(without), 0);
        EXPECT_TRUE(with.images().contains(effect.image));
        EXPECT_FALSE(without.images().contains(effect.image));
        EXPECT_GT(programsOf(with), programsOf(without));
        if (!effect.alone) continue;
        // And what the plan says is what is held.
        auto held = heldFor(on);
        auto heldOff = heldFor(off);
        EXPECT_EQ(held["passes"], heldOff["passes"] + static_cast<std::int64_t>(with.passes().size() - without.passes().size()));
        EXPECT_EQ(held["programs"], heldOff["programs"] + static_cast<std::int64_t>(programsOf(with) - programsOf(without)));
        EXPECT_EQ(held["images"], heldOff["images"] + static_cast<std::int64_t>(with.images().size() - without.images().size()));
    }
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
