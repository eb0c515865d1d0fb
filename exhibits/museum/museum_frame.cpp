// Planning of one frame: the passes of the hall and of all exhibits in view.
#include "exhibits/museum/museum.h"

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/framework/scene/shows_pictures.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/time/animation.h"
#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_scene.h"
#include "exhibits/hall/walk.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/museum/lamps.h"
#include "exhibits/museum/present.h"
#include "exhibits/museum/shown_pictures.h"
#include "render/hash.h"
#include "render/plan/embedded_plan.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {
namespace {

constexpr double shadowReach = 30;  ///< Meters behind an exhibit within which its shadow may fall on something.

/// Returns the reason for the frame report.
std::string whyHiddenOf(const std::string& hidden, const ParameterValues& values)
{
    return values.motions().empty() ? hidden : hidden + ": its animated parameters do not trigger new frames";
}

}  // namespace

/// State during the planning of one frame.
struct Museum::Frame {
    const Museum& museum;
    const Prepared& prepared;
    const FrameRequest& request;
    const bool alone;
    const hall::HallScene scene;
    SceneLighting light;
    std::vector<Present> present;
    std::vector<PlanContext> contexts;  ///< One for each exhibit in `present`.
    render::FramePlan plan;
    bool isPicture = false;  ///< It is a picture that an exhibit shows, and exhibits that show pictures are dark.

    void begin();
    void findPresent();
    void planRest(const render::PersistentState& kept);
    void castShadows();
    [[nodiscard]] std::string whyNoShadow() const;
    void clearGlassShadow(render::Pass clear);
    void makeContexts();
    void lightLamps();
    void declareImages(render::FramePlan&) const;
    void planBuilding(render::FramePlan&) const;
    void planExhibits(const render::PersistentState& kept);
    void finish(const render::PersistentState&);
    [[nodiscard]] hall::FrameHistory history() const;

    void clearPicture(render::FramePlan&) const;
    void addState(render::Hash&, const Present&) const;
    [[nodiscard]] std::uint64_t castersKey() const;
    [[nodiscard]] render::FramePlan planOfView(const render::View&) const;
    void planSeen(std::size_t i, const PlanContext&, const render::PersistentState* kept, render::FramePlan&) const;
    void planReflectedWorks(const render::PersistentState& kept);
    void drawReflectedWork(const MuseumExhibit&, const ParameterValues& still, const render::View&,
                           const std::string& image);
    [[nodiscard]] std::optional<hall::ReflectedWork> planReflectedWork(const MuseumExhibit&,
                                                                       const render::PersistentState& kept);
    [[nodiscard]] std::uint64_t pictureKey() const;
    [[nodiscard]] std::optional<ShownPicture> planPicture(const Present& by, const std::string& source,
                                                          const render::PersistentState* kept,
                                                          render::FramePlan& into) const;
};

render::FramePlan Museum::plan(const Prepared& prepared, const FrameRequest& request,
                               const render::PersistentState& kept) const
{
    const bool alone = request.alone.has_value();
    Frame frame{*this, prepared, request, alone, sceneOf(prepared, alone), {}, {}, {}, {}};
    frame.begin();
    frame.findPresent();
    frame.planRest(kept);
    return std::move(frame.plan);
}

/// Plans everything after `findPresent`, and prunes the plan.
void Museum::Frame::planRest(const render::PersistentState& kept)
{
    castShadows();
    makeContexts();
    lightLamps();
    hall::planHallShadow(scene, light, plan);
    hall::planBouncedLight(scene, light, plan);
    hall::planAirLight(scene, light, plan);
    hall::planProbe(scene, light, plan);
    planReflectedWorks(kept);
    if (!alone && !request.cutOut) hall::planContactShadows(scene, plan);
    planBuilding(plan);
    planExhibits(kept);
    finish(kept);
}

hall::FrameHistory Museum::Frame::history() const
{
    hall::FrameHistory history{pictureQuality(scene.values).historyFrames};
    if (history.frames <= 1) return history;
    render::Hash look;
    for (std::size_t i = 0; i < prepared.exhibits.size(); ++i) {
        // Animated parameters do not reset the history, just as the clock does not.
        derive::addToKey(look, valuesAtEnd(prepared.sceneState.values[i], 0));
        look.addValue(prepared.exhibits[i].part ? prepared.exhibits[i].part->filesId : 0);
    }
    look.addValue(scene.filesId).addValue(alone).addValue(request.transparent).addValue(request.exhibitTransform);
    history.look = look.value();
    return history;
}

/// Sets up the view, the shared images, and the light.
void Museum::Frame::begin()
{
    render::Raster raster = request.raster;
    const hall::FrameHistory averaged = history();
    const bool inMotion = hall::isAveragedOverFrames(request, averaged);
    const int sample = inMotion ? hall::antialiasingSample(request) : request.sample;
    raster.jitter = render::samplePosition(sample, inMotion ? averaged.frames : request.samples);
    plan.view = render::makeView(request.camera, raster);
    plan.time = prepared.time;
    plan.seed = request.seed;
    plan.sample = sample;
    plan.runEverything = request.runEverything;
    plan.resetHistory = request.resetHistory;
    plan.allSlices = request.finished;
    declareImages(plan);
    light = hall::sceneLighting(scene, request.runEverything);
    light.light.sampleIndex = sample;
}

/// Declares the images that all passes draw into.
void Museum::Frame::declareImages(render::FramePlan& into) const
{
    const bool exact = request.averageIn == AverageIn::radiance;
    into.image({.name = radianceImage, .format = exact ? render::Format::rgba32f : render::Format::rgba16f});
    into.image({.name = depthImage, .format = render::Format::depth32f, .nearest = true});
    into.image({.name = normalImage, .format = render::Format::rgba32f});
    into.image({.name = evaluationsImage, .format = render::Format::r32f});
    into.image({.name = albedoImage, .format = render::Format::rgba16f});
}

/// Finds the exhibits in this picture, and reports files that they need and cannot read.
void Museum::Frame::findPresent()
{
    present = museum.presentIn(prepared, request, scene, plan.view);
    constexpr const char* notPrepared = "it was not prepared for this view";
    for (Present& p : present) {
        const PreparedExhibit& exhibit = prepared.exhibits[p.index];
        if (p.hidden.empty() && !exhibit.seen) p.hidden = notPrepared;
        if (p.noShadow.empty() && !exhibit.shadowSeen) p.noShadow = notPrepared;
    }
    const auto warn = [&](const PreparedPart* part) {
        if (!part) return;
        for (const UnreadableFile& file : part->unreadable)
            plan.warnOfFile(file.step, file.why.english(), file.instead.english());
    };
    warn(prepared.hall.get());
    for (const Present& p : present)
        if (p.hidden.empty() || p.noShadow.empty()) warn(prepared.exhibits[p.index].part.get());
}

/// Adds everything that changes the appearance of an exhibit to the key.
void Museum::Frame::addState(render::Hash& key, const Present& p) const
{
    const ExhibitState state = prepared.state(p.index);
    derive::addToKey(key, state.values);
    key.addValue(p.index).addValue(p.worldFromExhibit).addValue(state.prepared ? state.prepared->filesId : 0);
    if (p.exhibit.nextChangeOf(state) < std::numeric_limits<double>::infinity())
        key.addValue(state.time).addValue(state.sinceOwnPress);
}

/// Returns why no exhibit casts a shadow: the reason common to all that could cast one.
std::string Museum::Frame::whyNoShadow() const
{
    std::set<std::string> reasons;
    for (const Present& p : present)
        if (p.exhibit.castsShadow() && !capability<OverFrame>(p.exhibit)) reasons.insert(p.noShadow);
    if (reasons.contains(Present::othersFirst)) return Present::othersFirst;
    if (reasons.size() > 1) return "no exhibit throws a shadow that may be seen";
    if (reasons.size() == 1) return *reasons.begin();
    return present.empty() ? "no exhibit stands here" : present.front().noShadow;
}

/// Plans the sun's shadow map of the exhibits: either all of them are drawn into it, or none.
void Museum::Frame::castShadows()
{
    render::Box casters;
    render::Hash key;
    bool shadowSeen = false;
    for (const Present& p : present) {
        if (p.unlit.empty()) {
            // Includes hidden exhibits, so that the map's texel grid does not change while the visitor walks.
            casters.include(p.box.low);
            casters.include(p.box.high);
        }
        if (!p.noShadow.empty()) continue;
        shadowSeen = true;
        addState(key, p);
    }
    if (!shadowSeen) {
        plan.skip("exhibits/shadow", whyNoShadow());
        return;
    }
    const int size = std::max(scene.values[scene.table.shadowMapSize] / 4, 64);
    light.exhibitShadowView = steadyLightView(casters, light.towardsSun, glm::ivec2(size), shadowReach);
    light.light.exhibitShadowFromWorld = shadowFromWorld(light.exhibitShadowView);
    light.light.exhibitsCastShadow = true;
    light.light.exhibitShadowTexel = static_cast<float>(2 / light.exhibitShadowView.clipFromView[0][0] / size);
    light.exhibitShadowKey = key.addValue(light.exhibitShadowView.clipFromWorld).value();
    light.inputs.push_back({UNIT_SHADOW_EXHIBITS, std::string(exhibitShadowImage)});
    plan.image({.name = exhibitShadowImage,
                .format = render::Format::depth32f,
                .size = glm::ivec2(size),
                .persistent = true,
                .comparison = true});
    const bool glass = std::any_of(present.begin(), present.end(), [&](const Present& p) {
        const auto* caster = p.noShadow.empty() ? capability<CastsGlassShadow>(p.exhibit) : nullptr;
        return caster && caster->castsGlassShadow(prepared.sceneState.values[p.index]);
    });
    render::Pass clear;
    clear.name = "exhibits/shadow";
    clear.reason = "an exhibit stands in the sun";
    clear.phase = render::PassPhase::shadow;
    clear.shader = meshDepth().shader;
    clear.view = light.exhibitShadowView;
    clear.depth = render::Attachment::cleared(exhibitShadowImage);
    clear.contentHash = light.exhibitShadowKey;
    clear.bound = light.sunShadow;
    if (glass) clearGlassShadow(clear);
    plan.add(std::move(clear));
}

/// Clears the map of sunlight through glass: white at the nearest depth where there is no glass.
void Museum::Frame::clearGlassShadow(render::Pass clear)
{
    light.glassCastsShadow = true;
    light.inputs.push_back({UNIT_SHADOW_GLASS, std::string(glassShadowImage)});
    plan.image({.name = glassShadowImage,
                .format = render::Format::rgba32f,
                .size = clear.view->raster.size,
                .persistent = true});
    clear.name = "exhibits/shadow/glass";
    clear.reason = "glass stands in the sun";
    clear.depth.reset();
    clear.colors = {render::Attachment::cleared(glassShadowImage, glm::vec4(1))};
    plan.add(std::move(clear));
}

/// Plans the walls, or clears the picture if there are none.
void Museum::Frame::planBuilding(render::FramePlan& into) const
{
    if (alone)
        into.skip("hall/walls", "the exhibit is shown alone");
    else if (request.cutOut)
        into.skip("hall/walls", "only one exhibit is requested, without its surroundings");
    else
        hall::planWalls(scene, light, request.channels, into);
    if (alone || request.cutOut) clearPicture(into);
}

/// Clears the picture if no walls cover it.
void Museum::Frame::clearPicture(render::FramePlan& into) const
{
    render::Pass clear;
    clear.name = "clear";
    clear.reason = "clears the picture";
    clear.phase = render::PassPhase::prepare;
    clear.shader = meshDepth().shader;
    clear.colors = {render::Attachment::cleared(radianceImage)};
    if (request.channels.normal) clear.colors.push_back(render::Attachment::cleared(normalImage));
    if (request.channels.evaluations) clear.colors.push_back(render::Attachment::cleared(evaluationsImage));
    if (request.channels.albedo) clear.colors.push_back(render::Attachment::cleared(albedoImage));
    clear.depth = render::Attachment::cleared(depthImage);
    into.add(std::move(clear));
}

/// Makes the contexts for the exhibits' planning. They refer to the frame's light, which may still change.
void Museum::Frame::makeContexts()
{
    for (const Present& p : present) {
        const ExhibitState state = prepared.state(p.index);
        contexts.push_back({.values = state.values,
                            .lighting = light,
                            .worldFromExhibit = p.worldFromExhibit,
                            .time = state.time,
                            .channels = request.channels,
                            .alone = alone,
                            .onNothing = request.transparent || request.cutOut.has_value(),
                            .sinceOwnPress = state.sinceOwnPress,
                            .prepared = state.prepared,
                            .worldBox = p.box});
    }
}

/// Plans the passes of all exhibits, then those that draw over the frame.
void Museum::Frame::planExhibits(const render::PersistentState& kept)
{
    for (std::size_t i = 0; i < present.size(); ++i) {
        const Exhibit& exhibit = present[i].exhibit;
        const std::string name(exhibit.name());
        if (present[i].noShadow.empty())
            exhibit.planShadow(contexts[i], plan);
        else
            plan.skip(name + "/shadow", present[i].noShadow);
        if (present[i].hidden.empty())
            planSeen(i, contexts[i], &kept, plan);
        else if (!capability<OverFrame>(exhibit))  // An OverFrame exhibit is drawn wherever its bounds are.
            plan.skip(name, whyHiddenOf(present[i].hidden, contexts[i].values));
    }
    for (const auto& [i, exhibit] : museum.exhibits_)
        if (!alone && !museum.isInHall(i)) plan.skip(std::string(exhibit.name()), "it is not placed in the hall");
    for (std::size_t i = 0; i < present.size(); ++i) {
        const auto* over = capability<OverFrame>(present[i].exhibit);
        if (!over) continue;
        PlanContext context = contexts[i];
        context.planOfView = [this](const render::View& view) { return planOfView(view); };
        over->planOverFrame(context, plan);
    }
}

/// Plans the passes of an exhibit in view. `kept`: null for another view of the same frame, which reads the pictures of
/// the frame.
void Museum::Frame::planSeen(std::size_t i, const PlanContext& context, const render::PersistentState* kept,
                             render::FramePlan& into) const
{
    const Present& p = present[i];
    const auto* shows = capability<ShowsPictures>(p.exhibit);
    const auto* continues = capability<ContinuesState>(p.exhibit);
    const render::PersistentState none;
    if (shows && !shows->shownPictures(context.values).empty()) {
        PlanPicture picture;
        if (!isPicture)
            picture = [&](const std::string& source, render::FramePlan& of) {
                return planPicture(p, source, kept, of);
            };
        return shows->planShowing(context, kept ? *kept : none, picture, into);
    }
    if (kept && continues) return continues->planFrom(context, *kept, into);
    p.exhibit.plan(context, into);
}

/// Plans small pictures of the works behind openings in the walls, as the reflection probe sees them, for mirrors.
/// Animations and the clock stand at 0: like other movement, theirs is not visible in reflections.
void Museum::Frame::planReflectedWorks(const render::PersistentState& kept)
{
    std::string why = museum.whyNoWorks(prepared, request, scene, plan.view, present);
    if (isPicture) why = "a picture on a screen does not show them";
    if (!light.light.hasProbe) why = "there is no reflection probe";
    std::vector<hall::ReflectedWork> works;
    if (why.empty())
        for (const MuseumExhibit& shown : museum.exhibits_)
            if (museum.isInHall(shown.index) && prepared.exhibits[shown.index].seen)
                if (auto work = planReflectedWork(shown, kept)) works.push_back(std::move(*work));
    if (why.empty() && works.empty()) why = "no work hangs behind an opening";
    if (why.empty())
        hall::planMirroredWorks(scene, light, works, plan);
    else
        plan.skip("probe/works", why);
}

/// Plans the radiance of a work in a view of the reflection probe, as the image `image`/radiance.
void Museum::Frame::drawReflectedWork(const MuseumExhibit& shown, const ParameterValues& still,
                                      const render::View& view, const std::string& image)
{
    render::FramePlan inner;
    inner.view = view;
    inner.seed = plan.seed;
    inner.resetHistory = true;
    inner.allSlices = true;  // It is small, and kept once it is drawn.
    declareImages(inner);
    clearPicture(inner);
    const PlanContext context{.values = still,
                              .lighting = light,
                              .worldFromExhibit = museum.worldFromExhibit(shown.index),
                              .prepared = prepared.state(shown.index).prepared};
    const auto* shows = capability<ShowsPictures>(shown.exhibit);
    if (shows && !shows->shownPictures(still).empty())
        shows->planShowing(context, {}, {}, inner);  // Pictures of other exhibits are dark in reflections.
    else
        shown.exhibit.plan(context, inner);
    inner.prune({radianceImage});
    render::embed(plan, inner, {.passPrefix = image + '/', .imagePrefix = image + '/', .reason = "a mirror shows it"});
}

/// Returns nothing if the exhibit is no work behind an opening that faces the probe.
std::optional<hall::ReflectedWork> Museum::Frame::planReflectedWork(const MuseumExhibit& shown,
                                                                    const render::PersistentState& kept)
{
    const auto& [i, exhibit] = shown;
    const render::Box bounds = museum.boundsOf(prepared, exhibit, i);
    if (!isBehindOpening(bounds)) return std::nullopt;
    hall::ReflectedWork work;
    work.worldFromOpening = glm::scale(glm::translate(museum.worldFromExhibit(i), bounds.center()),
                                       glm::dvec3(glm::dvec2(bounds.halfSize()), 1));
    const std::optional<render::View> view = hall::viewThrough(scene, work.worldFromOpening);
    if (!view) return std::nullopt;
    work.clipFromWorld = view->clipFromWorld;
    work.image = std::string(exhibit.name()) + "/reflected";
    const ParameterValues still = valuesAtEnd(prepared.sceneState.values[i], 0);
    const PreparedPart* part = prepared.state(i).prepared;
    render::Hash key;
    derive::addToKey(key, still);
    key.addValue(i).addValue(view->clipFromWorld).addValue(view->raster.size).addValue(hall::lightKey(scene));
    work.key = key.addValue(part ? part->filesId : 0).addValue(plan.seed).value();
    const auto held = kept.passes.find(work.image);
    // While values are being changed in the window, the last picture stays: it would be made again for every step.
    if (request.nonBlocking && !request.idle && held != kept.passes.end()) work.key = held->second;
    if (request.runEverything || held == kept.passes.end() || held->second != work.key)
        drawReflectedWork(shown, still, *view, work.image);
    plan.image({.name = work.image, .format = render::Format::rgba16f, .size = view->raster.size, .persistent = true});
    render::Pass pass;
    pass.name = work.image;
    pass.reason = "a mirror shows it";
    pass.phase = render::PassPhase::simulate;
    pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = "lib/copy.frag", .defines = {"COVERAGE"}};
    pass.inputs = {{UNIT_SOURCE, work.image + '/' + radianceImage}};
    pass.colors = {render::Attachment::cleared(work.image)};
    pass.draws = {render::Draw{}};
    pass.contentHash = work.key;
    plan.add(std::move(pass));
    return work;
}

/// Returns a hash of everything that the picture depends on.
std::uint64_t Museum::Frame::pictureKey() const
{
    render::Hash key;
    derive::addToKey(key, prepared.sceneState.hall());
    key.addValue(scene.filesId).addValue(hall::lightKey(scene)).addValue(alone).addValue(request.runEverything);
    key.addValue(plan.view.clipFromWorld).addValue(plan.view.raster.size).addValue(plan.seed);
    for (const hall::ExhibitPose& pose : scene.poses)
        key.addValue(pose.rotation).addValue(hall::buttonScale(pose.sincePress));
    const bool shadows = throwShadows(museum.lampsOf(prepared, present, alone));
    for (const Present& p : present) {
        const bool isSeen = p.hidden.empty() || p.noShadow.empty() || capability<OverFrame>(p.exhibit);
        const auto* shows = capability<ShowsPictures>(p.exhibit);
        if (shows && !shows->shownPictures(prepared.sceneState.values[p.index]).empty()) continue;  // It is dark.
        if (isSeen || shadows || capability<HasLocalLights>(p.exhibit)) addState(key, p);
    }
    return key.value();
}

/// Plans the picture of a source that an exhibit shows, as a frame within this one.
std::optional<ShownPicture> Museum::Frame::planPicture(const Present& by, const std::string& source,
                                                       const render::PersistentState* kept,
                                                       render::FramePlan& into) const
{
    const auto wanted = requestOfPicture(museum, prepared.sceneState, request, by.index, source);
    if (!wanted) return std::nullopt;
    const bool isAlone = wanted->alone.has_value();
    Frame inner{museum, prepared, *wanted, isAlone, museum.sceneOf(prepared, isAlone), {}, {}, {}, {}, true};
    inner.begin();
    inner.findPresent();
    const std::string name = std::string(by.exhibit.name()) + "/picture of " + source;
    const ShownPicture shown{name, wanted->raster.size, inner.pictureKey()};
    if (!kept || into.images().contains(name)) return shown;
    inner.planRest({});
    inner.plan.prune({"frame"});
    const auto held = kept->passes.find(name);
    const bool isHeld = !request.runEverything && held != kept->passes.end() && held->second == shown.key;
    render::embed(into, inner.plan,
                  {.passPrefix = name + '/',
                   .imagePrefix = name + '/',
                   .reason = "a screen shows its picture",
                   .onlyKept = isHeld});
    into.image({.name = name, .format = render::Format::rgba8, .size = shown.size, .persistent = true});
    render::Pass pass;
    pass.name = name;
    pass.reason = "a screen shows it";
    pass.phase = render::PassPhase::simulate;
    pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = "kit/shown_picture.frag"};
    pass.inputs = {{UNIT_SOURCE, name + "/frame"}};
    pass.colors = {render::Attachment::cleared(name)};
    pass.draws = {render::Draw{}};
    pass.contentHash = shown.key;
    into.add(std::move(pass));
    return shown;
}

/// Plans hall and exhibits for another view of the same frame, without shadow maps and exhibits over the frame.
render::FramePlan Museum::Frame::planOfView(const render::View& view) const
{
    render::FramePlan other;
    other.view = view;
    other.time = plan.time;
    other.seed = plan.seed;
    other.sample = plan.sample;
    declareImages(other);
    planBuilding(other);
    for (std::size_t i = 0; i < present.size(); ++i) {
        const std::size_t exhibit = present[i].index;
        if (!prepared.exhibits[exhibit].seen || !museum.whyHidden(present[i].box, view, alone).empty()) continue;
        PlanContext context = contexts[i];
        context.channels = {};
        planSeen(i, context, nullptr, other);
    }
    return other;
}

/// Returns a hash of everything that casts a lamp's shadow.
std::uint64_t Museum::Frame::castersKey() const
{
    render::Hash key;
    key.addValue(alone).addValue(request.cutOut.has_value()).addValue(hall::lightKey(scene));
    for (const hall::ExhibitPose& pose : scene.poses)
        key.addValue(pose.rotation).addValue(hall::buttonScale(pose.sincePress));
    for (const Present& p : present) addState(key, p);
    return key.value();
}

/// Plans the lamps in this picture.
void Museum::Frame::lightLamps()
{
    const std::vector<render::LocalLight> lamps = museum.lampsOf(prepared, present, alone);
    const glm::dvec3 size = museum.model_->bounds().halfSize();
    light.localLights = planLamps({.lights = lamps,
                                   .center = request.camera.target,
                                   .radius = 2 * glm::length(size),
                                   .castersKey = lamps.empty() ? 0 : castersKey(),
                                   .planOfView = [this](const render::View& view) { return planOfView(view); }},
                                  plan);
    if (!light.localLights) return;
    light.brightest += mostRadianceBy(*light.localLights);
    if (light.building) render::divideIntoCells(light.localLights->block, *light.building);
}

/// Plans the sky and the tone mapping, then prunes the plan.
void Museum::Frame::finish(const render::PersistentState& kept)
{
    if (request.transparent || request.cutOut)
        plan.skip("sky", "a transparent background is requested");
    else
        hall::planSky(scene, light, plan);
    if (!isPicture) hall::planHeatMap(scene, light, request, plan);
    // Exhibits may shine themselves, and so may the user's objects. The sun's reflection has no bound.
    const bool bounded =
        scene.objects.empty() && light.sunIrradiance == glm::dvec3(0) &&
        std::none_of(present.begin(), present.end(), [](const Present& p) { return p.hidden.empty(); });
    const double brightest = bounded ? light.brightest : std::numeric_limits<double>::infinity();
    hall::planToneMapping(scene, light, brightest, request, history(), plan);
    std::vector<std::string> outputs{"frame", depthImage, hall::frameHistoryImage};
    if (request.channels.normal) outputs.emplace_back(normalImage);
    if (request.channels.evaluations) outputs.emplace_back(evaluationsImage);
    if (request.channels.albedo) outputs.emplace_back(albedoImage);
    plan.prune(outputs, kept);
}

}  // namespace vitrine
