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

/// Returns whether the pass is faster in two steps: many of its triangles are in view (a corner is, without regard to
/// the part of the picture that is drawn), so that most of the pixels for which a shader runs are beside its triangle.
/// With llvmpipe, one step is faster in views with no whole triangle, such as those of the works in the walls.
bool hasManyTriangles(const Pass& pass, const View& planView)
{
    if (!pass.triangleSamples) return false;
    constexpr std::size_t many = 200;
    std::size_t missing = many / Pass::trianglesPerSample + 1;
    const View& view = pass.view ? *pass.view : planView;
    const auto inView = [&](const glm::vec3& corner) {
        const glm::dvec3 seen(view.viewFromWorld * glm::dvec4(corner, 1));
        const glm::dvec2 offAxis = glm::abs(glm::dvec2(seen) + view.tanShift * seen.z);
        return glm::all(glm::lessThanEqual(offAxis, view.tanHalfFov * -seen.z));
    };
    return std::any_of(pass.triangleSamples->begin(), pass.triangleSamples->end(),
                       [&](const glm::vec3& corner) { return inView(corner) && --missing == 0; });
}

}  // namespace

std::optional<FramePlan> FramePlan::withDeferredShading() const
{
    std::vector<bool> split;
    for (const Pass& pass : passes_) split.push_back(hasManyTriangles(pass, view));
    if (std::find(split.begin(), split.end(), true) == split.end()) return {};
    FramePlan plan = *this;
    std::vector<Pass> passes;
    for (std::size_t i = 0; i < split.size(); ++i) {
        Pass& first = passes.emplace_back(std::move(plan.passes_[i]));
        if (!split[i]) continue;
        Pass light = lightingOf(first);
        first.shader.defines.push_back("STORE_SURFACE " + std::to_string(first.colors.size()));
        for (std::size_t k = 0; k < std::size(storedUnits); ++k) {
            ImageInfo stored = images_.at(first.colors.front().image);
            stored.name = storedImage(first, k);
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
