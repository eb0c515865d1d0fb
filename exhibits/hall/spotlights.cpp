#include "exhibits/hall/spotlights.h"

#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/hall/sun.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace vitrine::hall {
namespace {

/// Color temperature of spotlights, kelvin: halogen.
constexpr double spotTemperature = 3400;
/// Irradiance on what a spotlight of strength 1 points at, in the hall's units.
constexpr double irradianceOfSpot = 0.55;
/// Strength of picture lights while the sun is high, when eyes are adapted to a brighter hall.
constexpr double pictureLightByDay = 1.7;

/// Returns a spotlight whose irradiance on its target is 1, ignoring its range: `reach` times the target's distance.
render::LocalLight spotAt(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec2& coneDegrees,
                          double reach)
{
    const glm::dvec3 away = target - position;
    render::LocalLight light;
    light.position = position;
    light.intensity = glm::dvec3(glm::dot(away, away));
    light.axis = glm::normalize(away);
    light.coneInner = glm::radians(coneDegrees.x);
    light.coneOuter = glm::radians(coneDegrees.y);
    light.range = reach * glm::length(away);
    light.nearest = 0.5 * glm::length(away);
    return light;
}

/// Returns the light of a place whose irradiance on its target is 1.
render::LocalLight spotOf(const Place& place, const HallModel& model)
{
    const glm::dvec3 origin(place.worldFromPlace[3]);
    const auto world = [&](const glm::dvec3& p) { return glm::dvec3(place.worldFromPlace * glm::dvec4(p, 1)); };
    // Frames in walls face along z: a picture light hangs in front of them and reaches the plaque.
    if (isInWall(place, model.room())) return spotAt(world({0, 2.1, 1.5}), world({0, -0.2, 0}), {20, 50}, 1.8);
    // The other spotlights hang in the vault, on the entrance's side of their exhibit.
    const glm::dvec3 target(origin.x, 0.4 * std::max(origin.y, 0.0), origin.z);
    return spotAt({0.7 * origin.x, 6.6, origin.z + 1.6}, target, {11, 27}, 2.5);
}

}  // namespace

bool isInWall(const Place& place, const render::Box& room)
{
    constexpr double tolerance = 0.2;  // Meters: a frame stands out of its wall, or lies in a niche.
    const glm::dvec3 origin(place.worldFromPlace[3]), outOfWall(place.worldFromPlace[2]);
    for (const int axis : {0, 2}) {
        const double wall = outOfWall[axis] > 0 ? room.low[axis] : room.high[axis];
        if (std::abs(outOfWall[axis]) > 0.9 && std::abs(origin[axis] - wall) < tolerance) return true;
    }
    return false;
}

std::vector<render::LocalLight> spotlights(const HallModel& model, const std::vector<ExhibitSlot>& slots,
                                           const HallTable& table, const ParameterValues& values)
{
    const VaultLamps lamps = vaultLampsOf(table, values);
    const double strength = irradianceOfSpot * values[table.spotStrength];
    if (!(strength > 0) || values[table.lamps] == LampsLit::off) return {};
    // Picture lights shine all day, as in any gallery, but not on a work that lights its surroundings itself: it would
    // pale beside its frame. The other spotlights shine with the lamps.
    const double pictures = glm::mix(pictureLightByDay, 1.0, lamps.share);
    std::vector<render::LocalLight> lights;
    for (const ExhibitSlot& slot : slots) {
        const Place* place = model.place(slot.place);
        if (!place) continue;
        const double share = isInWall(*place, model.room()) && !slot.shines ? pictures : lamps.share;
        if (!(share > 0)) continue;
        render::LocalLight light = spotOf(*place, model);
        light.intensity *= blackBodyColor(spotTemperature) * (strength * share);
        lights.push_back(light);
    }
    return lights;
}

}  // namespace vitrine::hall
