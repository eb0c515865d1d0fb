#include "exhibits/crepuscular_rays/rays_scene.h"
#include "exhibits/kit/backdrop.h"
#include "exhibits/kit/blue_noise.h"
#include "shaders/lib/bindings.glsl"

namespace vitrine::crepuscular_rays {

render::ResourceId planMarch(const RaysScene& s, render::FramePlan& plan)
{
    // Nine cells are read for each pixel. Software renderers convert half floats one by one, and those would hold the
    // depth, in alpha, in steps of 16 mm at 20 m.
    const render::ResourceId scattered = plan.image({.name = "crepuscular_rays.scattered",
                                                     .format = render::Format::rgba32f,
                                                     .size = s.coarseSize,
                                                     .nearest = true});
    render::Pass pass = s.pass("march", "the sun's beams are in view", "crepuscular_rays/march.frag");
    pass.phase = render::PassPhase::volume;
    pass.colors = {render::Attachment::cleared(scattered)};
    s.context.lighting.bindLight(pass);
    std::erase_if(pass.inputs, [](const render::SampledTexture& input) {
        return input.unit != UNIT_SHADOW_HALL && input.unit != UNIT_SHADOW_EXHIBITS;
    });
    pass.inputs.push_back({UNIT_SOURCE, depthBehindGlass(plan)});
    pass.inputs.push_back({UNIT_EXHIBIT_C, blueNoise()});
    const std::int64_t rays = static_cast<std::int64_t>(s.coarseSize.x) * s.coarseSize.y;
    pass.counts["marchSteps"] = rays * s.values[s.table.volumeSteps] * static_cast<std::int64_t>(s.beams.size());
    plan.add(std::move(pass));
    return scattered;
}

}  // namespace vitrine::crepuscular_rays
