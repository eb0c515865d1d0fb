// Change by an effect, measured with and without it, compared with the bound that its plan states. Settings are random
// and seeded.

#include "exhibits/framework/table/random_values.h"
#include "exhibits/lenticular/lenticular_table.h"
#include "tests/support/degree.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <cstdio>
#include <functional>

namespace vitrine {
namespace {

using namespace test;

using BoundsOfEffects = GlTest;

/// Half floats have eleven binary digits, and sums in a picture are rounded several times.
constexpr double halfFloat = 4.0 / 2048;

/// Picture with random settings, with and without an effect.
struct Case {
    std::string exhibit;       ///< Exhibit, or "hall".
    std::string passOrEffect;  ///< Pass or effect whose bound is tested; a plan without it proves nothing.
    std::function<void(Shot&, bool on)> with;
    bool inHall = true;
    std::function<void(Shot&)> prepare = {};  ///< Called after the random settings, to make the effect visible.
    /// Least part of its bound that the effect must reach in one of the settings. Few pictures come near to a bound
    /// that also holds for a mirror in the sun; such cases require less.
    double leastPart = 0.01;
    std::optional<render::Camera> camera = {};  ///< Camera in the hall's space; by default, the exhibit's best view.
};

ParameterValues& valuesOf(Shot& shot, std::string_view exhibit)
{
    return shot.sceneState.values[*gallery().museum.find(exhibit)];
}

std::optional<render::ContributionBound> boundIn(const render::FramePlan& plan, const std::string& name)
{
    for (const render::Pass& pass : plan.passes()) {
        if (pass.name == name) return pass.bound;
        for (const render::Effect& effect : pass.effects)
            if (effect.name == name) return effect.bound;
    }
    return std::nullopt;
}

Shot shotOf(const Case& c, std::uint64_t seed)
{
    const Museum& museum = gallery().museum;
    RandomNumbers random(seed);
    Shot shot;
    // Random values only where the effects depend on them.
    ParameterValues& hall = shot.hall();
    hall.set(hallTable().sunStrength, random.number(0.1, 12));
    hall.set(hallTable().skyStrength, random.number(0, 4));
    hall.set(hallTable().exposure, random.number(-1, 1));
    hall.set(hallTable().sunElevation, random.number(0.2, 0.8));
    hall.set(hallTable().sunAzimuth, random.number(-0.4, 0.4));
    const std::size_t index = *museum.find(c.exhibit);
    if (index != hallIndex)
        shot.sceneState.values[index] = randomValues(museum.subject(index).parameters(), random, 0.5);
    if (c.prepare) c.prepare(shot);
    FrameRequest& frame = shot.request.frame;
    frame.raster.size = {48, 27};
    frame.transparent = false;
    frame.averageIn = AverageIn::radiance;
    frame.channels = {};
    frame.alone = c.inHall ? std::nullopt : std::optional(index);
    frame.subject = index == hallIndex || !c.inHall ? std::nullopt : std::optional(index);
    const render::Camera best = museum.subject(index).bestView(shot.sceneState.values[index]);
    frame.camera = index == hallIndex || !c.inHall ? best : museum.bestView(index, shot.sceneState.values[index]);
    if (c.camera) frame.camera = *c.camera;
    return shot;
}

/// Largest ratio of a channel's change to its bound, with its random setting, and the number of settings with any
/// change.
struct Held {
    double largest = 0;
    int seed = 0;
    int seen = 0;
};

/// Measures over the settings `first` to `last`. The bound is multiplied by `lowered`.
Held held(const Case& c, int first, int last, double lowered = 1)
{
    Held result;
    for (int seed = first; seed <= last; ++seed) {
        Shot shot = shotOf(c, static_cast<std::uint64_t>(seed));
        c.with(shot, false);
        const Picture without = shot.take();
        c.with(shot, true);
        const auto bound =
            boundIn(test::planned(gallery().museum, shot.sceneState, shot.request.frame), c.passOrEffect);
        const Picture with = shot.take();
        if (!bound) {
            EXPECT_EQ(largestDifference(with.image, without.image), 0)
                << c.passOrEffect << " is skipped, seed " << seed;
            continue;
        }
        if (!bound->isKnown()) continue;
        double change = 0;
        with.each([&](int x, int y) {
            for (int i = 0; i < 3; ++i) {
                const double before = without.color(x, y)[i];
                const double allowed =
                    lowered * (bound->relative * before + bound->absolute) + halfFloat * (before + with.color(x, y)[i]);
                const double difference = std::abs(with.color(x, y)[i] - before);
                change = std::max(change, difference);
                const double part = difference / std::max(allowed, 1e-12);
                if (part <= result.largest) continue;
                result.largest = part;
                result.seed = seed;
            }
        });
        result.seen += change > 1e-3;
    }
    return result;
}

/// Expects that the bound holds, that something changes, and that the test detects a bound that is too low: with nine
/// tenths of the measured value it must fail.
void expectHeld(const Case& c, int seeds = 4)
{
    const Held result = held(c, 1, seeds);
    EXPECT_LE(result.largest, 1) << c.passOrEffect << " of " << c.exhibit;
    EXPECT_GE(result.seen, 1) << c.passOrEffect << " was never seen to change anything: the test proves nothing";
    EXPECT_GE(result.largest, c.leastPart)
        << c.passOrEffect << " of " << c.exhibit << ": the bound is so high that the test proves little";
    EXPECT_GT(held(c, result.seed, result.seed, 0.9 * result.largest).largest, 1)
        << c.passOrEffect << " of " << c.exhibit << ": a bound that is too low passes";
    std::printf("%s of %s: at most %.3g of its bound\n", c.passOrEffect.c_str(), c.exhibit.c_str(), result.largest);
}

void noAir(Shot& shot)
{
    valuesOf(shot, "crepuscular_rays").set(raysTable().technique, crepuscular_rays::RayTechnique::none);
}

TEST_F(BoundsOfEffects, ShadowsOfTheSunTakeNoMoreThanTheSunGives)
{
    const auto shadows = [](Shot& shot, bool on) { shot.hall().set(hallTable().sunShadows, on); };
    expectHeld({"hall", "hall/shadow", shadows, true, noAir});
    expectHeld({"sdf_morph", "hall/shadow", shadows, true, noAir});
}

TEST_F(BoundsOfEffects, MirrorImagesAreNoBrighterThanWhatIsMirrored)
{
    const auto probe = [](Shot& shot, bool on) { shot.hall().set(hallTable().reflectionProbe, on); };
    expectHeld({"hall", "probe/irradiance", probe, true, noAir, 1e-4});  // The sun itself could be in the reflection.
    expectHeld({"sdf_morph", "probe/irradiance", probe, false});
    expectHeld({"lenticular", "probe/irradiance", probe, false});
}

TEST_F(BoundsOfEffects, OfTheTorusMugHold)
{
    const auto plain = [](Shot& shot) {
        noAir(shot);
        for (std::size_t row = sdfTable().morph.row; row <= sdfTable().blend.row; ++row)
            shot.values().resetParameter(row);  // A visible shape.
        shot.values().set(sdfTable().heatMap, SdfHeatMap::none);
        shot.values().set(sdfTable().shownAs, SdfShown::field);
        shot.values().set(sdfTable().animate, false);
        shot.values().set(sdfTable().boxSize, 1.0);
        shot.values().set(sdfTable().showBox, false);
    };
    const auto opaque = [plain](Shot& shot) {
        plain(shot);
        shot.values().set(sdfTable().material, SdfMaterial::opaque);
    };
    expectHeld({"sdf_morph", "sdf_morph/occlusion",
                [](Shot& s, bool on) { s.values().set(sdfTable().ambientOcclusion, on); }, false, opaque},
               6);
    // View into the mug, whose wall shades its bottom.
    const auto mugInTheSun = [opaque](Shot& shot) {
        opaque(shot);
        shot.values().set(sdfTable().morph, 1.0);
        shot.values().set(sdfTable().metalness, 0.2);  // Metal shows the sun in its highlight only.
        shot.values().set(sdfTable().roughness, 0.5);
        shot.hall().set(hallTable().sunAzimuth, 2.6);
        shot.hall().set(hallTable().sunElevation, 0.9);
    };
    expectHeld({"sdf_morph", "sdf_morph/self-shadow",
                [](Shot& s, bool on) {
                    s.values().set(sdfTable().shadowMethod, on ? SdfShadow::improved : SdfShadow::none);
                    s.see({0.45, 1.1, 0.8}, {0, 0, 0});
                },
                false, mugInTheSun, 2e-4},
               6);
    expectHeld({"sdf_morph", "sdf_morph/bounces",
                [](Shot& s, bool on) { s.values().set(sdfTable().bounces, on ? 3 : 0); }, false, plain, 2e-3},
               6);
}

TEST_F(BoundsOfEffects, OcclusionOfGlassIsCulledAndWouldHaveChangedNothing)
{
    for (int seed = 1; seed <= 3; ++seed) {
        Shot shot = shotOf({"sdf_morph", "", {}, false}, static_cast<std::uint64_t>(seed));
        shot.values().set(sdfTable().material, SdfMaterial::glass);
        shot.values().set(sdfTable().heatMap, SdfHeatMap::none);
        shot.values().set(sdfTable().ambientOcclusion, true);
        const Picture culled = shot.take();
        shot.request.frame.runEverything = true;
        EXPECT_EQ(largestDifference(culled.image, shot.take().image), 0) << seed;
    }
}

TEST_F(BoundsOfEffects, SunlightThatDoesNotArriveIsCulledAndWouldHaveChangedNothing)
{
    int lit = 0, unlit = 0;
    for (const glm::dvec2 sun : {glm::dvec2(13, 20), glm::dvec2(60, 30), glm::dvec2(120, 70), glm::dvec2(0, 0)}) {
        Shot shot = shotOf({"sdf_morph", "", {}}, 1);
        valuesOf(shot, "sdf_morph") = sdfTable().initial();
        shot.hall().set(hallTable().reflectionProbe, false);
        shot.hall().set(hallTable().sunStrength, 4.6);
        if (sun == glm::dvec2(0)) {
            test::letTheSunIn(shot.hall());
        } else {
            shot.hall().set(hallTable().sunAzimuth, sun.x * degree);
            shot.hall().set(hallTable().sunElevation, sun.y * degree);
        }
        const render::FramePlan plan = test::planned(gallery().museum, shot.sceneState, shot.request.frame);
        const bool isCulled = plan.findSkipped("sdf_morph/sunlight") != nullptr;
        (isCulled ? unlit : lit) += 1;
        const Picture culled = shot.take();
        shot.request.frame.runEverything = true;
        EXPECT_EQ(largestDifference(culled.image, shot.take().image), 0) << sun.x;
    }
    EXPECT_GT(lit, 0);
    EXPECT_GT(unlit, 0);
}

TEST_F(BoundsOfEffects, ColorsThatSpreadStayBelowWhitePaper)
{
    const lenticular::LenticularTable table;
    expectHeld({"lenticular", "lenticular/dispersion",
                [&](Shot& s, bool on) { valuesOf(s, "lenticular").set(table.dispersion, on); }, false,
                // The print with the brighter paper: the other one is dark.
                [&](Shot& s) { valuesOf(s, "lenticular").set(table.face, lenticular::CardFace::back); }, 1e-3});
}

TEST_F(BoundsOfEffects, RaysAddNoMoreThanTheMaskTimesTheirStrength)
{
    const auto rays = [](crepuscular_rays::RayTechnique technique) {
        return [technique](Shot& s, bool on) {
            valuesOf(s, "crepuscular_rays")
                .set(raysTable().technique, on ? technique : crepuscular_rays::RayTechnique::none);
        };
    };
    const auto plain = [](Shot& shot) {
        ParameterValues& values = valuesOf(shot, "crepuscular_rays");
        values.set(raysTable().view, crepuscular_rays::RayView::picture);
        values.set(raysTable().samples, 64);
        // Bounds use the brightest point of lamps, which is not in this picture.
        ParameterValues& lanterns = valuesOf(shot, "paper_lanterns");
        lanterns.setParameter(lanterns.table().find("hallGlow").value(), 0.0);
        shot.hall().set(hallTable().spotStrength, 0.0);
    };
    // From here, much of the air in front of the wall is lit, and nothing hides the window.
    Case c{"crepuscular_rays", "crepuscular_rays/composite", rays(crepuscular_rays::RayTechnique::screen), true, plain};
    c.camera = render::Camera{{-4.9, 1.65, -2.0}, {1.2, 2.9, -11.5}, 0.959931};
    expectHeld(c, 6);
    // Uniform, thin, isotropic air: the light that random dust absorbs of its own is not part of the bound.
    const auto evenAir = [plain](Shot& shot) {
        plain(shot);
        ParameterValues& values = valuesOf(shot, "crepuscular_rays");
        values.set(raysTable().airDensity, 0.05);
        values.set(raysTable().densityFalloff, 0.0);
        values.set(raysTable().densityNoise, 0.0);
        values.set(raysTable().anisotropy, 0.0);
    };
    c.with = rays(crepuscular_rays::RayTechnique::volume);
    c.prepare = evenAir;
    expectHeld(c, 6);
}

TEST_F(BoundsOfEffects, ToneMappingShowsLightBetweenZeroAndOne)
{
    for (const std::string_view exhibit : {"hall", "sdf_morph"}) {
        Shot shot = shotOf({std::string(exhibit), "", {}}, 3);
        const render::Image light = shot.take().image;
        shot.request.frame.averageIn = AverageIn::display;
        const render::Image shown = shot.take().image;
        const auto bound = boundIn(test::planned(gallery().museum, shot.sceneState, shot.request.frame), "tone");
        ASSERT_TRUE(bound && bound->isKnown());
        for (int y = 0; y < light.height; ++y)
            for (int x = 0; x < light.width; ++x)
                for (int c = 0; c < 3; ++c)
                    EXPECT_LE(std::abs(shown.at(x, y, c) - light.at(x, y, c)),
                              bound->relative * light.at(x, y, c) + bound->absolute + 1e-3);
    }
}

}  // namespace
}  // namespace vitrine
