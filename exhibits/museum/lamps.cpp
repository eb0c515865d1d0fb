#include "exhibits/museum/lamps.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/exhibit.h"
#include "render/hash.h"
#include "render/plan/secondary_view.h"
#include "render/scene/cube_views.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <string>

namespace vitrine {
namespace {

constexpr int localShadowSize = 512;  ///< Texels per side of one face of a lamp's shadow map.
constexpr const char* lampReason = "a lamp throws its shadow";

void planLampFace(const Lamps& lamps, const render::LocalLight& light, int map, int face, render::FramePlan& plan)
{
    const render::View view = render::cubeFaceView(light.position, face, localShadowSize, render::localShadowNear);
    const std::string name = "lamps/shadow/" + std::to_string(map) + '/' + std::to_string(face);
    render::Pass layer;
    layer.name = name;
    layer.reason = lampReason;
    layer.phase = render::PassPhase::prepare;
    layer.view = view;
    layer.depth = render::Attachment::clearedSlice(localShadowImage, 6 * map + face);
    layer.contentHash = render::Hash().addValue(lamps.castersKey).addValue(view.clipFromWorld).value();
    const auto images = render::addSecondaryView(plan, lamps.planOfView(view),
                                                 {.name = name, .reason = lampReason, .view = view, .depthOnly = true});
    if (const auto depth = images.find(depthImage); depth != images.end()) {
        layer.shader = {.vertex = "lib/fullscreen.vert", .fragment = "hall/restore.frag"};
        layer.state.depthWrite = true;
        layer.inputs = {{UNIT_SOURCE, depth->second}};
        layer.draws = {render::Draw{}};
    }
    plan.add(std::move(layer));
}

}  // namespace

void takeLamps(const SceneObject& subject, const ExhibitState& state, const glm::dmat4& worldFromSubject,
               bool steadyOnly, std::vector<render::LocalLight>& lamps)
{
    const auto* carrier = capability<HasLocalLights>(subject);
    if (!carrier || (steadyOnly && carrier->lightsChange(state))) return;
    for (render::LocalLight lamp : carrier->localLights(state)) {
        lamp.position = glm::dvec3(worldFromSubject * glm::dvec4(lamp.position, 1));
        if (lamp.axis != glm::dvec3(0)) lamp.axis = glm::normalize(glm::dmat3(worldFromSubject) * lamp.axis);
        lamps.push_back(lamp);
    }
}

bool throwShadows(std::span<const render::LocalLight> lights)
{
    return std::any_of(lights.begin(), lights.end(), [](const render::LocalLight& light) { return light.castsShadow; });
}

std::optional<render::LocalLighting> planLamps(const Lamps& lamps, render::FramePlan& plan)
{
    render::LocalLighting lighting = render::localLighting(lamps.lights, lamps.center, lamps.radius);
    if (lighting.chosen.empty()) {
        plan.skip("lamps", lamps.lights.empty() ? "no lamp hangs here" : "no lamp shines here");
        return std::nullopt;
    }
    if (lighting.shadowed.empty()) {
        plan.skip("lamps/shadow", "no lamp throws shadows");
        return lighting;
    }
    const auto count = static_cast<int>(lighting.shadowed.size());
    plan.image({.name = localShadowImage,
                .format = render::Format::depth32f,
                .type = render::TextureType::array,
                .size = glm::ivec2(localShadowSize),
                .layers = 6 * count,
                .persistent = true,
                .comparison = true});
    for (int map = 0; map < count; ++map)
        for (int face = 0; face < 6; ++face)
            planLampFace(lamps, lamps.lights[lighting.shadowed[static_cast<std::size_t>(map)]], map, face, plan);
    return lighting;
}

}  // namespace vitrine
