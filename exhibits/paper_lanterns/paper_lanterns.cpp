#include "exhibits/paper_lanterns/paper_lanterns.h"

#include "exhibits/kit/blue_noise.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/panorama.h"
#include "exhibits/kit/portal.h"
#include "exhibits/paper_lanterns/lake_scene.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace vitrine::paper_lanterns {
namespace {

constexpr const char* lakePass = "paper_lanterns/lake";
constexpr const char* floatPass = "paper_lanterns/float";

constexpr float leastMoonOnWater = 0.001F;  ///< Smallest radiance of moonlight on water that counts, relative to white:
                                            ///< three display levels in dark areas.

struct PreparedSky final : PreparedPart {
    std::shared_ptr<const render::Texture> picture;
    std::vector<std::string> notes;  ///< Features of the file that are not shown: full sentences.
};

std::shared_ptr<const render::Texture> panoramaOf(const PreparedPart* prepared)
{
    return prepared ? static_cast<const PreparedSky*>(prepared)->picture : nullptr;
}

/// Part of the lake, and the reason why it is left out; empty: it is drawn.
struct LakePart {
    std::string whyNot;

    /// The part is drawn unless a factor is 0.
    explicit LakePart(std::initializer_list<render::Factor> factors) : whyNot(render::whyZero(factors)) {}
    explicit operator bool() const { return whyNot.empty(); }
};

/// Parts of the lake that the settings need.
struct Called {
    bool afloat = false, panorama = false, reference = false;
    int bounces = 0;
    LakeShow show = LakeShow::picture;
    LakePart lanterns, waves, mist, halo, moon, moonOnWater, stars, reflection;
};

Called calledFor(const PaperLanternsTable& t, const PlanContext& context, const LakeBlock& block)
{
    const ParameterValues& values = context.values;
    const bool shows = values[t.show] == LakeShow::picture;
    const bool reference = shows && values[t.look] == LakeLook::reference;
    const bool afloat = anyAfloat(t, values);
    const bool panorama = shows && panoramaOf(context.prepared) != nullptr;
    const int bounces = !shows ? 0 : reference ? 1 : values[t.bounces];
    const render::Factor inPicture = render::required(shows, "heights or normals are shown instead of the picture");
    const render::Factor physical = render::required(!reference, "the lighting of the reference has none");
    const render::Factor anyLantern = render::required(afloat || block.released.w >= 0, "no lantern is afloat");
    const render::Factor anyMist{values[t.fog], "the air is clear"};
    const render::Factor anyMoon{values[t.moon], "the strength of the moon is 0"};
    const render::Factor risen{std::max(block.moonLight.x, block.moonLight.z), "the moon has set"};
    // Radiance of moonlight from the water, on which lanterns may cast shadows. Below a limit it is invisible against
    // the reflection.
    const glm::vec3 sent(values[t.waterColor].value * glm::dvec3(block.moonLight));
    const float onWater = 0.3F * std::max({sent.x, sent.y, sent.z}) * block.towardsMoon.y;
    return {
        .afloat = afloat,
        .panorama = panorama,
        .reference = reference,
        .bounces = bounces,
        .show = values[t.show],
        .lanterns = LakePart({anyLantern}),
        .waves = LakePart({render::required(block.tallWaves > 0, "the water is flat and is hit in one step")}),
        .mist = LakePart({inPicture, physical, anyMist}),
        .halo = LakePart(
            {inPicture, physical, anyMist, anyLantern, render::required(values[t.candles], "the candles do not burn"),
             render::required(lightsTheAir(t, values), "the fog is too thin to show the light of the lanterns")}),
        .moon = LakePart({inPicture, anyMoon, risen}),
        .moonOnWater = LakePart(
            {inPicture, physical, anyMoon, risen, anyLantern,
             render::required(onWater > leastMoonOnWater, "the water reflects too little moonlight to show shadows")}),
        .stars = LakePart({inPicture,
                           physical,
                           render::required(!panorama, "a panorama replaces the night sky"),
                           {values[t.stars], "the brightness of the stars is 0"}}),
        .reflection = LakePart({inPicture, render::required(bounces > 0, "no reflected rays are traced")})};
}

/// Plans an image of every lantern of the lattice, computed once for all rays and kept while nothing moves.
render::ResourceId planFloat(const ParameterValues& values, const LakeBlock& block, const render::Bytes& bytes,
                             render::FramePlan& plan)
{
    const glm::ivec2 cells = glm::max(block.cells, glm::ivec2(1));
    const render::ResourceId afloat = plan.image({.name = "paper_lanterns.afloat",
                                                  .format = render::Format::rgba32f,
                                                  .type = render::TextureType::volume,
                                                  .size = cells,
                                                  .layers = 3,
                                                  .persistent = true});
    render::Pass pass = exhibitPass(floatPass, "places each lantern on the water at this time", values, "", "");
    pass.shader.compute = "paper_lanterns/float.comp";
    pass.work = render::Work::compute;
    pass.phase = render::PassPhase::prepare;
    pass.blocks[BLOCK_EXHIBIT] = bytes;
    pass.inputs.push_back({UNIT_EXHIBIT_B, blueNoise()});
    pass.storage = {render::Attachment::whole(afloat)};
    pass.groups = glm::ivec3((cells + 7) / 8, 1);
    pass.contentHash = render::Hash().add({reinterpret_cast<const char*>(bytes.data()), bytes.size()}).value();
    plan.add(std::move(pass));
    return afloat;
}

/// Lists the parts that are left out, with the reasons.
void tellWhatIsLeftOut(const Called& called, render::FramePlan& plan)
{
    if (!called.lanterns) plan.skip(floatPass, called.lanterns.whyNot, render::Work::compute);
    const std::pair<const char*, const LakePart*> parts[] = {{"waves", &called.waves},
                                                             {"moon", &called.moon},
                                                             {"moon_shadow", &called.moonOnWater},
                                                             {"reflection", &called.reflection},
                                                             {"mist", &called.mist},
                                                             {"halo", &called.halo},
                                                             {"stars", &called.stars}};
    for (const auto& [name, part] : parts)
        if (!*part) plan.skip(std::string("paper_lanterns/") + name, part->whyNot);
}

void addDefines(const Called& called, LakeRepetition repetition, render::Pass& pass)
{
    const auto define = [&](std::string text) { pass.shader.defines.push_back(std::move(text)); };
    static_assert(
        SHOW_PICTURE == static_cast<int>(LakeShow::picture) && SHOW_HEIGHTS == static_cast<int>(LakeShow::heights) &&
        SHOW_NORMALS == static_cast<int>(LakeShow::normals) && SHOW_PARTS == static_cast<int>(LakeShow::parts));
    define("SHOW " + std::to_string(static_cast<int>(called.show)));
    // Rays of the eye, of reflections by the water, and towards the moon.
    const int toMoon = (called.moon && called.lanterns ? 1 : 0) + (called.moonOnWater ? 1 : 0);
    define("LEGS " + std::to_string(1 + called.bounces + toMoon));
    define("BOUNCES " + std::to_string(called.bounces));
    if (called.lanterns) define("LANTERNS");
    if (called.waves) define("WAVES");
    if (called.mist) define("MIST");
    if (called.halo) define("HALO");
    if (called.moon) define("MOON");
    if (called.moonOnWater) define("MOON_ON_WATER");
    if (called.stars) define("STARS");
    if (called.panorama) define("PANORAMA");
    if (called.reference) define("REFERENCE");
    if (called.afloat && repetition != LakeRepetition::cellWall)
        define("REPETITION " + std::to_string(static_cast<int>(repetition)));
}

}  // namespace

render::Box PaperLanterns::bounds(const ParameterValues& values) const
{
    return portalBounds(lakePortal(table_, values));
}

render::Camera PaperLanterns::bestView(const ParameterValues& values) const
{
    return portalView(lakePortal(table_, values));
}

std::shared_ptr<const PreparedPart> PaperLanterns::prepare(const PrepareContext& context) const
{
    const std::string path = context.values[table_.panorama];
    if (path.empty()) return nullptr;
    auto made = std::make_shared<PreparedSky>();
    const render::Asset<Panorama> found = context.assets.get<Panorama>("paper_lanterns.panorama", path, readPanorama);
    if (!found.failure.empty())
        made->unreadable.push_back({"paper_lanterns/panorama",
                                    unreadableFile(context.values.rows()[table_.panorama.row], title(), found.failure),
                                    message("The night sky stays until it can be read.")});
    if (found.value) {
        made->picture = found.value->picture;
        made->notes = found.value->notes;
    }
    made->filesId = found.id;
    return made;
}

double PaperLanterns::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] ? 0 : std::numeric_limits<double>::infinity();
}

double PaperLanterns::nextChangeOf(const ExhibitState& state) const
{
    return state.sinceOwnPress < releasedFor ? 0 : nextChange(state.values, state.time);
}

bool PaperLanterns::press(ParameterValues& values) const
{
    const bool changes = !values[table_.animate];
    values.set(table_.animate, true);
    return changes;
}

std::vector<StudyView> PaperLanterns::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    ParameterValues later = still;
    later.set(table_.moment, values[table_.moment] + 17);
    const double height = values[table_.eyeHeight] / values[table_.scale];
    render::Camera aside = bestView(values), near = aside, high = aside;
    aside.eye += glm::dvec3(0.9, -0.2, 0.1);
    near.eye += 0.85 * (near.target - near.eye);
    // The water is at -height in exhibit space; this camera is just above it, between the lanterns.
    const render::Camera low{{0.4, 0.35 - height, -1.0}, {0.0, 0.3 - height, -4.0}, 0.9};
    high.target.y -= 0.9;
    return {{"best view", bestView(values), 0, still},
            {"from the side", aside, 0, still},
            {"from near, later", near, 0, later},
            {"over the water", low, 0, still},
            {"down upon them", high, 0, later}};
}

std::vector<render::LocalLight> PaperLanterns::localLights(const ExhibitState& state) const
{
    const ParameterValues& values = state.values;
    const Table& t = table_;
    if (values[t.show] != LakeShow::picture || !values[t.candles] || values[t.hallGlow] <= 0 || !anyAfloat(t, values))
        return {};
    // A sphere in front of the frame's mouth replaces the light of the opening, so the wall beside it is lit, too.
    const double strength = 0.15 * values[t.hallGlow] * values[t.candleStrength] * values[t.crowding];
    render::LocalLight light;
    light.position = {0, -0.25, 0.12};
    light.radius = 0.15;
    light.intensity = strength * values[t.candleColor].value;
    light.range = 4;
    return {light};
}

void PaperLanterns::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const Table& t = table_;
    const ParameterValues& values = context.values;
    const LakePress press = lakePress(t, values, context.time, context.sinceOwnPress);
    const LakeBlock block = lakeBlock(t, values, lakeTime(t, values, context.time), press);
    const render::Bytes bytes = render::std140Bytes(block);
    const Called called = calledFor(t, context, block);
    render::Pass pass =
        portalPass(lakePass, "in view", values, "paper_lanterns/lake.frag", lakePortal(t, values), context);
    pass.blocks[BLOCK_EXHIBIT] = bytes;
    addDefines(called, values[t.repetition], pass);
    tellWhatIsLeftOut(called, plan);
    if (called.lanterns) pass.inputs.push_back({UNIT_EXHIBIT_A, planFloat(values, block, bytes, plan)});
    if (context.prepared)
        for (const std::string& note : static_cast<const PreparedSky*>(context.prepared)->notes)
            plan.warn("paper_lanterns/panorama", note);
    pass.inputs.push_back(
        {UNIT_ENVIRONMENT, called.panorama ? panoramaOf(context.prepared) : lakeDusk(t, values)->radiance});
    plan.add(std::move(pass));
}

}  // namespace vitrine::paper_lanterns
