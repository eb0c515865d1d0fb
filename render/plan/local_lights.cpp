#include "render/plan/local_lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vitrine::render {
namespace {

/// Luminance of the irradiance at `center`, ignoring the light's range and cone.
double strengthAt(const LocalLight& light, const glm::dvec3& center)
{
    const double distance = std::max({glm::distance(light.position, center), light.radius, 1e-3});
    return glm::dot(light.intensity, glm::dvec3(0.2126, 0.7152, 0.0722)) / (distance * distance);
}

bool reaches(const LocalLight& light, const glm::dvec3& center, double radius)
{
    const double distance = glm::distance(light.position, center);
    return std::isfinite(distance) && strengthAt(light, center) > 0 &&
           (light.range <= 0 || distance - radius < light.range);
}

}  // namespace

LocalLighting localLighting(std::span<const LocalLight> lights, const glm::dvec3& center, double radius)
{
    LocalLighting result;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (reaches(lights[i], center, radius)) result.chosen.push_back(i);
    std::stable_sort(result.chosen.begin(), result.chosen.end(), [&](std::size_t a, std::size_t b) {
        return strengthAt(lights[a], center) > strengthAt(lights[b], center);
    });
    if (result.chosen.size() > mostLocalLights) result.chosen.resize(mostLocalLights);
    result.block.count = static_cast<int>(result.chosen.size());
    for (std::size_t i = 0; i < result.chosen.size(); ++i) {
        const LocalLight& light = lights[result.chosen[i]];
        LocalLightEntry& entry = result.block.lights[i];
        entry.position = glm::vec3(light.position);
        entry.radius = static_cast<float>(std::max(light.radius, 0.0));
        entry.intensity = glm::vec3(light.intensity);
        entry.range = static_cast<float>(light.range);
        entry.nearest = static_cast<float>(std::max(light.nearest, 0.0));
        if (light.axis != glm::dvec3(0)) {
            entry.axis = glm::vec3(light.axis);
            entry.coneCosine = static_cast<float>(std::cos(light.coneInner));
            entry.coneScale =
                static_cast<float>(1 / std::max(std::cos(light.coneInner) - std::cos(light.coneOuter), 1e-6));
        }
        if (!light.castsShadow || result.shadowed.size() >= mostLocalShadows) continue;
        entry.castsShadow = true;
        entry.firstLayer = static_cast<int>(6 * result.shadowed.size());
        entry.nearPlane = static_cast<float>(localShadowNear);
        result.shadowed.push_back(result.chosen[i]);
    }
    return result;
}

}  // namespace vitrine::render
