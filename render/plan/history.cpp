#include "render/plan/history.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

std::string whyCameraLost(const History& history, const View& now, const View& last)
{
    if (now.raster.size != last.raster.size) return "the size of the picture changed";
    if (!history.image.hasOwnPixels() &&
        (now.raster.offset != last.raster.offset || now.raster.drawn() != last.raster.drawn()))
        return "another tile is drawn";
    if (!(glm::distance(now.eye, last.eye) <= history.cutMeters)) return "the camera jumped";
    const glm::dvec3 forward = now.direction(-now.tanShift / now.tanHalfFov);
    const glm::dvec3 lastForward = last.direction(-last.tanShift / last.tanHalfFov);
    const double turned = std::atan2(glm::length(glm::cross(forward, lastForward)), glm::dot(forward, lastForward));
    if (!(turned <= history.cutRadians)) return "the camera turned too far";
    if (now.tanHalfFov != last.tanHalfFov || now.tanShift != last.tanShift) return "the field of view changed";
    return {};
}

std::string whyLost(const History& history, const View& now, double time, bool resetHistory, const HistoryRecord* last)
{
    if (!last) return "nothing was drawn before";
    if (resetHistory) return "the frame does not continue the last one";
    if (!sameStorage(history.image, last->image)) return "the image has another form";
    if (std::string why = whyCameraLost(history, now, last->view); !why.empty()) return why;
    const bool clockRuns = time >= last->time && time - last->time <= history.cutSeconds;
    if (!clockRuns && std::isfinite(history.cutSeconds)) return "the clock jumped";
    for (const HistoryDependency& dependency : history.dependencies) {
        const bool same =
            std::any_of(last->dependencies.begin(), last->dependencies.end(), [&](const HistoryDependency& d) {
                return d.whyLost == dependency.whyLost && d.hash == dependency.hash;
            });
        if (!same) return dependency.whyLost;
    }
    return {};
}

}  // namespace

std::string previous(const std::string& image)
{
    return image + "@previous";
}

HistoryState historyState(const History& history, const View& now, double time, bool resetHistory,
                          const HistoryRecord* last)
{
    HistoryState state{history, false, whyLost(history, now, time, resetHistory, last), now};
    state.valid = state.reset.empty();
    if (state.valid) state.lastView = last->view;
    if (history.image.hasOwnPixels()) state.lastView = viewOfOwnPixels(state.lastView, history.image);
    return state;
}

}  // namespace vitrine::render
