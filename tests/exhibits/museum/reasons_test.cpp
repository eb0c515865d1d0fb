// Reasons in the frame report: each skipped pass of every exhibit and of the hall has one, and it is true. The claim is
// checked with the settings, the request and the view, by code that shares nothing with the plans.

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/hall/sun.h"
#include "exhibits/stability/stability_scan.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>
#include <set>

namespace vitrine {
namespace {

using namespace test;

/// Skipped pass, and its picture.
struct Skipped {
    const stability::ScanCase& picture;
    const render::FramePlan& plan;
    const render::CulledPass& step;

    /// Returns the values of the pass's subject: "fur/coat" belongs to the fur.
    [[nodiscard]] const ParameterValues& values() const
    {
        const std::string subject = step.name.substr(0, step.name.find('/'));
        return picture.sceneState.values[museum().find(subject).value_or(hallIndex)];
    }
    [[nodiscard]] double number(std::string_view row) const { return numberOf(values(), row); }
    [[nodiscard]] double ofHall(std::string_view row) const
    {
        return numberOf(picture.sceneState.values[hallIndex], row);
    }
    [[nodiscard]] double brightest(std::string_view row) const
    {
        const auto color = std::get<glm::dvec3>(values().row(*values().table().find(row)));
        return std::max({color.x, color.y, color.z});
    }
    [[nodiscard]] bool namesNoFile(std::string_view row) const
    {
        return std::get<std::string>(values().row(*values().table().find(row))).empty();
    }
    [[nodiscard]] bool alone() const { return picture.frame.alone.has_value(); }
    [[nodiscard]] hall::Sun sun() const { return hall::sunOf(test::hallTable(), picture.sceneState.values[hallIndex]); }
    /// Returns whether the point is in the view, if nothing is in front of it.
    [[nodiscard]] bool inView(const glm::dvec3& point) const
    {
        const glm::dvec4 clip = plan.view.clipFromWorld * glm::dvec4(point, 1);
        return clip.w > plan.view.nearPlane && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
    }

private:
    static double numberOf(const ParameterValues& values, std::string_view row)
    {
        return std::get<double>(values.row(*values.table().find(row)));
    }
};

using Claim = std::function<bool(const Skipped&)>;

Claim isZero(const char* row)
{
    return [row](const Skipped& s) { return s.number(row) == 0; };
}

Claim isNot(const char* row, double value)
{
    return [row, value](const Skipped& s) { return s.number(row) != value; };
}

Claim is(const char* row, double value)
{
    return [row, value](const Skipped& s) { return s.number(row) == value; };
}

Claim isBlack(const char* row)
{
    return [row](const Skipped& s) { return s.brightest(row) == 0; };
}

bool isAlone(const Skipped& s)
{
    return s.alone();
}

/// Claims about pictures, which run_everything_test.cpp checks: "Run everything" changes no bit.
bool measuredByPictures(const Skipped&)
{
    return true;
}

bool noButtonInView(const Skipped& s)
{
    return std::none_of(museum().exhibits().begin(), museum().exhibits().end(), [&](const MuseumExhibit& e) {
        const hall::Place* place = building().place(e.exhibit.place());
        return place && place->worldFromButton && capability<HasButton>(e.exhibit) &&
               s.inView(glm::dvec3((*place->worldFromButton)[3]));
    });
}

bool noPlaqueInView(const Skipped& s)
{
    return std::none_of(museum().exhibits().begin(), museum().exhibits().end(), [&](const MuseumExhibit& e) {
        const hall::Place* place = building().place(e.exhibit.place());
        return place && place->worldFromPlaque && s.inView(glm::dvec3((*place->worldFromPlaque)[3]));
    });
}

bool floorOutOfView(const Skipped& s)
{
    const render::Box& room = building().room();
    for (double x = 0.02; x < 1; x += 0.04)
        for (double z = 0.02; z < 1; z += 0.04)
            if (s.inView({glm::mix(room.low.x, room.high.x, x), room.low.y, glm::mix(room.low.z, room.high.z, z)}))
                return false;
    return true;
}

/// Claims about an exhibit, checked by its bounds. Claims about a part of it are checked by pictures.
bool outOfView(const Skipped& s)
{
    if (s.step.name.find('/') != std::string::npos && !s.step.name.ends_with("/shadow")) return true;
    const auto index = museum().find(s.step.name.substr(0, s.step.name.find('/')));
    if (!index || *index == hallIndex) return true;
    glm::dmat4 world = s.alone() ? glm::dmat4(1) : museum().worldFromExhibit(*index);
    if (s.picture.frame.subject == index || s.picture.frame.alone == index)
        world = world * s.picture.frame.exhibitTransform;
    const glm::dvec3 middle = museum().subject(*index).bounds(s.values()).center();
    return !s.inView(glm::dvec3(world * glm::dvec4(middle, 1)));
}

/// Claims that every mirror of the plan is lower than 128 pixels.
bool noLargeMirror(const Skipped& s)
{
    return std::none_of(museum().exhibits().begin(), museum().exhibits().end(), [&](const MuseumExhibit& e) {
        const std::string name(e.exhibit.name());
        const ParameterValues& values = s.picture.sceneState.values[e.index];
        const auto* mirror = capability<MirrorsSurroundings>(e.exhibit);
        if (!mirror || !mirror->mirrors(values) || (!s.plan.find(name + "/march") && !s.plan.find(name + "/mesh")))
            return false;
        glm::dmat4 world = museum().worldFromExhibit(e.index);
        if (s.picture.frame.subject == e.index) world = world * s.picture.frame.exhibitTransform;
        const render::Box box = e.exhibit.bounds(values).transformed(world);
        const double away = glm::distance(box.center(), s.plan.view.eye);
        // The sphere around the box is at least as high as the mirror.
        return s.plan.view.raster.size.y * glm::length(box.halfSize()) / (s.plan.view.tanHalfFov.y * away) > 130;
    });
}

bool noLightAtAll(const Skipped& s)
{
    return s.sun().strength == 0 && (s.alone() || s.ofHall("skyStrength") == 0);
}

/// Claims that another work is shown: false for passes of the clouds while they are shown.
bool anotherWork(const Skipped& s)
{
    const char* works[] = {"noise/field", "noise/fractal", "noise/sea", "noise/clouds"};
    return !s.step.name.starts_with(works[static_cast<std::size_t>(s.number("work"))]);
}

bool nothingLookedUp(const Skipped& s)
{
    const double work = s.number("work");
    if (s.number("look") != 0 || work == 2) return true;
    return work == 3 ? s.number("cloudNoise") != 1 : s.number("march") != 1 || s.number("fieldNoise") != 1;
}

/// Returns whether either half of the pixel art shows this view.
bool shows(const Skipped& s, double view)
{
    return s.number("view") == view || (s.number("split") == 1 && s.number("rightView") == view);
}

bool moonIsDown(const Skipped& s)
{
    return s.number("moonElevation") <= -0.0299 || s.number("moon") == 0;
}

const std::map<std::string, Claim>& claims()
{
    constexpr double pi = std::numbers::pi;
    static const std::map<std::string, Claim> all{
        // Reasons of the picture.
        {"the exhibit is shown alone", isAlone},
        {"a transparent background is requested", [](const Skipped& s) { return s.picture.frame.transparent; }},
        {"the strength of the glare is 0", isZero("glare")},
        {"nothing is brighter than the screen's white", measuredByPictures},
        {"the picture is drawn in tiles, and halos reach beyond them",
         [](const Skipped& s) { return s.picture.frame.raster.drawn() != s.picture.frame.raster.size; }},
        {"linear light is requested",
         [](const Skipped& s) { return s.picture.frame.averageIn == AverageIn::radiance; }},
        {"one sample per pixel", [](const Skipped& s) { return s.picture.frame.samples == 1; }},
        {"frames are independent of each other",
         [](const Skipped& s) { return s.ofHall("temporalAntialiasing") == 0 || s.ofHall("historyFrames") == 1; }},
        {"no motion follows this frame", [](const Skipped& s) { return s.picture.frame.movingFrame == 0; }},
        {"nothing moves", [](const Skipped& s) { return s.picture.frame.movingFrame == 0; }},
        {"no counts are requested", [](const Skipped& s) { return !s.picture.frame.channels.evaluations; }},
        {"its output is not used", [](const Skipped& s) { return s.plan.find(s.step.name) == nullptr; }},
        // Reasons of the hall.
        {"there is no hall", isAlone},
        {"there is no hall to cast it", isAlone},
        {"there is no reflection probe", [](const Skipped& s) { return s.plan.findSkipped("probe") != nullptr; }},
        {"no mirror in view is large enough to show them", noLargeMirror},
        {"there is no hall to bounce it", isAlone},
        {"sun shadows are switched off", [](const Skipped& s) { return s.ofHall("sunShadows") == 0; }},
        {"baked light is switched off", [](const Skipped& s) { return s.ofHall("bakedLight") == 0; }},
        {"the sun's strength is 0", [](const Skipped& s) { return s.ofHall("sunStrength") == 0; }},
        {"the sun has set",
         [](const Skipped& s) { return s.ofHall("sunBy") == 1 && std::abs(s.ofHall("timeOfDay") - 12) >= 5.999; }},
        {"too little sunlight comes in through window and oculus", measuredByPictures},
        {"the sun is too high for lamps",
         [](const Skipped& s) { return s.ofHall("lamps") == 0 && s.sun().elevation >= pi / 180 * 7.99; }},
        {"the lamps are switched off", [](const Skipped& s) { return s.ofHall("lamps") == 2; }},
        {"the strength of the lamps is 0", [](const Skipped& s) { return s.ofHall("lampStrength") == 0; }},
        {"the reflection probe is switched off", [](const Skipped& s) { return s.ofHall("reflectionProbe") == 0; }},
        {"there is no light to reflect", noLightAtAll},
        {"contact shadows are switched off", [](const Skipped& s) { return s.ofHall("contactShadows") == 0; }},
        {"the free plinth is empty", [](const Skipped& s) { return s.namesNoFile("model"); }},
        {"no file is chosen for it",
         [](const Skipped& s) {
             const char* rows[] = {"secondModel", "thirdModel", "fourthModel"};
             return s.namesNoFile(rows[s.step.name.back() - '2']);
         }},
        {"no button is in view", noButtonInView},
        {"no plaque is in view", noPlaqueInView},
        {"no cloth or stand is in view", measuredByPictures},
        {"no heat map is shown", [](const Skipped& s) { return s.ofHall("heatMap") == 0; }},
        {"no surface of triangles is in view", measuredByPictures},
        {"the floor is out of view", floorOutOfView},
        {"the floor mirrors nothing in screen space", [](const Skipped& s) { return s.ofHall("floorMirror") != 2; }},
        {"the picture is drawn in tiles, and reflections reach beyond them",
         [](const Skipped& s) { return s.picture.frame.raster.drawn() != s.picture.frame.raster.size; }},
        {"out of view", outOfView},
        {"behind a wall", measuredByPictures},
        {"no lamp hangs here", [](const Skipped& s) { return s.plan.findSkipped("lamps/shadow") == nullptr; }},
        {"no lamp shines here", measuredByPictures},
        {"no lamp throws shadows", [](const Skipped& s) { return !s.plan.images().contains("shadow.local"); }},
        {"it is made of light",
         [](const Skipped& s) {
             const std::optional<std::size_t> alone = s.picture.frame.alone;
             return s.step.name == "crepuscular_rays/shadow" ||
                    (s.step.name == "exhibits/shadow" && alone && capability<OverFrame>(museum().exhibit(*alone)));
         }},
        {"nothing in the picture is translucent", [](const Skipped& s) { return s.namesNoFile("model"); }},
        {"it throws no shadow",
         [](const Skipped& s) {
             const auto index = museum().find(s.step.name.substr(0, s.step.name.find('/')));
             return s.step.name == "exhibits/shadow" || (index && !museum().exhibit(*index).castsShadow());
         }},
        {"neither it nor its shadow is in view", outOfView},
        {"the sun does not reach it through window or oculus", measuredByPictures},
        {"no exhibit throws a shadow that may be seen", measuredByPictures},
        // Reasons of all distance fields.
        {"the cone pre-pass is switched off", isZero("conePrepass")},
        {"ambient occlusion is switched off",
         [](const Skipped& s) {
             return s.values().table().find("ambientOcclusion") ? s.number("ambientOcclusion") == 0
                                                                : s.number("occlusionMethod") == 1;
         }},
        {"glass scatters nothing of the room's light",
         [](const Skipped& s) { return s.number("material") == 1 && s.number("heatMap") == 0; }},
        {"the shadow method is none", isZero("shadowMethod")},
        {"no bounce is requested", isZero("bounces")},
        {"the field is shown", isZero("shownAs")},
        {"a mesh is shown instead of the field", is("shownAs", 1)},
        {"the overlay is switched off", isZero("showBox")},
        // Reasons of the soft serve.
        {"the light is that of the reference", is("lighting", 1)},
        {"the backdrop is switched off", isZero("backdrop")},
        {"the background stays empty", isAlone},
        {"the ambient light is black",
         [](const Skipped& s) { return s.number("lighting") == 1 && s.brightest("referenceAmbient") == 0; }},
        {"the build-up has not come so far",
         [](const Skipped& s) { return s.number("buildUp") == 1 || s.number("stage") < 20; }},
        {"it stands in the hall's light", isZero("lighting")},
        {"the ground is switched off", isZero("ground")},
        {"it stands in the hall", [](const Skipped& s) { return !s.alone(); }},
        // Reasons of the fur.
        {"silhouettes are not filled with fins", isNot("silhouette", 1)},
        {"no visible part has fins", is("silhouette", 1)},
        {"set by hand", is("byHand", 1)},
        {"at rest", [](const Skipped& s) { return s.number("byHand") == 0 && s.number("frozenAt") == 0; }},
        {"frozen", [](const Skipped& s) { return s.number("byHand") == 0 && s.number("frozenAt") > 0; }},
        {"at rest since", [](const Skipped& s) { return s.number("byHand") == 0 && s.number("frozenAt") == 0; }},
        // Reasons of the card.
        {"dispersion is switched off", isZero("dispersion")},
        {"no light falls on the card", [](const Skipped& s) { return noLightAtAll(s) && s.number("lamp") == 0; }},
        // Reasons of the sunbeams.
        {"the selected technique does not make them",
         [](const Skipped& s) {
             const bool screen = s.step.name == "crepuscular_rays/mask" || s.step.name == "crepuscular_rays/rays";
             const auto used = static_cast<int>(s.number("technique"));
             return s.step.name == "crepuscular_rays/composite" ? used == 0 : (used & (screen ? 1 : 2)) == 0;
         }},
        {"the mask is shown", is("view", 1)},
        {"there are no beams to add to the picture",
         [](const Skipped& s) {
             return s.number("technique") != 0 && s.plan.find("crepuscular_rays/march") == nullptr &&
                    s.plan.find("crepuscular_rays/mask") == nullptr;
         }},
        {"the sun is not in front of the camera",
         [](const Skipped& s) { return (glm::dmat3(s.plan.view.viewFromWorld) * s.sun().towards()).z >= -1e-8; }},
        {"the weight of the rays is 0", isZero("weight")},
        {"the density of the rays is 0", isZero("density")},
        {"the tint of the rays is black", isBlack("tint")},
        {"the sun is too far beyond the picture's edge",
         [](const Skipped& s) { return !s.inView(s.plan.view.eye + 1e4 * s.sun().towards()); }},
        {"the sun has no light of the color of the tint", measuredByPictures},
        {"no sky is in view",
         [](const Skipped& s) {
             return std::none_of(building().openings().begin(), building().openings().end(),
                                 [&](const render::Box& opening) { return s.inView(opening.center()); });
         }},
        {"the air is clear",
         [](const Skipped& s) { return s.number(s.step.name[0] == 'c' ? "airDensity" : "fog") == 0; }},
        {"there is no background behind the air", [](const Skipped& s) { return s.picture.frame.transparent; }},
        {"the exhibit is shown alone, without walls to bound the air", isAlone},
        {"the air is out of view", [](const Skipped& s) { return !s.inView(building().room().center()); }},
        {"the dust swallows all light", isBlack("airColor")},
        {"the dust swallows the light of the sun", measuredByPictures},
        {"the strength of the beams is 0", isZero("beamStrength")},
        {"no sunbeam wider than 30 cm comes in through the window",
         [](const Skipped& s) { return s.alone() && s.sun().towards().z > -1 + 0.5; }},
        {"no sunbeam wider than 30 cm comes in through window or oculus",
         [](const Skipped& s) { return s.sun().towards().y < 0.99; }},
        {"the beams are out of view", measuredByPictures},
        // Reasons of the lake.
        {"no lantern is afloat", isZero("crowding")},
        {"the water is flat and is hit in one step", isZero("waveHeight")},
        {"heights or normals are shown instead of the picture", isNot("show", 0)},
        {"the lighting of the reference has none", is("look", 1)},
        {"the candles do not burn", isZero("candles")},
        {"the fog is too thin to show the light of the lanterns",
         [](const Skipped& s) { return s.number("fog") > 0 && s.number("fog") <= 0.0015; }},
        {"the strength of the moon is 0", isZero("moon")},
        {"the moon has set", moonIsDown},
        {"the water reflects too little moonlight to show shadows",
         [](const Skipped& s) {
             const double up = std::max(std::sin(s.number("moonElevation")), 0.0);
             return s.brightest("waterColor") * s.number("moon") * up < 0.1;
         }},
        {"no reflected rays are traced", isZero("bounces")},
        {"a panorama replaces the night sky", [](const Skipped& s) { return !s.namesNoFile("panorama"); }},
        {"the brightness of the stars is 0", isZero("stars")},
        // Reasons of the noise.
        {"another work is shown", anotherWork},
        {"no work uses baked noise", nothingLookedUp},
        {"a ray is marched through every pixel",
         [](const Skipped& s) {
             return s.number("look") != 0 || s.number("march") != 1 || s.number("cloudTolerance") == 0;
         }},
        // Reasons of the pixel art.
        {"no shown view has shadows", [](const Skipped& s) { return !shows(s, 0); }},
        {"shadows are off", isZero("shadows")},
        {"the light of the sun is black", isBlack("sunLight")},
        {"the depth is stored when it is drawn",
         [](const Skipped& s) { return s.number("depthBits") == 0 && s.number("depthOrder") == 0; }},
        {"smoothing is 0", isZero("smoothing")},
        {"only depth is shown",
         [](const Skipped& s) { return shows(s, 3) && !shows(s, 0) && !shows(s, 1) && !shows(s, 2) && !shows(s, 4); }},
        {"error diffusion is off",
         [](const Skipped& s) {
             return s.number("dither") != 3 || (s.number("palette") == 0 && s.namesNoFile("palettePicture"));
         }},
        // Reasons of the scenes.
        {"the picture is not divided", isZero("split")},
        {"its half is out of view", measuredByPictures},
        {"shadows are switched off", is("shadowMethod", 1)},
        {"the scene has no lights", measuredByPictures},
        {"no material reflects the lights", isNot("look", 1)},
        {"nothing in the scene mirrors", measuredByPictures},
        {"nothing is made of glass", measuredByPictures},
        {"the reference has no glass", isNot("look", 1)},
        {"the reference shows no lamps", isNot("look", 1)},
        {"no light of the scene has an area", measuredByPictures},
        {"with so few shapes, evaluating all of them is as fast", isZero("evaluation")},
        {"its numbers changed a short time ago", [](const Skipped& s) { return !s.picture.frame.idle; }},
        {"numbers are compiled in only if the evaluation is automatic", isNot("evaluation", 0)},
        {"the shader text of lists contains no numbers", measuredByPictures},
        {"the scene is infinite, so no grid of cells can cover it", measuredByPictures},
    };
    return all;
}

/// Returns the claim of a reason; one that ends in a number of seconds is found by its beginning.
const Claim* claimOf(const std::string& reason)
{
    for (const char* begins : {"frozen", "at rest since"})
        if (reason.starts_with(std::string(begins) + ' ')) return &claims().at(begins);
    const auto claim = claims().find(reason);
    return claim == claims().end() ? nullptr : &claim->second;
}

/// Draws random settings, often at the ends of ranges, where effects vanish.
void drawSettings(ParameterValues& values, RandomNumbers& random)
{
    for (std::size_t row = 0; row < values.rows().size(); ++row) {
        const ParameterInfo& info = values.rows()[row];
        if (!random.chance(0.6)) continue;
        if (info.kind == Kind::color && random.chance(0.4)) {
            values.setParameter(row, glm::dvec3(0));
        } else if (info.isNumeric() && random.chance(0.5)) {
            // Higher counts cost time and have no other reasons.
            const double high = info.kind == Kind::count ? std::get<double>(info.initial) : info.range.softHigh;
            values.setParameter(row, random.chance(0.6) ? info.range.low : high);
        } else if (info.kind != Kind::count) {
            values.setParameter(row, randomValue(info, random));
        }
    }
}

class Reasons : public testing::TestWithParam<std::string> {
protected:
    /// Expects every step of random settings, from one seed to another, to have a reason that is true.
    static void expectTrueReasons(std::uint64_t firstSeed, std::uint64_t lastSeed);
};

/// Five times as many settings.
class LongReasons : public Reasons {};

void Reasons::expectTrueReasons(std::uint64_t firstSeed, std::uint64_t lastSeed)
{
    const std::size_t exhibit = *museum().find(GetParam());
    std::set<std::string> told;
    for (std::uint64_t seed = firstSeed; seed <= lastSeed; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        stability::ScanCase c = stability::scanCase(museum(), exhibit, seed * 32);
        RandomNumbers random(seed);
        if (random.chance(0.7)) drawSettings(c.sceneState.values[exhibit], random);
        if (random.chance(0.3)) drawSettings(c.sceneState.hall(), random);
        const render::FramePlan plan = test::planned(museum(), c.sceneState, c.frame);
        for (const render::Pass& pass : plan.passes()) EXPECT_FALSE(pass.reason.empty()) << pass.name;
        for (const render::CulledPass& step : plan.skipped()) {
            EXPECT_EQ(plan.find(step.name), nullptr) << step.name << " runs, and is skipped";
            EXPECT_GE(step.reason.size(), 5U) << step.name << " is skipped without a reason";
            if (step.complaint) continue;
            told.insert(step.reason);
            // The right half of a scene has the same values under other names.
            if (step.name.starts_with("sdf_scenes/right/")) continue;
            const Claim* claim = claimOf(step.reason);
            EXPECT_TRUE(claim) << step.name << ": nothing checks the reason \"" << step.reason << '"';
            EXPECT_TRUE(!claim || (*claim)({c, plan, step})) << step.name << ": " << step.reason;
        }
    }
    EXPECT_GE(told.size(), 5U) << "hardly anything was left out: this proves little";
}

TEST_P(Reasons, AreThereAndTrueWhateverIsSet)
{
    expectTrueReasons(1, 20);
}

TEST_P(LongReasons, AreThereAndTrueWhateverIsSet)
{
    expectTrueReasons(21, 120);
}

std::vector<std::string> namesOfAll()
{
    std::vector<std::string> names{"hall"};
    for (const auto& exhibit : allExhibits()) names.emplace_back(exhibit->name());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exhibits, Reasons, testing::ValuesIn(namesOfAll()), [](const auto& p) { return p.param; });
INSTANTIATE_TEST_SUITE_P(Exhibits, LongReasons, testing::ValuesIn(namesOfAll()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace vitrine
