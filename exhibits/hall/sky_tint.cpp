#include "exhibits/hall/sky_tint.h"

#include "exhibits/kit/clear_sky.h"

#include <numbers>

namespace vitrine::hall {
namespace {

/// Returns the ratio of two sky colors at half the saturation, since the hall's own sky is paler than clear air.
glm::dvec3 tintOf(const glm::dvec3& color, const glm::dvec3& reference)
{
    const glm::dvec3 factor = color / reference;
    const double bright = glm::dot(factor, glm::dvec3(0.2126, 0.7152, 0.0722));
    return glm::sqrt(factor * bright);
}

}  // namespace

SkyTint skyTint(double sunElevation)
{
    // The view is well beside the sun, so its glow does not count as sky. lib/sky.glsl adds the glow.
    constexpr double low = 0.06, beside = 0.6;
    const auto zenith = [](double sun) { return clearSkyRadiance(sun, std::numbers::pi / 2, 0); };
    const auto away = [](double sun) { return clearSkyRadiance(sun, low, std::numbers::pi - beside); };
    static const glm::dvec3 referenceZenith = zenith(referenceSunElevation);
    static const glm::dvec3 referenceHorizon = away(referenceSunElevation);
    const glm::dvec3 horizon = away(sunElevation);
    const glm::dvec3 more = glm::max(clearSkyRadiance(sunElevation, low, beside) - horizon, glm::dvec3(0));
    return {tintOf(zenith(sunElevation), referenceZenith), tintOf(horizon, referenceHorizon),
            more / glm::dot(referenceHorizon, glm::dvec3(0.2126, 0.7152, 0.0722))};
}

}  // namespace vitrine::hall
