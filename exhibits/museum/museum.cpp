#include "exhibits/museum/museum.h"

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/framework/time/animation.h"
#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/hall/walk.h"
#include "exhibits/museum/lamps.h"
#include "exhibits/museum/present.h"
#include "exhibits/museum/shown_pictures.h"
#include "render/failure.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

namespace vitrine {
namespace {

constexpr double neverChanges = std::numeric_limits<double>::infinity();

std::vector<hall::ExhibitSlot> slotsOf(const std::vector<std::unique_ptr<Exhibit>>& exhibits)
{
    std::vector<hall::ExhibitSlot> made;
    for (const auto& e : exhibits)
        made.push_back({e->place(), std::string(e->title()), std::string(e->summary()), std::string(e->tryThis()),
                        capability<HasButton>(*e) != nullptr, capability<HasLocalLights>(*e) != nullptr});
    return made;
}

/// Returns whether the picture is one of the first of a window.
bool isOpening(const FrameRequest& request)
{
    return request.mostExhibits < std::numeric_limits<int>::max();
}

/// Returns why no shadow is drawn; empty if the sun may reach the box and the shadow may be visible.
std::string whyNoShadow(const hall::HallScene& scene, const render::Box& box, const render::View& view)
{
    if (std::string why = hall::whyUnlit(scene, box); !why.empty()) return why;
    return view.mayContain(withShadow(box, hall::towardsSun(scene))) ? std::string()
                                                                     : "neither it nor its shadow is in view";
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

/// Returns the part of the picture that contains the box; nothing if some of the box may lie behind the eye.
std::optional<std::pair<glm::dvec2, glm::dvec2>> screenBox(const render::Box& box, const render::View& view)
{
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 world((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
        if (!(clip.w > view.nearPlane)) return std::nullopt;
        const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.raster.size);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    return std::pair(low, high);
}

bool movesHangings(const Exhibit& exhibit, const ParameterValues& values)
{
    const auto* turns = capability<TurnsHangings>(exhibit);
    return turns && turns->turnOfHangings(values, 0) != turns->turnOfHangings(values, 1);
}

}  // namespace

Museum::Museum(std::vector<std::unique_ptr<Exhibit>> exhibits)
    : model_(std::make_shared<const hall::HallModel>()), owned_(std::move(exhibits)),
      hall_(std::make_unique<const hall::Hall>(model_, slotsOf(owned_))), subjects_{hall_.get()},
      assets_(std::make_unique<render::AssetStore>())
{
    offerPictures(owned_);
    for (const auto& exhibit : owned_) {
        exhibits_.push_back({subjects_.size(), *exhibit});
        subjects_.push_back(exhibit.get());
    }
    surroundings_ = std::make_unique<const MuseumSurroundings>(
        *model_, *hall_, exhibits_, *assets_, [this](const Prepared& prepared) { return sceneOf(prepared, false); });
}

Museum::~Museum() = default;

void Museum::startReading() const
{
    model_->surfaces().startReading();
}

const SceneObject& Museum::hall() const
{
    return *hall_;
}

const Exhibit& Museum::exhibit(std::size_t i) const
{
    assert(i != hallIndex);
    return exhibits_[i - hallIndex - 1].exhibit;
}

std::optional<std::size_t> Museum::find(std::string_view name) const
{
    for (std::size_t i = 0; i < subjects_.size(); ++i)
        if (subjects_[i]->name() == name) return i;
    return std::nullopt;
}

SceneState Museum::initialSceneState() const
{
    SceneState sceneState;
    for (const SceneObject* each : subjects_) sceneState.values.push_back(each->parameters().initial());
    sceneState.camera = hall_->bestView(sceneState.hall());
    return sceneState;
}

PictureQuality pictureQuality(const ParameterValues& hall)
{
    PictureQuality quality;
    if (const auto row = hall.table().find(supersamplesParameter))
        quality.supersamples = static_cast<int>(std::get<double>(hall.row(*row)));
    if (const auto row = hall.table().find(resolutionScaleParameter))
        quality.resolutionScale = std::get<double>(hall.row(*row));
    const auto antialiasing = hall.table().find(temporalAntialiasingParameter);
    if (const auto row = hall.table().find(historyFramesParameter);
        row && antialiasing && std::get<double>(hall.row(*antialiasing)) != 0)
        quality.historyFrames = static_cast<int>(std::get<double>(hall.row(*row)));
    return quality;
}

bool Museum::isInHall(std::size_t i) const
{
    return i != hallIndex && model_->place(exhibit(i).place());
}

glm::dmat4 Museum::worldFromExhibit(std::size_t i) const
{
    const hall::Place* place = i == hallIndex ? nullptr : model_->place(exhibit(i).place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

render::Camera Museum::bestView(std::size_t i, const ParameterValues& values) const
{
    return subjects_[i]->bestView(values).transformed(worldFromExhibit(i));
}

std::vector<int> Museum::emptyPlaces() const
{
    std::vector<int> empty;
    for (const auto& [number, place] : model_->places())
        if (number != hall::freePlinthPlace &&
            std::none_of(owned_.begin(), owned_.end(), [&, n = number](const auto& e) { return e->place() == n; }))
            empty.push_back(number);
    return empty;
}

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
        if (later.hidden.empty()) later.hidden = Present::othersFirst;
        if (later.exhibit.castsShadow()) later.noShadow = Present::othersFirst;
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
    if (isOpening(request)) return Present::othersFirst;
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

AnimationTime Museum::animationTime(const SceneState& sceneState, std::size_t i, const FrameRequest& request) const
{
    render::Box box = subjects_[i]->bounds(sceneState.values[i]);
    if (i != hallIndex && !request.alone) box = box.transformed(worldFromExhibit(i));
    return {request.time, glm::distance(request.camera.eye, box.center())};
}

SceneState Museum::atMoment(const SceneState& sceneState, const FrameRequest& request) const
{
    SceneState now = sceneState;
    for (std::size_t i = 0; i < subjects_.size() && i < now.values.size(); ++i)
        if (!now.values[i].motions().empty())
            now.values[i] = valuesAt(now.values[i], animationTime(sceneState, i, request));
    return now;
}

/// Returns the exhibit's bounds at this time and, with animated parameters, also at both ends of their ranges, because
/// it may grow into view.
render::Box Museum::boundsOf(const Prepared& prepared, const Exhibit& exhibit, std::size_t i) const
{
    render::Box box = exhibit.boundsOf(prepared.state(i));
    const ParameterValues& values = prepared.sceneState.values[i];
    if (values.motions().empty()) return box;
    for (const int end : {0, 1}) {
        const ParameterValues there = valuesAtEnd(values, end);
        const render::Box then = exhibit.boundsOf({there, prepared.time, prepared.sincePress(i)});
        box.include(then.low);
        box.include(then.high);
    }
    return box;
}

double Museum::nextChange(const Prepared& prepared, const FrameRequest& request) const
{
    return Present::nextChange(*this, prepared, request, false);
}

std::optional<PictureRegion> Museum::movingRegion(const Prepared& prepared, const FrameRequest& request) const
{
    constexpr double shadowEdge = 0.15;  // Meters: width of a shadow's soft edge and of its filter.
    constexpr double edge = 2;           // Pixels: how far jitter and filters spread a moving object.
    for (const double since : prepared.sincePressed)
        if (since < hall::buttonTime) return std::nullopt;  // The button itself moves.
    if (nextMotion(prepared.sceneState.hall(), prepared.time) < neverChanges) return std::nullopt;
    const bool alone = request.alone.has_value();
    const render::View view = wholeView(request);
    const hall::HallScene scene = sceneOf(prepared, alone);
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    bool shadowMoves = false;
    bool lightInTheAir = false;
    bool glassSeen = false;
    const std::vector<Present> present = presentIn(prepared, request, scene, view);
    const bool shadows = throwShadows(lampsOf(prepared, present, alone));
    for (const Present& p : present) {
        const bool ofLight = capability<OverFrame>(p.exhibit) != nullptr;
        const bool seen = ofLight || p.hidden.empty();
        const bool shadowSeen = !alone && p.noShadow.empty();
        lightInTheAir = lightInTheAir || (ofLight && seen);
        const auto* glass = capability<CastsGlassShadow>(p.exhibit);
        glassSeen = glassSeen || (seen && glass && glass->castsGlassShadow(prepared.sceneState.values[p.index]));
        const bool seenAtAll = seen || shadowSeen || shadows;
        // An animated parameter may have any effect: make lamps, send light around, appear in the floor's reflection.
        if (seenAtAll && nextMotion(prepared.sceneState.values[p.index], prepared.time) < neverChanges)
            return std::nullopt;
        const double next = std::min(p.exhibit.nextChangeOf(prepared.state(p.index)),
                                     seen ? Present::nextOfPictures(*this, prepared, request, p) : neverChanges);
        if (!(next < neverChanges)) continue;
        // Light and shadows of lamps may fall anywhere.
        if (shadows || changesLamps(p.exhibit, prepared.state(p.index))) return std::nullopt;
        if (!seen && !shadowSeen) continue;
        if (ofLight || movesHangings(p.exhibit, prepared.sceneState.values[p.index])) return std::nullopt;
        render::Box reach = p.box;
        if (shadowSeen) {
            shadowMoves = true;
            reach = withShadow(p.box, hall::towardsSun(scene));
            reach.low -= shadowEdge;
            reach.high += shadowEdge;
        }
        const auto shown = screenBox(reach, view);
        if (!shown) return std::nullopt;
        low = glm::min(low, shown->first);
        high = glm::max(high, shown->second);
    }
    if (shadowMoves && lightInTheAir) return std::nullopt;
    // Glass may show anything that moves, or move itself; a floor that mirrors the picture may show it, too.
    const bool mirrored = !alone && scene.values[scene.table.floorMirror] == hall::FloorMirror::screen;
    if ((glassSeen || mirrored) && low.x <= high.x) return std::nullopt;
    const glm::dvec2 size(request.raster.size);
    const glm::ivec2 first = glm::ivec2(glm::floor(glm::clamp(low - edge, glm::dvec2(0), size) / 2.0)) * 2;
    const glm::ivec2 end =
        glm::min(glm::ivec2(glm::ceil(glm::clamp(high + edge, glm::dvec2(0), size) / 2.0)) * 2, request.raster.size);
    if (end.x <= first.x || end.y <= first.y) return PictureRegion{};
    return PictureRegion{first, end - first};
}

void noteDrawn(const Museum& museum, const render::FrameReport& report)
{
    for (const MuseumExhibit& each : museum.exhibits())
        if (const auto* continues = capability<ContinuesState>(each.exhibit)) continues->wasDrawn(report);
}

}  // namespace vitrine
