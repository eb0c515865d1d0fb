#include "exhibits/museum/surroundings.h"

#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace vitrine {

MuseumSurroundings::MuseumSurroundings(const hall::HallModel& model, const hall::Hall& hall,
                                       std::span<const MuseumExhibit> exhibits, render::AssetStore& assets,
                                       std::function<hall::HallScene(const Prepared&)> sceneOf)
    : model_(model), hall_(hall), exhibits_(exhibits), assets_(assets), sceneOf_(std::move(sceneOf)),
      building_(model.colliders())
{
}

glm::dmat4 MuseumSurroundings::worldFrom(const Exhibit& exhibit) const
{
    const hall::Place* place = model_.place(exhibit.place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

glm::dvec3 MuseumSurroundings::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return building_.walk(from, to);
}

glm::dvec3 MuseumSurroundings::walk(const Prepared& prepared, const glm::dvec3& from, const glm::dvec3& to) const
{
    return obstacles(prepared).walk(from, to);
}

Obstacles MuseumSurroundings::obstaclesWith(const ParameterValues& hall, const hall::PreparedHall* prepared) const
{
    std::vector<hall::Collider> all;
    for (const hall::OwnObject& object : hall_.scene(hall, false, prepared).objects)
        all.insert(all.end(), object.colliders.begin(), object.colliders.end());
    if (all.empty()) return building_;
    all.insert(all.end(), model_.colliders().begin(), model_.colliders().end());
    return Obstacles(std::move(all));
}

Obstacles MuseumSurroundings::obstacles(const Prepared& prepared) const
{
    return obstaclesWith(prepared.sceneState.hall(), prepared.hall.get());
}

Obstacles MuseumSurroundings::obstacles(const SceneState& sceneState) const
{
    return obstaclesWith(sceneState.hall(), hall_.prepare(sceneState.hall(), assets_).get());
}

namespace {

constexpr double reachOfButton = 2.0;  ///< Meters at which a button can be pressed.
constexpr double radiusOfAim = 0.09;   ///< Meters around a button that still count as looking at it.
constexpr double radiusOfPress =
    0.05;  ///< Meters around the center of a button that count as a click on it; its own radius is 0.035.
constexpr double never = std::numeric_limits<double>::infinity();

std::string buttonLine(const HasButton& button)
{
    return "E – " + std::string(button.buttonText());
}

/// Returns the shown name of a visitor's object: "Your object: teddy.glb".
std::string nameOf(const hall::OwnObject& object, const hall::HallScene& scene)
{
    const std::string path = scene.values[scene.table.objects[object.which].model];
    return "Your object: " + std::filesystem::path(path).filename().string();
}

/// Returns a camera that shows the whole object of a visitor: an object on the free plinth from the place where its
/// plaque is read, any other from the middle of the hall, where no wall is in the way.
render::Camera viewOf(const hall::OwnObject& object, const hall::HallScene& scene)
{
    const double radius = std::max(glm::length(object.box.halfSize()), 0.05);
    const double fovY = 0.7;
    const glm::dvec3 middle = object.box.center();
    const bool onFreePlinth =
        scene.values[scene.table.objects[object.which].modelStand] == hall::ObjectStand::freePlinth;
    const glm::dvec2 inwards = std::abs(middle.x) < 1 ? glm::dvec2(0, 1) : glm::dvec2(-middle.x, -0.5 * middle.z);
    const glm::dvec2 level = onFreePlinth ? glm::dvec2(0.35, 1) : 1.06 * glm::normalize(inwards);
    const glm::dvec3 away = glm::normalize(glm::dvec3(level.x, 0.35, level.y));
    return {middle + away * (1.15 * radius / std::sin(fovY / 2)), middle, fovY};
}

}  // namespace

/// Nearest hit along a ray.
struct MuseumSurroundings::Seen {
    enum class What : std::uint8_t { nothing, building, guest, button, visitorsObject };
    What what = What::nothing;
    std::size_t exhibit = 0;
    double distance = never;  ///< Distance in lengths of the ray's direction.
    std::size_t own = 0;      ///< Index of the visitor's object, among those that are in the hall.

    void take(What w, std::size_t i, double d)
    {
        if (!(d < distance)) return;
        what = w;
        exhibit = i;
        distance = d;
    }
};

MuseumSurroundings::Seen MuseumSurroundings::firstSeen(const Prepared& prepared, const hall::HallScene& scene,
                                                       const render::Ray& ray) const
{
    using enum Seen::What;
    Seen seen;
    for (const render::MeshInstance& part : model_.walls())
        seen.take(building, hallIndex, render::firstHit(ray, part, render::Faces::front));
    for (std::size_t own = 0; own < scene.objects.size(); ++own) {
        const hall::OwnObject& object = scene.objects[own];
        const render::Ray local = ray.transformed(glm::inverse(object.worldFromModel));
        for (const render::MeshInstance& part : object.model->parts) {
            const double before = seen.distance;
            seen.take(visitorsObject, hallIndex, render::firstHit(local, part, render::Faces::both));
            if (seen.distance < before) seen.own = own;
        }
        if (object.plinth) seen.take(building, hallIndex, render::firstHit(ray, *object.plinth, render::Faces::front));
    }
    for (const auto& [number, place] : model_.places()) {
        const auto here = std::find_if(exhibits_.begin(), exhibits_.end(),
                                       [&, n = number](const MuseumExhibit& e) { return e.exhibit.place() == n; });
        const bool empty = here == exhibits_.end();
        const std::size_t i = empty ? hallIndex : here->index;
        for (const render::MeshInstance& part : hall::partsAt(scene, place))
            seen.take(empty ? building : guest, i, render::firstHit(ray, part, render::Faces::both));
        if (empty) continue;
        const render::Ray own = ray.transformed(glm::inverse(worldFrom(here->exhibit)));
        seen.take(guest, i, here->exhibit.firstHit(prepared.state(i), own));
        if (!place.worldFromButton || !capability<HasButton>(here->exhibit)) continue;
        seen.take(button, i, render::firstHit(ray, glm::dvec3((*place.worldFromButton)[3]), radiusOfPress));
    }
    return seen;
}

std::optional<Pointed> MuseumSurroundings::pick(const Prepared& prepared, const FrameRequest& request,
                                                glm::dvec2 ndc) const
{
    using enum Seen::What;
    const render::View view = render::makeView(request.camera, request.raster);
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    const hall::HallScene scene = sceneOf_(prepared);
    const Seen seen = firstSeen(prepared, scene, ray);
    if (seen.what == nothing || seen.what == building) return std::nullopt;
    Pointed found{seen.exhibit,
                  {},
                  seen.distance,
                  seen.what == button,
                  seen.what == button && seen.distance <= reachOfButton,
                  {}};
    if (seen.what == visitorsObject) {
        const hall::OwnObject& object = scene.objects[seen.own];
        found.name = nameOf(object, scene);
        found.view = viewOf(object, scene);
        return found;
    }
    const Exhibit& shown = exhibits_[seen.exhibit - hallIndex - 1].exhibit;
    const ParameterValues& values = prepared.sceneState.values[seen.exhibit];
    found.name = shown.title();
    if (found.inReach) {
        const auto& button = *capability<HasButton>(shown);
        const Message whyDisabled = button.whyDisabled(values);
        found.name = whyDisabled.empty() ? buttonLine(button) : whyDisabled.english();
    }
    found.view = shown.bestView(values).transformed(worldFrom(shown));
    return found;
}

std::vector<OwnObjectShown> MuseumSurroundings::ownObjects(const Prepared& prepared) const
{
    const hall::HallScene scene = sceneOf_(prepared);
    std::vector<OwnObjectShown> all;
    for (const hall::OwnObject& object : scene.objects)
        all.push_back({object.which, nameOf(object, scene), object.box, viewOf(object, scene)});
    return all;
}

double MuseumSurroundings::distanceTo(const Prepared& prepared, const FrameRequest& request, glm::dvec2 ndc) const
{
    const render::View view = render::makeView(request.camera, request.raster);
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    return firstSeen(prepared, sceneOf_(prepared), ray).distance;
}

std::optional<LookedAt> MuseumSurroundings::lookedAt(const Prepared& prepared) const
{
    const SceneState& sceneState = prepared.sceneState;
    const glm::dvec3 toTarget = sceneState.camera.target - sceneState.camera.eye;
    if (!(glm::length(toTarget) > 1e-9)) return std::nullopt;
    const glm::dvec3 forward = glm::normalize(toTarget);
    for (const auto& [i, shown] : exhibits_) {
        const auto* button = capability<HasButton>(shown);
        const hall::Place* place = button ? model_.place(shown.place()) : nullptr;
        if (!place || !place->worldFromButton) continue;
        const glm::dvec3 toButton = glm::dvec3((*place->worldFromButton)[3]) - sceneState.camera.eye;
        const double along = glm::dot(toButton, forward);
        if (along <= 0 || along > reachOfButton || glm::length(toButton - forward * along) > radiusOfAim) continue;
        // A ray straight to the button, because the viewing direction may miss it by a little.
        const Seen seen = firstSeen(prepared, sceneOf_(prepared), {sceneState.camera.eye, toButton});
        if (seen.what != Seen::What::button || seen.exhibit != i) continue;
        return LookedAt{i, buttonLine(*button), button->whyDisabled(sceneState.values[i])};
    }
    return std::nullopt;
}

}  // namespace vitrine
