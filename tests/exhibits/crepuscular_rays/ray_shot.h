#pragma once

#include "tests/support/degree.h"
#include "tests/support/gallery.h"

#include <algorithm>
#include <cmath>

namespace vitrine::test {

class Rays : public GlTest {};

/// Direction to the sun in a RayShot.
inline const glm::dvec3
    shotTowardsSun(std::sin(sdf_morph::straightSunAzimuth) * std::cos(sdf_morph::straightSunElevation),
                   std::sin(sdf_morph::straightSunElevation),
                   -std::cos(sdf_morph::straightSunAzimuth) * std::cos(sdf_morph::straightSunElevation));

/// Shot of the window from the middle of the hall, in linear light. White rays of strength 1; the exposure does not
/// change them.
struct RayShot : Shot {
    explicit RayShot(crepuscular_rays::RayTechnique technique)
    {
        inHall();
        request.frame.subject.reset();
        request.frame.channels.normal = false;
        see({0.4, 1.65, -1}, {0.1, 3.8, -12});
        hall().set(hallTable().exposure, -std::log2(7.5));
        hall().set(hallTable().sunTemperature, 6500.0);
        letTheSunIn(hall());
        rays().set(raysTable().technique, technique);
        rays().set(raysTable().weight, 1.0);
        rays().set(raysTable().tint, ColorValue{glm::dvec3(1)});
        rays().set(raysTable().skyColor, false);
        rays().set(raysTable().lightSize, 3.141593);
        rays().set(raysTable().jitter, false);
        rays().set(raysTable().resolution, crepuscular_rays::RayResolution::full);
        rays().set(raysTable().view, crepuscular_rays::RayView::light);
        rays().set(raysTable().densityNoise, 0.0);
    }
    /// Shows the exhibit alone: only sky, a white mask, and the sun in the picture.
    RayShot& onWhite()
    {
        request.frame.alone = *gallery().museum.find("crepuscular_rays");
        request.frame.transparent = true;
        hall().set(hallTable().exposure, -std::log2(1.04));
        see({0, 0, 0}, {-0.05, 0.2, -1});
        return *this;
    }
    [[nodiscard]] ParameterValues& rays() { return sceneState.values[*gallery().museum.find("crepuscular_rays")]; }
    /// Returns the color of a white mask in the picture.
    [[nodiscard]] glm::dvec3 white() const
    {
        const glm::dvec3 color = blackBodyColor(sceneState.hall()[hallTable().sunTemperature]);
        return color / std::max({color.x, color.y, color.z});
    }
};

}  // namespace vitrine::test
