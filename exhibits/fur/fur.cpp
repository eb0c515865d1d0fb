#include "exhibits/fur/fur.h"

#include "exhibits/fur/bounce.h"
#include "exhibits/fur/coat_mesh.h"
#include "exhibits/fur/fur_passes.h"
#include "render/files/asset_store.h"
#include "render/files/assets.h"
#include "render/scene/gltf.h"
#include "render/scene/held_bytes.h"
#include "render/text/joined.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

namespace vitrine::fur {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::string seconds(double s)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", s);
    return text;
}

/// Returns the path of a user's file, or of an asset of the program such as "models/teddy.glb".
std::string modelFile(const std::string& path)
{
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path;
    const std::filesystem::path own = render::asset(path);
    return std::filesystem::exists(own, ignored) ? own.string() : path;
}

/// Returns whether both times can be shown. An infinite `sinceOwnPress` is right: the button was never pressed.
bool clockIsRight(double time, double sinceOwnPress)
{
    return std::isfinite(time) && sinceOwnPress >= 0;
}

/// Returns whether the ball changes its size all the time.
bool grows(const FurTable& table, const ParameterValues& values)
{
    return values[table.growing] && values[table.growth] > 0 && values[table.growthRate] > 0 && !values[table.byHand];
}

void lieByHand(const FurTable& table, const ParameterValues& values, FurStates& states)
{
    for (FurState& state : states) {
        state.skinScale = 1;
        state.tipOffset = {values[table.handX], values[table.handY], values[table.handZ]};
        state.tipRotation = glm::angleAxis(values[table.handRotation], glm::dvec3(0, 0, 1));
    }
}

/// Returns the fins of a skin, or null if it has too many edges.
std::shared_ptr<const render::Mesh> finsOn(const std::shared_ptr<const render::Mesh>& skin, render::AssetStore& assets)
{
    const int rows = finRows(*skin);
    if (rows == 0) return nullptr;
    return assets
        .made<render::Mesh>(
            "fur.fins", {},
            [&] {
                auto fins = finsOf(*skin, rows);
                const std::uint64_t bytes = heldBytes(*fins);
                return render::AssetStore::Made<render::Mesh>{std::move(fins), bytes};
            },
            skin)
        .value;
}

std::string whyUnfinned(const std::shared_ptr<const render::Mesh>& skin)
{
    return finRows(*skin) == 0
               ? "the model has more than 200,000 triangles, too many for fins; a march fills its silhouette as well"
               : "there is not enough memory for fins";
}

}  // namespace

struct Fur::Prepared final : PreparedPart {
    /// Skin made from the user's model.
    struct RingModel {
        std::shared_ptr<const render::Mesh> skin;
        double radius = 0;               ///< Radius in meters of the ball that approximates the model.
        std::vector<std::string> notes;  ///< Dropped and repaired parts of the file.
    };
    static render::AssetStore::Made<RingModel> readRingModel(const std::string& path)
    {
        auto model = std::make_shared<RingModel>();
        model->skin = modelSkin(render::loadGltf(path), path, ringRadius + ringTube, model->notes);
        model->radius = meanRadius(*model->skin);
        const std::uint64_t bytes = heldBytes(*model->skin);
        return {std::move(model), bytes};
    }

    std::shared_ptr<const RingModel> model;  ///< Null if the ring is shown.
    std::array<std::shared_ptr<const render::Mesh>, furBodyCount> skins, fins;
    FurStates states;
    bool moving = false;
    std::string reason;      ///< Reason for the simulation step, or for its absence.
    std::int64_t steps = 0;  ///< Simulation steps from the press to this time.
};

Fur::Fur()
    : skins_{ballSkin(ballRadius, 8), rollSkin(rollRadius, rollHalfLength, 26), ringSkin(ringRadius, ringTube, 40)}
{
}

render::Box Fur::bounds(const ParameterValues& values) const
{
    return boundsOf({values});
}

render::Box Fur::boundsOf(const ExhibitState& state) const
{
    const ParameterValues& values = state.values;
    const bool pressed = state.sinceOwnPress >= 0 && state.sinceOwnPress <= Bounce::longest;
    const bool jumping =
        !values[table_.byHand] && (pressed || values[table_.frozenAt] > 0 || values[table_.bouncePeriod] > 0);
    render::Box space = bouncingSpace(table_, values, jumping);
    space.include({-pitRadius, 0, -pitRadius});
    space.include({pitRadius, 1.9, pitRadius});
    return space;
}

std::shared_ptr<const PreparedPart> Fur::prepare(const PrepareContext& context) const
{
    const ParameterValues& values = context.values;
    auto made = std::make_shared<Prepared>();
    if (const std::string path = values[table_.ringModel]; !path.empty()) {
        auto found = context.assets.get<Prepared::RingModel>("fur.ringModel", modelFile(path), Prepared::readRingModel);
        made->model = std::move(found.value);
        made->filesId = found.id;
        if (!found.failure.empty())
            made->unreadable.push_back({"fur/model",
                                        unreadableFile(values.rows()[table_.ringModel.row], title(), found.failure),
                                        message("The ring is shown in its place until it can be read.")});
    }
    made->skins = skins_;
    if (made->model) made->skins[furRing] = made->model->skin;
    if (values[table_.silhouette] == FurSilhouette::fins)
        for (std::size_t i = 0; i < furBodyCount; ++i) made->fins[i] = finsOn(made->skins[i], context.assets);
    findMotion(context, *made);
    return made;
}

double Fur::firstHit(const ExhibitState& state, const render::Ray& ray) const
{
    if (!state.prepared) return never;
    const auto& now = static_cast<const Prepared&>(*state.prepared);
    const Coats coats{
        table_, state.values, now.states, glm::dmat4(1), state.time, 1, now.model ? now.model->radius : 0};
    double nearest = never;
    for (int i = 0; i < furBodyCount; ++i) {
        // Tests the ellipsoid that touches the sides of the space that the coat may fill.
        const render::Box space = coats.space(i, now.skins[static_cast<std::size_t>(i)]->bounds);
        const glm::dmat4 bodyFromBall =
            glm::scale(glm::translate(glm::dmat4(1), space.center()), glm::max(space.halfSize(), 1e-6));
        nearest =
            std::min(nearest, render::firstHit(ray.transformed(glm::inverse(coats.worldFromBody(i) * bodyFromBall)),
                                               glm::dvec3(0), 1));
    }
    // The floor of the pit belongs to the exhibit, too.
    const double floor = render::firstHit(ray, {{-pitRadius, 0, -pitRadius}, {pitRadius, 0, pitRadius}});
    const glm::dvec3 there = std::isfinite(floor) ? ray.at(floor) : glm::dvec3(2 * pitRadius);
    return std::hypot(there.x, there.z) < pitRadius ? std::min(nearest, floor) : nearest;
}

render::Camera Fur::bestView(const ParameterValues&) const
{
    return {{-0.05, 1.55, 3.15}, {0.0, 0.36, 0}, 0.62};
}

double Fur::nextChange(const ParameterValues& values, double) const
{
    const bool gusts = values[table_.wind] > 0 && values[table_.gustiness] > 0;
    return gusts || grows(table_, values) ||
                   (values[table_.bouncePeriod] > 0 && !(values[table_.frozenAt] > 0) && !values[table_.byHand])
               ? 0
               : never;
}

double Fur::nextChangeOf(const ExhibitState& state) const
{
    if (state.values[table_.wind] > 0 && state.values[table_.gustiness] > 0) return 0;
    return state.prepared && static_cast<const Prepared&>(*state.prepared).moving ? 0 : never;
}

std::vector<StudyView> Fur::studyViews(const ParameterValues& values) const
{
    ParameterValues spun = values;
    spun.set(table_.byHand, true);
    for (const Real tipOffset : {table_.handX, table_.handY, table_.handZ}) spun.set(tipOffset, 0.0);
    spun.set(table_.handRotation, 2.0943951023931953);
    ParameterValues landing = values;
    landing.set(table_.frozenAt, 0.9);
    // Stiff fur in long steps distinguishes the three spring methods: the first diverges, the second is late, the third
    // is exact.
    ParameterValues stiff = landing;
    stiff.set(table_.frequency, 4.0);
    stiff.set(table_.springRate, 30);
    // The first three are the hard cases of shell count, rotation and springs.
    return {{"silhouette", {{-1.05, 0.75, 1.1}, {-1.0, 0.62, 0}, 0.42}, 0, values},
            {"best view", bestView(values), 0, values},
            {"spin of 120 degrees", {{-0.62, 0.6, 1.9}, {-0.62, 0.42, 0}, 0.6}, 0, spun},
            {"tip", {{0.55, 0.72, 1.35}, {0.55, 0.42, 0.72}, 0.3}, 0, values},
            {"landing", bestView(values), 0, landing},
            {"stiff fur in long steps", bestView(values), 0, stiff}};
}

void Fur::findMotion(const PrepareContext& context, Prepared& m) const
{
    const ParameterValues& values = context.values;
    const bool right = clockIsRight(context.time, context.sinceOwnPress);
    const double now = right ? context.time : 0;
    double since = right && context.sinceOwnPress < 1e6 ? context.sinceOwnPress : never;
    const bool byItself = values[table_.bouncePeriod] > 0;
    const bool frozen = values[table_.frozenAt] > 0;
    if (byItself) since = now - std::floor(now / values[table_.bouncePeriod]) * values[table_.bouncePeriod];
    if (frozen) since = values[table_.frozenAt];
    if (values[table_.byHand]) since = never;
    const bool growing = grows(table_, values);
    const std::shared_ptr<const render::Mesh> skin = m.model ? m.model->skin : nullptr;
    const BounceSettings settings = bounceSettings(table_, values, skin, since == never || frozen ? now : now - since);
    if (since == never) {
        m.states = restStates(settings, 0);
        m.moving = growing;
        m.reason = values[table_.byHand] ? "set by hand" : growing ? "the ball grows and shrinks" : "at rest";
        if (values[table_.byHand]) lieByHand(table_, values, m.states);
        return;
    }
    const auto jump = context.assets.made<RecordedJump>(
        "fur.jump", keyOf(settings),
        [&] {
            return render::AssetStore::Made<RecordedJump>{std::make_shared<RecordedJump>(settings),
                                                          RecordedJump::mostBytes};
        },
        skin);
    const RecordedJump::Sample sample =
        jump.value ? jump.value->at(since) : RecordedJump::Sample{restStates(settings, since), 0, 0};
    m.states = sample.states;
    m.steps = sample.steps;
    m.moving = !frozen && (growing || byItself || sample.rested > since);
    if (frozen)
        m.reason = "frozen " + seconds(since) + " after the jump";
    else if (sample.rested <= since)
        m.reason = growing ? "the ball grows and shrinks" : "at rest since " + seconds(since - sample.rested);
    else
        m.reason = (byItself ? "jumped by themselves " : "woken by the button ") + seconds(since) + " ago";
}

void Fur::planMotion(const PlanContext& context, render::FramePlan& plan) const
{
    constexpr const char* motion = "fur/motion";
    if (plan.find(motion) || plan.findSkipped(motion)) return;
    // The message has no number, so it stays one line in the log while the clock advances.
    if (!clockIsRight(context.time, context.sinceOwnPress))
        plan.warn("fur/clock",
                  "the time is no number, or lies before the press of the button; the bodies are shown at rest "
                  "until it is right",
                  render::Work::simulation);
    const auto& now = static_cast<const Prepared&>(*context.prepared);
    if (!now.moving) {
        plan.skip(motion, now.reason, render::Work::simulation);
        return;
    }
    render::Pass pass;
    pass.name = motion;
    pass.reason = now.reason;
    pass.phase = render::PassPhase::simulate;
    pass.work = render::Work::simulation;
    pass.writes = {"fur.bodies"};
    pass.counts["simulationSteps"] = now.steps;
    plan.add(std::move(pass));
}

FurScene Fur::sceneOf(const PlanContext& context, std::uint32_t seed) const
{
    const auto& now = static_cast<const Prepared&>(*context.prepared);
    const double time = clockIsRight(context.time, context.sinceOwnPress) ? context.time : 0;
    FurScene scene{
        context,
        {table_, context.values, now.states, context.worldFromExhibit, time, seed, now.model ? now.model->radius : 0},
        {},
        {}};
    std::copy(now.skins.begin(), now.skins.end(), scene.skins);
    std::copy(now.fins.begin(), now.fins.end(), scene.fins);
    return scene;
}

std::vector<render::LocalLight> Fur::localLights(const ExhibitState& state) const
{
    const ParameterValues& values = state.values;
    // The fur is lit by parallel light from this lamp. Its surroundings are lit by a spot, whose soft edge extends from
    // well within the pit to the posts in front of it.
    constexpr double distance = 8, whole = 1.2, edge = 2.5;
    const glm::dvec3 towards = values[table_.lampDirection].value;
    render::LocalLight lamp;
    lamp.position = distance * towards;
    lamp.intensity = glm::dvec3(1, 0.86, 0.68) * (values[table_.lamp] * distance * distance);
    lamp.axis = -towards;
    lamp.coneInner = std::atan(whole / distance);
    lamp.coneOuter = std::atan(edge / distance);
    lamp.nearest = 0.65 * distance;  // Everything in the cone is farther away, for the lamp's initial direction.
    return {lamp};
}

std::vector<StandingShape> Fur::reflectedShapes(const ParameterValues& values) const
{
    const FurStates states = restStates(bounceSettings(table_, values, nullptr, 0));
    const Coats coats{table_, values, states};
    std::vector<StandingShape> shapes;
    for (int i = 0; i < furBodyCount; ++i) {
        const auto body = static_cast<std::size_t>(i);
        const CoatParameters& rows = table_.coats[body];
        const render::Box skin = skins_[body]->bounds;
        const glm::dvec3 half = coats.bounds(i, skin).halfSize();
        // Bare skin has the color of the roots.
        const glm::dvec3 outer = values[values[rows.length] > 0 ? rows.tip : rows.root].value;
        const glm::dvec3 color = 0.5 * (values[rows.root].value + outer);
        shapes.push_back(standingCylinder({states[body].position - half, states[body].position + half}, color));
    }
    return shapes;
}

void Fur::planShadow(const PlanContext& context, render::FramePlan& plan) const
{
    planMotion(context, plan);
    planCoatShadow(sceneOf(context, plan.seed), plan);
}

void Fur::plan(const PlanContext& context, render::FramePlan& plan) const
{
    planMotion(context, plan);
    const auto& now = static_cast<const Prepared&>(*context.prepared);
    for (std::size_t i = 0; i < furBodyCount; ++i)
        if (context.values[table_.silhouette] == FurSilhouette::fins && !now.fins[i])
            plan.warn("fur/model fins", whyUnfinned(now.skins[i]));
    if (now.model && !now.model->notes.empty()) plan.warn("fur/model", joined(now.model->notes, "; "));
    planCoats(sceneOf(context, plan.seed), plan);
}

}  // namespace vitrine::fur
