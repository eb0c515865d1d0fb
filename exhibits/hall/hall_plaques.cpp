#include "exhibits/hall/hall_scene.h"

#include "exhibits/hall/plaque_text.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine::hall {
namespace {

using render::Attachment;
using render::Draw;
using render::Pass;

/// Color of the letters, light on dark: linear, with opacity.
constexpr glm::vec4 enamel{0.80F, 0.76F, 0.66F, 0.97F};

/// Returns the material of the plates between their bronze edges. Bare bronze would reflect the room as bright as the
/// letters.
const render::Material& darkEnamel()
{
    static const render::Material dark = [] {
        render::Material m;
        m.baseColor = {0.016F, 0.015F, 0.014F, 1};
        m.metalness = 0;
        m.roughness = 0.55F;
        return m;
    }();
    return dark;
}

/// Plans the plates of the plaques in view, below their letters.
void planPlates(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    constexpr double edge = 0.012, height = 0.0002;  // Meters: width of the bare bronze edge, and height above it.
    Pass pass = surfacePass("hall/plates", "a plaque is in view", light, channels);
    for (const PlaqueText::Plaque& plaque : scene.text->plaques()) {
        const render::Box& plate = plaque.mesh->bounds;
        if (!plan.view.mayContain(plate.transformed(plaque.worldFromPlaque))) continue;
        const glm::dvec3 half(plate.high.x - edge, plate.high.y - edge, height);
        pass.draws.push_back(surfaceDraw(boxMesh(), glm::scale(plaque.worldFromPlaque, half), darkEnamel()));
    }
    if (pass.draws.empty())
        plan.skip(pass.name, "no plaque is in view");
    else
        plan.add(std::move(pass));
}

void planLetters(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    Pass pass;
    pass.name = "hall/plaques";
    pass.reason = "a plaque is in view";
    pass.phase = render::PassPhase::transparent;
    pass.shader = {.vertex = "hall/text.vert", .fragment = "hall/text.frag"};
    pass.colors = {Attachment::whole(radianceImage)};
    if (channels.albedo) writeAlbedo(pass);
    pass.depth = Attachment::whole(depthImage);
    pass.state = {.depthTest = render::DepthTest::nearerOrEqual,
                  .cull = render::Cull::back,
                  .blend = render::Blend::premultiplied,
                  .depthBias = {-1, -4}};
    for (const PlaqueText::Plaque& plaque : scene.text->plaques()) {
        if (!plan.view.mayContain(plaque.mesh->bounds.transformed(plaque.worldFromPlaque))) continue;
        SurfaceObject object = surfaceObject(plaque.worldFromPlaque, {});
        object.baseColor = enamel;
        object.fontSpread = static_cast<float>(2 * scene.text->spread());
        Draw draw;
        draw.mesh = plaque.mesh;
        draw.object = render::std140Bytes(object);
        draw.inputs = {{UNIT_FONT, scene.text->atlas()}};
        pass.draws.push_back(std::move(draw));
    }
    if (pass.draws.empty()) {
        plan.skip(pass.name, "no plaque is in view");
        return;
    }
    light.bindLighting(pass);
    pass.shaded.inView = true;
    plan.add(std::move(pass));
}

}  // namespace

void planPlaques(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    if (!scene.text) {
        plan.skip("hall/plaques", "there is no text to show");
        return;
    }
    planPlates(scene, light, channels, plan);
    planLetters(scene, light, channels, plan);
}

}  // namespace vitrine::hall
