// Finds the parts of a picture that change by themselves, and the times at which they do.
#include "exhibits/framework/time/animation.h"
#include "exhibits/hall/hall_scene.h"
#include "exhibits/museum/lamps.h"
#include "exhibits/museum/present.h"
#include "exhibits/museum/shown_pictures.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace vitrine {
namespace {

constexpr double neverChanges = std::numeric_limits<double>::infinity();

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

/// Returns whether the exhibit's lamps change while it moves.
bool changesLamps(const Exhibit& exhibit, const ExhibitState& state)
{
    const auto* carrier = capability<HasLocalLights>(exhibit);
    return carrier && carrier->lightsChange(state);
}

/// Returns whether the exhibit shows pictures of others now.
template <typename Present> bool showsPictures(const Present& p, const Prepared& prepared)
{
    const auto* shows = capability<ShowsPictures>(p.exhibit);
    return shows && !shows->shownPictures(prepared.sceneState.values[p.index]).empty();
}

/// Returns the seconds until the exhibit next changes, by itself or by an animated parameter.
double nextOf(const Exhibit& exhibit, const ExhibitState& state)
{
    return std::min(exhibit.nextChangeOf(state), nextMotion(state.values, state.time));
}

}  // namespace

render::Box withShadow(const render::Box& box, const glm::dvec3& towardsSun)
{
    render::Box swept = box;
    const double fall = towardsSun.y > 1e-3 ? std::min(std::max(box.high.y, 0.0) / towardsSun.y, 15.0) : 15.0;
    swept.include(box.low - towardsSun * fall);
    swept.include(box.high - towardsSun * fall);
    return swept;
}

render::View wholeView(const FrameRequest& request)
{
    render::Raster whole = request.raster;
    whole.offset = whole.tile = glm::ivec2(0);
    return render::makeView(request.camera, whole);
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

double Museum::Present::nextChange(const Museum& museum, const Prepared& prepared, const FrameRequest& request,
                                   bool isPicture)
{
    double next = neverChanges;
    for (const double since : prepared.sincePressed)
        if (since < hall::buttonTime) next = 0;
    const bool alone = request.alone.has_value();
    const hall::HallScene scene = museum.sceneOf(prepared, alone);
    // Hidden exhibits and hidden shadows may move without a new frame, unless lamps cast their shadows or hang in them.
    const std::vector<Present> present = museum.presentIn(prepared, request, scene, wholeView(request));
    const bool shadows = throwShadows(museum.lampsOf(prepared, present, alone));
    for (const Present& p : present) {
        if (!isPicture && p.hidden.empty()) next = std::min(next, nextOfPictures(museum, prepared, request, p));
        if (isPicture && showsPictures(p, prepared)) continue;  // It is dark there.
        // Light in the air is visible from everywhere.
        if (shadows || p.hidden.empty() || capability<OverFrame>(p.exhibit) || (!alone && p.noShadow.empty()) ||
            changesLamps(p.exhibit, prepared.state(p.index)))
            next = std::min(next, nextOf(p.exhibit, prepared.state(p.index)));
    }
    // The building surrounds the visitor, and its light is in every picture.
    return std::min(next, nextMotion(prepared.sceneState.hall(), prepared.time));
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
    if (glassSeen && low.x <= high.x) return std::nullopt;  // Glass may show anything that moves, or move itself.
    const glm::dvec2 size(request.raster.size);
    const glm::ivec2 first = glm::ivec2(glm::floor(glm::clamp(low - edge, glm::dvec2(0), size) / 2.0)) * 2;
    const glm::ivec2 end =
        glm::min(glm::ivec2(glm::ceil(glm::clamp(high + edge, glm::dvec2(0), size) / 2.0)) * 2, request.raster.size);
    if (end.x <= first.x || end.y <= first.y) return PictureRegion{};
    return PictureRegion{first, end - first};
}

}  // namespace vitrine
