// The visitor's hand: what is under the pointer, and which button he looks at.
#include "exhibits/museum/museum.h"

#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

constexpr double reachOfButton = 2.0;  ///< Meters at which a button can be pressed .
constexpr double radiusOfAim = 0.09;   ///< Meters around a button that still count as looking at it.
constexpr double radiusOfPress =
    0.05;  ///< Meters around a button's middle that count as clicking it: it is 0.035 wide.
constexpr double never = std::numeric_limits<double>::infinity();

std::string buttonLine(const HasButton& button)
{
    return "E – " + std::string(button.buttonText());
}

/// The visitor's own object from the front, all of it in the picture.
render::Camera viewOf(const render::Box& worldBox)
{
    const double radius = std::max(glm::length(worldBox.halfSize()), 0.05);
    const double fovY = 0.7;
    const glm::dvec3 away = glm::normalize(glm::dvec3(0.35, 0.35, 1));
    return {worldBox.center() + away * (1.15 * radius / std::sin(fovY / 2)), worldBox.center(), fovY};
}

}  // namespace

/// The nearest thing along a ray.
struct Museum::Seen {
    enum class What : std::uint8_t { nothing, building, guest, button, visitorsObject };
    What what = What::nothing;
    std::size_t exhibit = 0;
    double distance = never;  ///< As the ray counts.
    render::Box visitorsBox;  ///< Of the visitor's object, world space; empty where there is none.

    void take(What w, std::size_t i, double d)
    {
        if (!(d < distance)) return;
        what = w;
        exhibit = i;
        distance = d;
    }
};

Museum::Seen Museum::firstSeen(const Prepared& prepared, const render::Ray& ray) const
{
    using enum Seen::What;
    Seen seen;
    const HallScene scene = sceneOf(prepared, false);
    for (const render::MeshInstance& part : model_->walls())
        seen.take(building, hallIndex, render::firstHit(ray, part, render::Faces::front));
    if (scene.visitorModel) {
        seen.visitorsBox = scene.visitorModel->bounds.transformed(scene.worldFromVisitorModel);
        const render::Ray local = ray.transformed(glm::inverse(scene.worldFromVisitorModel));
        for (const render::MeshInstance& part : scene.visitorModel->parts)
            seen.take(visitorsObject, hallIndex, render::firstHit(local, part, render::Faces::both));
    }
    for (const auto& [number, place] : model_->places()) {
        const auto here = std::find_if(exhibits_.begin(), exhibits_.end(),
                                       [&, n = number](const MuseumExhibit& e) { return e.exhibit.place() == n; });
        const bool empty = here == exhibits_.end();
        const std::size_t i = empty ? hallIndex : here->index;
        for (const render::MeshInstance& part : partsAt(scene, place))
            seen.take(empty ? building : guest, i, render::firstHit(ray, part, render::Faces::both));
        if (empty) continue;
        const render::Ray own = ray.transformed(glm::inverse(worldFromExhibit(i)));
        seen.take(guest, i, here->exhibit.firstHit(prepared.state(i), own));
        if (!place.worldFromButton || !capability<HasButton>(here->exhibit)) continue;
        seen.take(button, i, render::firstHit(ray, glm::dvec3((*place.worldFromButton)[3]), radiusOfPress));
    }
    return seen;
}

std::optional<Pointed> Museum::pick(const Prepared& prepared, const FrameRequest& request, glm::dvec2 ndc) const
{
    using enum Seen::What;
    const render::View view = render::makeView(request.camera, request.raster);
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    const Seen seen = firstSeen(prepared, ray);
    if (seen.what == nothing || seen.what == building) return std::nullopt;
    Pointed found{seen.exhibit,
                  {},
                  seen.distance,
                  seen.what == button,
                  seen.what == button && seen.distance <= reachOfButton,
                  {}};
    if (seen.what == visitorsObject) {
        found.name = "Your object";
        found.view = viewOf(seen.visitorsBox);
        return found;
    }
    const Exhibit& shown = exhibit(seen.exhibit);
    found.name = found.inReach ? buttonLine(*capability<HasButton>(shown)) : std::string(shown.title());
    found.view = bestView(seen.exhibit, prepared.sceneState.values[seen.exhibit]);
    return found;
}

double Museum::distanceTo(const Prepared& prepared, const FrameRequest& request, glm::dvec2 ndc) const
{
    const render::View view = render::makeView(request.camera, request.raster);
    return firstSeen(prepared, {view.eye, glm::normalize(view.direction(ndc))}).distance;
}

std::optional<LookedAt> Museum::lookedAt(const Prepared& prepared) const
{
    const SceneState& sceneState = prepared.sceneState;
    const glm::dvec3 toTarget = sceneState.camera.target - sceneState.camera.eye;
    if (!(glm::length(toTarget) > 1e-9)) return std::nullopt;
    const glm::dvec3 forward = glm::normalize(toTarget);
    for (const auto& [i, shown] : exhibits_) {
        const auto* button = capability<HasButton>(shown);
        const Place* place = button ? model_->place(shown.place()) : nullptr;
        if (!place || !place->worldFromButton) continue;
        const glm::dvec3 toButton = glm::dvec3((*place->worldFromButton)[3]) - sceneState.camera.eye;
        const double along = glm::dot(toButton, forward);
        if (along <= 0 || along > reachOfButton || glm::length(toButton - forward * along) > radiusOfAim) continue;
        // Straight to the button, which the look itself may miss by a little.
        const Seen seen = firstSeen(prepared, {sceneState.camera.eye, toButton});
        if (seen.what != Seen::What::button || seen.exhibit != i) continue;
        return LookedAt{i, buttonLine(*button)};
    }
    return std::nullopt;
}

}  // namespace vitrine
