#include "exhibits/framework/scene/scene_lighting.h"

#include "render/scene/ray.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace vitrine {
namespace {

/// Accounts for rounding in shaders, meters.
constexpr double slack = 0.01;

}  // namespace

render::ContributionBound SceneLighting::sunlightIn(const render::Box& world) const
{
    if (!hallCastsShadow || sunShadow.isZero()) return sunShadow;
    const render::Box around{world.low - slack, world.high + slack};
    const render::Box roomBox{light.roomLow, light.roomHigh};
    // The places from which the sun is seen through the room are convex.
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 high((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
        // The same test as `isBehindRoom` of shaders/lib/light.glsl.
        const render::RayInterval inRoom =
            render::insideBox({glm::mix(around.low, around.high, high), towardsSun}, roomBox);
        if (!(inRoom.exit > inRoom.enter + slack)) return sunShadow;
    }
    const render::Box seen = around.transformed(glm::dmat4(light.hallShadowFromWorld));
    for (const glm::vec4& passage : light.sunPassages)
        if (seen.high.x > passage.x && seen.high.y > passage.y && seen.low.x < passage.z && seen.low.y < passage.w)
            return sunShadow;
    return {0, 0, "the sun does not reach it through window or oculus"};
}

void SceneLighting::mirrorWorks(render::Pass& pass) const
{
    if (!hasMirroredWorks) return;
    for (render::SampledTexture& input : pass.inputs)
        if (input.unit == UNIT_PROBE) input.source = std::string(mirroredWorksImage);
}

void SceneLighting::bindLight(render::Pass& pass) const
{
    pass.blocks[BLOCK_LIGHT] = render::std140Bytes(light);
    pass.inputs.insert(pass.inputs.end(), inputs.begin(), inputs.end());
    pass.shader.defines.push_back("SHADOW_FILTER " + std::to_string(shadowFilter));
    pass.shader.defines.push_back("BACKGROUND " + std::to_string(background));
    if (glassCastsShadow) pass.shader.defines.emplace_back("GLASS_SHADOWS");
}

void SceneLighting::bindLighting(render::Pass& pass) const
{
    bindLight(pass);
    if (!localLights) return;
    pass.localLights = std::make_shared<render::LocalLightsBlock>(localLights->block);
    pass.shaded.within = building;
    pass.shader.defines.emplace_back("LOCAL_LIGHTS");
    if (localLights->shadowed.empty()) return;
    pass.shader.defines.emplace_back("LOCAL_SHADOWS");
    pass.inputs.push_back({UNIT_LOCAL_SHADOWS, std::string(localShadowImage)});
}

double mostRadianceBy(const render::LocalLighting& lighting)
{
    double most = 0;
    for (std::size_t i = 0; i < lighting.chosen.size(); ++i) {
        const render::LocalLightEntry& light = lighting.block.lights[i];
        const double nearest =
            std::max({static_cast<double>(light.radius), static_cast<double>(light.nearest), render::localShadowNear});
        const auto intensity = static_cast<double>(std::max({light.intensity.x, light.intensity.y, light.intensity.z}));
        most += mostReflected * intensity / (nearest * nearest);
    }
    return most;
}

int flatAxis(const render::Box& opening)
{
    const glm::dvec3 size = opening.halfSize();
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (size[i] < size[axis]) axis = i;
    return axis;
}

glm::mat4 shadowFromWorld(const render::View& view)
{
    const glm::dmat4 textureFromClip =
        glm::translate(glm::dmat4(1), glm::dvec3(0.5, 0.5, 0)) * glm::scale(glm::dmat4(1), glm::dvec3(0.5, 0.5, 1));
    return glm::mat4(textureFromClip * view.clipFromWorld);
}

render::View lightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size, double reach)
{
    render::View view;
    const glm::dvec3 up = std::abs(towardsLight.y) > 0.99 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 center = box.center();
    view.viewFromWorld = glm::lookAt(center, center - towardsLight, up);
    view.eye = center + towardsLight * 1e3;
    const render::Box inLight = box.transformed(view.viewFromWorld);
    // A margin, so that filtering at the border still reads the clear value.
    const glm::dvec2 extent = glm::dvec2(inLight.high - inLight.low);
    const glm::dvec2 margin = 4.0 * extent / glm::dvec2(size) + 1e-4;
    view.clipFromView =
        render::reversedOrthographic(glm::dvec2(inLight.low) - margin, glm::dvec2(inLight.high) + margin,
                                     inLight.high.z + 0.05, inLight.low.z - reach);
    view.clipFromWorld = view.clipFromView * view.viewFromWorld;
    view.tanHalfFov = glm::dvec2(1e-3);
    view.raster.size = size;
    return view;
}

render::View steadyLightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size, double reach)
{
    render::View view;
    const glm::dvec3 up = std::abs(towardsLight.y) > 0.99 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    // The view is placed at the origin, so that the grid of texels does not move with the box.
    view.viewFromWorld = glm::lookAt(glm::dvec3(0), -towardsLight, up);
    view.eye = box.center() + towardsLight * 1e3;
    const render::Box inLight = box.transformed(view.viewFromWorld);
    const glm::dvec2 extent = glm::dvec2(inLight.high - inLight.low);
    // Four texels of margin, so that filtering at the border still reads the clear value, and one for the grid.
    const glm::dvec2 least = extent / glm::max(glm::dvec2(size) - 9.0, glm::dvec2(1));
    const double texel = 1e-3 * std::exp2(std::ceil(4 * std::log2(std::max({least.x, least.y, 1e-6}) / 1e-3)) / 4);
    const glm::dvec2 low = (glm::floor(glm::dvec2(inLight.low) / texel) - 4.0) * texel;
    view.clipFromView =
        render::reversedOrthographic(low, low + texel * glm::dvec2(size), inLight.high.z + 0.05, inLight.low.z - reach);
    view.clipFromWorld = view.clipFromView * view.viewFromWorld;
    view.tanHalfFov = glm::dvec2(1e-3);
    view.raster.size = size;
    return view;
}

glm::dvec3 blackBodyColor(double kelvin)
{
    const double t = std::clamp(kelvin, 1000.0, 25000.0);
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double x = t < 4000 ? -0.2661239e9 / t3 - 0.2343589e6 / t2 + 0.8776956e3 / t + 0.179910
                              : -3.0258469e9 / t3 + 2.1070379e6 / t2 + 0.2226347e3 / t + 0.240390;
    const double x2 = x * x;
    const double x3 = x2 * x;
    const double y = t < 2222   ? -1.1063814 * x3 - 1.34811020 * x2 + 2.18555832 * x - 0.20219683
                     : t < 4000 ? -0.9549476 * x3 - 1.37418593 * x2 + 2.09137015 * x - 0.16748867
                                : 3.0817580 * x3 - 5.87338670 * x2 + 3.75112997 * x - 0.37001483;
    const glm::dvec3 xyz(x / y, 1, (1 - x - y) / y);
    // CIE XYZ to linear Rec. 709 (IEC 61966-2-1).
    const glm::dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                         -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                         0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
    const glm::dvec3 positive = glm::max(rgb, glm::dvec3(0));
    return positive / std::max({positive.x, positive.y, positive.z});
}

}  // namespace vitrine
