#include "exhibits/museum/present.h"

#include "exhibits/framework/time/animation.h"
#include "exhibits/hall/hall_scene.h"
#include "exhibits/museum/lamps.h"
#include "exhibits/museum/shown_pictures.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vitrine {
namespace {

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

/// Calls `use` with the request of each picture that exhibit `by` shows within the picture of `request`.
template <typename Use>
void forEachPicture(const Museum& museum, const SceneState& sceneState, const FrameRequest& request, std::size_t by,
                    const Use& use)
{
    const auto* shows = capability<ShowsPictures>(museum.subject(by));
    if (!shows) return;
    for (const std::string& source : shows->shownPictures(sceneState.values[by]))
        if (const auto wanted = requestOfPicture(museum, sceneState, request, by, source)) use(*wanted);
}

}  // namespace

bool isBehindOpening(const render::Box& bounds)
{
    const glm::dvec3 size = bounds.high - bounds.low;
    return size.z == 0 && size.x > 0 && size.y > 0;
}

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

bool changesLamps(const Exhibit& exhibit, const ExhibitState& state)
{
    const auto* carrier = capability<HasLocalLights>(exhibit);
    return carrier && carrier->lightsChange(state);
}

double Museum::Present::nextChange(const Museum& museum, const Prepared& prepared, const FrameRequest& request,
                                   bool isPicture)
{
    double next = std::numeric_limits<double>::infinity();
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

std::vector<std::vector<Museum::Present>> Museum::Present::ofPictures(const Museum& museum, const Prepared& prepared,
                                                                      const FrameRequest& request,
                                                                      const std::vector<Present>& shown)
{
    std::vector<std::vector<Present>> all;
    const auto add = [&](const FrameRequest& wanted) {
        const hall::HallScene scene = museum.sceneOf(prepared, wanted.alone.has_value());
        all.push_back(museum.presentIn(prepared, wanted, scene, wholeView(wanted)));
    };
    for (const Present& by : shown)
        if (by.hidden.empty()) forEachPicture(museum, prepared.sceneState, request, by.index, add);
    return all;
}

double Museum::Present::nextOfPictures(const Museum& museum, const Prepared& prepared, const FrameRequest& request,
                                       const Present& by)
{
    double next = std::numeric_limits<double>::infinity();
    forEachPicture(museum, prepared.sceneState, request, by.index, [&](const FrameRequest& wanted) {
        next = std::min(next, nextChange(museum, prepared, wanted, true));
    });
    return next;
}

}  // namespace vitrine
