#include "render/plan/frame_plan.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::render {
namespace {

/// Texture units at which the second step reads the surface, by the order of the first step's outputs.
constexpr int storedUnits[] = {UNIT_BASE_COLOR, UNIT_NORMAL, UNIT_ORM};

std::string storedImage(const Pass& pass, std::size_t which)
{
    return pass.colors.front().image + ".stored." + std::to_string(which);
}

/// Returns the step that lights what `surfaces`, which is the first step, has stored.
Pass lightingOf(const Pass& surfaces)
{
    Pass light;
    light.name = surfaces.name + "/light";
    light.reason = "the pass before stored surfaces, and each pixel is lit once";
    light.phase = surfaces.phase;
    light.shader = surfaces.shader;
    light.shader.vertex = "kit/stored_surface.vert";
    std::erase_if(light.shader.defines, [](const std::string& define) { return define.starts_with("WRITE_"); });
    for (const char* define : {"LIGHT_STORED", "FLAT_LIGHT"}) light.shader.defines.emplace_back(define);
    light.state.blend = Blend::add;
    light.colors = {surfaces.colors.front()};
    light.colors.front().load = Load::keep;
    light.inputs = surfaces.inputs;
    for (std::size_t i = 0; i < std::size(storedUnits); ++i)
        light.inputs.push_back({storedUnits[i], storedImage(surfaces, i)});
    light.buffers = surfaces.buffers;
    light.blocks = surfaces.blocks;
    light.view = surfaces.view;
    light.columns = surfaces.columns;
    light.temporal = surfaces.temporal;
    light.contentHash = surfaces.contentHash;  // A picture that is abandoned between the steps is not kept.
    light.draws = {Draw{}};
    return light;
}

}  // namespace

FramePlan FramePlan::withDeferredShading() const
{
    FramePlan plan = *this;
    std::vector<Pass> passes;
    for (Pass& pass : plan.passes_) {
        Pass& first = passes.emplace_back(std::move(pass));
        if (!first.deferrable) continue;
        Pass light = lightingOf(first);
        first.shader.defines.push_back("STORE_SURFACE " + std::to_string(first.colors.size()));
        for (std::size_t i = 0; i < std::size(storedUnits); ++i) {
            ImageInfo stored = images_.at(first.colors.front().image);
            stored.name = storedImage(first, i);
            stored.format = Format::rgba32f;
            stored.type = TextureType::flat;
            stored.layers = stored.levels = 1;
            stored.persistent = false;
            stored.nearest = true;
            first.colors.push_back(Attachment::cleared(plan.image(std::move(stored))));
        }
        passes.push_back(std::move(light));
    }
    plan.passes_ = std::move(passes);
    return plan;
}

}  // namespace vitrine::render
