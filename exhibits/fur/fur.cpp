#include "exhibits/fur/fur.h"

#include "exhibits/fur/bounce.h"
#include "exhibits/fur/coat_mesh.h"
#include "exhibits/fur/fur_passes.h"
#include "render/files/asset_store.h"
#include "render/files/assets.h"
#include "render/scene/gltf.h"
#include "render/scene/held_bytes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <optional>

namespace vitrine {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::string seconds(double s)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", s);
    return text;
}

/// A file of the visitor's, or one of the program's own by its place among the assets: "models/teddy.glb".
std::string modelFile(const std::string& path)
{
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path;
    const std::filesystem::path own = render::asset(path);
    return std::filesystem::exists(own, ignored) ? own.string() : path;
}

std::string joined(const std::vector<std::string>& notes)
{
    std::string line;
    for (const std::string& note : notes) line += (line.empty() ? "" : "; ") + note;
    return line;
}

/// A press that never was is infinitely long ago.
bool clockIsRight(double time, double sinceOwnPress)
{
    return std::isfinite(time) && sinceOwnPress >= 0;
}

}  // namespace

struct Fur::Wardrobe {
    /// What a visitor's model becomes.
    struct RingModel {
        std::shared_ptr<const render::Mesh> skin;
        double radius = 0;               ///< Metres, of the ball that stands for it.
        std::vector<std::string> notes;  ///< What of it was left out or mended.
    };
    static render::AssetStore::Made<RingModel> readRingModel(const std::string& path)
    {
        auto model = std::make_shared<RingModel>();
        model->skin = modelSkin(render::loadGltf(path), path, ringRadius + ringTube, model->notes);
        model->radius = meanRadius(*model->skin);
        const std::uint64_t bytes = heldBytes(*model->skin);
        return {std::move(model), bytes};
    }

    std::shared_ptr<const render::Mesh> skins[furBodyCount] = {ballSkin(ballRadius, 8), rollSkin(rollRadius, rollHalfLength, 26), ringSkin(ringRadius, ringTube, 40)};
    std::shared_ptr<const render::Mesh> fins[furBodyCount];
    render::AssetStore assets;
    render::Asset<RingModel> model;  ///< Of the values asked about last.
    std::shared_ptr<const render::Mesh> modelFins;  ///< Of that model.
    std::optional<Bounce> bounce;
    std::int64_t stepsTold = 0;  ///< Steps of that jump that a plan has counted.
};

/// What the motion is at one moment, and why.
struct Fur::Moment {
    FurStates states;
    bool moving = false;
    std::string reason;         ///< Of the simulation step, or of its absence.
};

Fur::Fur() : wardrobe_(std::make_unique<Wardrobe>()) {}

Fur::~Fur() = default;

render::Box Fur::bounds(const ParameterValues& values) const
{
    return boundsAfterPress(values, never);
}

render::Box Fur::boundsAfterPress(const ParameterValues& values, double sinceOwnPress) const
{
    const bool pressed = sinceOwnPress >= 0 && sinceOwnPress <= Bounce::longest;
    const bool jumping = !values[table_.byHand] && (pressed || values[table_.frozenAt] > 0 || values[table_.bouncePeriod] > 0);
    render::Box space = bouncingSpace(table_, values, jumping);
    space.include({-pitRadius, 0, -pitRadius});
    space.include({pitRadius, 1.9, pitRadius});
    return space;
}

double Fur::firstHit(const ParameterValues& values, double time, double sinceOwnPress, const render::Ray& ray) const
{
    const Moment now = moment(values, time, sinceOwnPress);
    const std::shared_ptr<const Wardrobe::RingModel> model = wardrobe_->model.value;
    const Coats coats{table_, values, now.states, glm::dmat4(1), time, 1, model ? model->radius : 0};
    double nearest = never;
    for (int i = 0; i < furBodyCount; ++i) {
        const auto& skin = i == furRing && model ? model->skin : wardrobe_->skins[i];
        // The ellipsoid that touches the sides of the space the coat may fill.
        const render::Box space = coats.space(i, skin->bounds);
        const glm::dmat4 bodyFromBall = glm::scale(glm::translate(glm::dmat4(1), space.center()), glm::max(space.halfSize(), 1e-6));
        nearest = std::min(nearest, render::firstHit(ray.transformed(glm::inverse(coats.worldFromBody(i) * bodyFromBall)), glm::dvec3(0), 1));
    }
    // The floor of the pit is theirs, too.
    const double floor = render::firstHit(ray, {{-pitRadius, 0, -pitRadius}, {pitRadius, 0, pitRadius}});
    const glm::dvec3 there = std::isfinite(floor) ? ray.at(floor) : glm::dvec3(2 * pitRadius);
    return std::hypot(there.x, there.z) < pitRadius ? std::min(nearest, floor) : nearest;
}

render::Camera Fur::bestView(const ParameterValues&) const
{
    return {{-0.05, 1.55, 3.15}, {0.0, 0.36, 0}, 0.62};
}

double Fur::nextChange(const ParameterValues& values, double time) const
{
    return nextChangeAfterPress(values, time, never);
}

double Fur::nextChangeAfterPress(const ParameterValues& values, double time, double sinceOwnPress) const
{
    if (values[table_.wind] > 0 && values[table_.gustiness] > 0) return 0;
    return moment(values, time, sinceOwnPress).moving ? 0 : never;
}

std::vector<StudyView> Fur::studyViews(const ParameterValues& values) const
{
    ParameterValues spun = values;
    spun.set(table_.byHand, true);
    for (const Real pull : {table_.handX, table_.handY, table_.handZ}) spun.set(pull, 0.0);
    spun.set(table_.handTurn, 2.0943951023931953);
    ParameterValues landing = values;
    landing.set(table_.frozenAt, 0.9);
    // Stiff fur in long steps: of the three ways to step a spring, one flies off, one is late, one does not notice.
    ParameterValues stiff = landing;
    stiff.set(table_.frequency, 4.0);
    stiff.set(table_.springRate, 30);
    // In such an order that three of them are the hard ones of shell count, rotation and springs.
    return {{"silhouette", {{-1.05, 0.75, 1.1}, {-1.0, 0.62, 0}, 0.42}, 0, values},
            {"best view", bestView(values), 0, values},
            {"spin of 120 degrees", {{-0.62, 0.6, 1.9}, {-0.62, 0.42, 0}, 0.6}, 0, spun},
            {"tip", {{0.55, 0.72, 1.35}, {0.55, 0.42, 0.72}, 0.3}, 0, values},
            {"landing", bestView(values), 0, landing},
            {"stiff fur in long steps", bestView(values), 0, stiff}};
}

Fur::Moment Fur::moment(const ParameterValues& values, double time, double sinceOwnPress) const
{
    Wardrobe& w = *wardrobe_;
    const std::string path = values[table_.ringModel];
    render::Asset<Wardrobe::RingModel> model;
    if (!path.empty()) model = w.assets.get<Wardrobe::RingModel>("fur.ringModel", modelFile(path), Wardrobe::readRingModel);
    if (model.value != w.model.value) w.modelFins = nullptr;
    w.model = std::move(model);
    const std::shared_ptr<const render::Mesh> skin = w.model.value ? w.model.value->skin : nullptr;
    const bool right = clockIsRight(time, sinceOwnPress);
    const double now = right ? time : 0;
    double since = right && sinceOwnPress < 1e6 ? sinceOwnPress : never;
    const bool byItself = values[table_.bouncePeriod] > 0;
    const bool frozen = values[table_.frozenAt] > 0;
    if (byItself) since = now - std::floor(now / values[table_.bouncePeriod]) * values[table_.bouncePeriod];
    if (frozen) since = values[table_.frozenAt];
    if (values[table_.byHand]) since = never;
    const bool growing = values[table_.growing] && values[table_.growth] > 0 && values[table_.growthRate] > 0 && !values[table_.byHand];

    Moment m;
    const BounceSettings settings = bounceSettings(table_, values, skin, since == never || frozen ? now : now - since);
    if (since == never) {
        m.states = restStates(settings, 0);
        m.moving = growing;
        m.reason = growing ? "the ball grows and shrinks" : "at rest";
        if (values[table_.byHand]) {
            m.reason = "set by hand";
            for (FurState& state : m.states) {
                state.grown = 1;
                state.pull = {values[table_.handX], values[table_.handY], values[table_.handZ]};
                state.lag = glm::angleAxis(values[table_.handTurn], glm::dvec3(0, 0, 1));
            }
        }
        return m;
    }
    if (!w.bounce || !(w.bounce->settings() == settings)) {
        w.bounce.emplace(settings);
        w.stepsTold = 0;
    }
    m.states = w.bounce->at(since);
    const double rested = w.bounce->restedAt(since);
    m.moving = !frozen && (growing || byItself || rested > since);
    if (frozen) m.reason = "frozen " + seconds(since) + " after the jump";
    else if (rested <= since) m.reason = growing ? "the ball grows and shrinks" : "at rest since " + seconds(since - rested);
    else m.reason = (byItself ? "jumped by themselves " : "woken by the button ") + seconds(since) + " ago";
    return m;
}

void Fur::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const ParameterValues& values = context.values;
    constexpr const char* motion = "fur/motion";
    const bool right = clockIsRight(context.time, context.sinceOwnPress);
    // Without a number, so that it stays one line in the log however the clock goes on.
    if (!right) plan.complain("fur/clock", "the time is no number, or lies before the press of the button; the bodies are shown at rest until it is right", render::Work::simulation);
    if (!context.hiddenBecause.empty() && !context.noShadowBecause.empty()) {
        // Nobody sees where they are; when somebody does again, the jump is simulated up to then.
        plan.skip(motion, context.hiddenBecause, render::Work::simulation);
        for (const char* name : {"fur/coat", "fur/fins", "fur/shade", "fur/floor"}) plan.skip(name, context.hiddenBecause);
        plan.skip("fur/shadow", context.noShadowBecause);
        return;
    }
    const Moment now = moment(values, context.time, context.sinceOwnPress);
    Wardrobe& w = *wardrobe_;
    const std::int64_t steps = w.bounce ? w.bounce->steps() - w.stepsTold : 0;
    if (now.moving || steps > 0) {
        // Where things are decides what is drawn, so planning has already taken these steps.
        w.stepsTold += steps;
        render::Pass pass;
        pass.name = motion;
        pass.reason = now.reason;
        pass.stage = render::Stage::simulate;
        pass.work = render::Work::simulation;
        pass.writes = {"fur.bodies"};
        pass.counts["simulationSteps"] = steps;
        plan.add(std::move(pass));
    } else {
        plan.skip(motion, now.reason, render::Work::simulation);
    }
    const std::shared_ptr<const Wardrobe::RingModel> model = w.model.value;
    FurScene scene{context, {table_, values, now.states, context.worldFromExhibit, right ? context.time : 0, plan.seed, model ? model->radius : 0}, {}, {}};
    for (int i = 0; i < furBodyCount; ++i) {
        const bool worn = i == furRing && model;
        scene.skins[i] = worn ? model->skin : w.skins[i];
        if (values[table_.silhouette] != FurSilhouette::fins) continue;
        std::shared_ptr<const render::Mesh>& fins = worn ? w.modelFins : w.fins[i];
        const int rows = finRows(*scene.skins[i]);
        if (!fins && rows > 0) fins = finsOf(*scene.skins[i], rows);
        if (!fins) plan.complain("fur/model fins", "the model has more than 200,000 triangles, too many for fins; a march fills its silhouette as well");
        scene.fins[i] = fins;
    }
    if (model && !model->notes.empty()) plan.complain("fur/model", joined(model->notes));
    if (!w.model.failure.empty())
        plan.complainOfFile("fur/model", unreadableFile(values.rows()[table_.ringModel.row], title(), w.model.failure), "The ring is shown in its place until it can be read.");
    planCoats(scene, plan);
}

}  // namespace vitrine
