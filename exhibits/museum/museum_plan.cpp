// Planning of a frame: exhibits in view, their prepared parts, and the passes of all.
#include "exhibits/museum/museum.h"

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/time/animation.h"
#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/hall/walk.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/museum/lamps.h"
#include "exhibits/museum/present.h"
#include "exhibits/museum/shown_pictures.h"
#include "render/failure.h"
#include "render/hash.h"
#include "render/plan/embedded_plan.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace vitrine {
namespace {

constexpr const char* othersFirst = "the window is opening, and nearer exhibits are drawn first";

/// Returns whether the picture is one of the first of a window.
bool isOpening(const FrameRequest& request)
{
    return request.mostExhibits < std::numeric_limits<int>::max();
}

constexpr double shadowReach = 30;  ///< Meters behind an exhibit within which its shadow may fall on something.

/// Returns why no shadow is drawn; empty if the sun may reach the box and the shadow may be visible.
std::string whyNoShadow(const hall::HallScene& scene, const render::Box& box, const render::View& view)
{
    if (std::string why = hall::whyUnlit(scene, box); !why.empty()) return why;
    return view.mayContain(withShadow(box, hall::towardsSun(scene))) ? std::string()
                                                                     : "neither it nor its shadow is in view";
}

/// Returns the reason for the frame report.
std::string whyHiddenOf(const std::string& hidden, const ParameterValues& values)
{
    return values.motions().empty() ? hidden : hidden + ": its animated parameters do not trigger new frames";
}

constexpr const char* noMirror = "no mirror in view is large enough to show them";

/// Returns whether a mirror with these bounds is large enough to show works behind openings in the walls. At fewer
/// pixels, each of them would be smaller than a few pixels.
bool isLargeMirror(const render::Box& box, const render::View& view)
{
    constexpr double fewest = 128;  // Pixels of the picture's height.
    const double radius = glm::length(box.halfSize());
    const double away = std::max(glm::distance(box.center(), view.eye), radius);
    return view.raster.size.y * radius > fewest * view.tanHalfFov.y * away;
}

/// Returns whether the exhibit is a work behind an opening in a wall: its bounds are flat and face into the room.
bool isBehindOpening(const render::Box& bounds)
{
    const glm::dvec3 size = bounds.high - bounds.low;
    return size.z == 0 && size.x > 0 && size.y > 0;
}

/// Returns a view that covers all samples and tiles of the picture, with a small margin.
render::View widened(const render::View& view)
{
    constexpr double pixels = 4;
    const glm::dvec2 share = 1.0 / (1.0 + pixels / glm::dvec2(glm::max(view.raster.size, glm::ivec2(1))));
    render::View wide = view;
    wide.clipFromView = glm::scale(glm::dmat4(1), glm::dvec3(share, 1)) * view.clipFromView;
    wide.clipFromWorld = wide.clipFromView * wide.viewFromWorld;
    return wide;
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

std::string Museum::whyHidden(const render::Box& box, const render::View& view, bool alone) const
{
    if (alone) return view.mayContain(box) ? std::string() : "out of view";  // No walls are drawn in this case.
    return hall::whyHidden(*model_, box, view);
}

hall::HallScene Museum::sceneOf(const Prepared& prepared, bool alone) const
{
    hall::HallScene scene = hall_->scene(prepared.sceneState.hall(), alone, prepared.hall.get());
    for (const auto& [i, exhibit] : exhibits_) {
        const auto* turns = capability<TurnsHangings>(exhibit);
        scene.poses.push_back(
            {turns ? turns->turnOfHangings(prepared.sceneState.values[i], prepared.time) : 0, prepared.sincePress(i)});
        if (alone || !isInHall(i)) continue;
        if (const auto* stands = capability<StandsOnFloor>(exhibit))
            for (const StandingShape& shape : stands->standingShapes(prepared.sceneState.values[i]))
                scene.bodies.push_back(moved(shape, worldFromExhibit(i)));
        if (const auto* seen = capability<SeenInReflections>(exhibit))
            for (const StandingShape& shape : seen->reflectedShapes(prepared.sceneState.values[i]))
                scene.besideFloor.push_back(moved(shape, worldFromExhibit(i)));
    }
    if (alone) return scene;
    takeLamps(*hall_, {prepared.sceneState.hall(), prepared.time}, glm::dmat4(1), true, scene.steadyLamps);
    for (const auto& [i, exhibit] : exhibits_)
        if (isInHall(i)) takeLamps(exhibit, prepared.state(i), worldFromExhibit(i), true, scene.steadyLamps);
    return scene;
}

std::vector<render::LocalLight> Museum::lampsOf(const Prepared& prepared, const std::vector<Present>& present,
                                                bool alone) const
{
    std::vector<render::LocalLight> lamps;
    if (!alone) takeLamps(*hall_, {prepared.sceneState.hall(), prepared.time}, glm::dmat4(1), false, lamps);
    for (const Present& p : present) takeLamps(p.exhibit, prepared.state(p.index), p.worldFromExhibit, false, lamps);
    return lamps;
}

void Museum::leaveToLater(std::vector<Present>& present, const FrameRequest& request)
{
    std::vector<std::pair<double, Present*>> seen;
    for (Present& p : present)
        if ((p.hidden.empty() || p.noShadow.empty()) && !capability<OverFrame>(p.exhibit))
            seen.emplace_back(glm::distance(p.box.center(), request.camera.eye), &p);
    if (seen.size() <= static_cast<std::size_t>(std::max(request.mostExhibits, 0))) return;
    std::sort(seen.begin(), seen.end());
    for (std::size_t i = static_cast<std::size_t>(std::max(request.mostExhibits, 0)); i < seen.size(); ++i) {
        Present& later = *seen[i].second;
        if (later.hidden.empty()) later.hidden = othersFirst;
        if (later.exhibit.castsShadow()) later.noShadow = othersFirst;
    }
}

std::vector<Museum::Present> Museum::presentIn(const Prepared& prepared, const FrameRequest& request,
                                               const hall::HallScene& scene, const render::View& view) const
{
    std::vector<Present> present;
    for (const auto& [i, exhibit] : exhibits_) {
        if ((request.alone && i != *request.alone) || (request.cutOut && i != *request.cutOut)) continue;
        if (!request.alone && !isInHall(i)) continue;
        Present p{i, exhibit, scene.alone ? glm::dmat4(1) : worldFromExhibit(i), {}, {}, {}, {}};
        if (request.subject == i || request.alone == i)
            p.worldFromExhibit = p.worldFromExhibit * request.exhibitTransform;
        p.box = boundsOf(prepared, exhibit, i).transformed(p.worldFromExhibit);
        p.unlit = capability<OverFrame>(exhibit) ? "it is made of light"
                  : exhibit.castsShadow()        ? hall::whyUnlit(scene, p.box)
                                                 : "it throws no shadow";
        const auto* around = request.alone == i ? capability<HasSurroundings>(exhibit) : nullptr;
        const bool surrounds = around && around->surrounds(prepared.sceneState.values[i]);
        p.hidden = request.runEverything || surrounds ? std::string() : whyHidden(p.box, view, scene.alone);
        p.noShadow = !p.unlit.empty() || request.runEverything ? p.unlit : whyNoShadow(scene, p.box, view);
        present.push_back(std::move(p));
    }
    leaveToLater(present, request);
    return present;
}

std::string Museum::whyNoWorks(const Prepared& prepared, const FrameRequest& request, const hall::HallScene& scene,
                               const render::View& view, const std::vector<Present>& present)
{
    if (scene.alone) return "there is no hall";
    // While the window is opening, it is enough to draw what is in view.
    if (isOpening(request)) return othersFirst;
    const bool mirrored = std::any_of(present.begin(), present.end(), [&](const Present& p) {
        const auto* mirror = p.hidden.empty() ? capability<MirrorsSurroundings>(p.exhibit) : nullptr;
        return mirror && mirror->mirrors(prepared.sceneState.values[p.index]) && isLargeMirror(p.box, view);
    });
    const bool own = std::any_of(scene.objects.begin(), scene.objects.end(), [&](const hall::OwnObject& object) {
        return hall::isMirror(object) && view.mayContain(object.box) && isLargeMirror(object.box, view);
    });
    return mirrored || own ? std::string() : noMirror;
}

Prepared Museum::prepare(const SceneState& sceneState, const FrameRequest& request) const
{
    Prepared made{atMoment(sceneState, request),
                  request.time,
                  request.sincePressed,
                  {},
                  std::vector<PreparedExhibit>(subjects_.size()),
                  {}};
    if (isOpening(request)) made.sceneState.hall() = hall_->whileOpening(made.sceneState.hall());
    if (!request.alone) startReading();
    render::AssetStore assets = request.nonBlocking ? assets_->nonBlocking() : *assets_;
    const auto complainOf = [&](const PreparedPart* part) {
        if (request.needsFiles && part && !part->unreadable.empty())
            throw Failure(ErrorKind::file, part->unreadable.front().why);
    };
    made.hall = hall_->prepare(made.sceneState.hall(), assets);
    complainOf(made.hall.get());
    const hall::HallScene scene = sceneOf(made, request.alone.has_value());
    const render::View view = wholeView(request);
    const std::vector<Present> present = presentIn(made, request, scene, view);
    // Exhibits that cast a lamp's shadow are drawn from the lamp, whether they are in view or not.
    const auto mark = [&](const std::vector<Present>& all, bool alone) {
        const bool seenByLamps = throwShadows(lampsOf(made, all, alone));
        for (const Present& p : all) {
            made.exhibits[p.index].seen |= p.hidden.empty() || seenByLamps;
            made.exhibits[p.index].shadowSeen |= p.noShadow.empty();
        }
    };
    mark(present, scene.alone);
    mark(presentIn(made, request, scene, widened(view)), scene.alone);
    if (whyNoWorks(made, request, scene, view, present).empty())
        for (const auto& [i, exhibit] : exhibits_)
            if (isInHall(i) && isBehindOpening(boundsOf(made, exhibit, i))) made.exhibits[i].seen = true;
    const std::vector<std::vector<Present>> pictures = Present::ofPictures(*this, made, request, present);
    for (const std::vector<Present>& shown : pictures) mark(shown, false);
    for (const auto& [i, exhibit] : exhibits_) {
        PreparedExhibit& part = made.exhibits[i];
        if (!part.seen && !part.shadowSeen) continue;
        part.part = exhibit.prepare({made.sceneState.values[i], made.time, made.sincePress(i), part.seen,
                                     part.shadowSeen, request.idle, assets});
        complainOf(part.part.get());
    }
    if (!scene.alone || !pictures.empty()) model_->surfaces().read();
    made.pending = assets.pending();
    return made;
}

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
    if (reasons.contains(othersFirst)) return othersFirst;
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
                            .prepared = state.prepared});
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
    if (light.localLights) light.brightest += mostRadianceBy(*light.localLights);
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
