#include "exhibits/hall/hall_scene.h"

#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

namespace vitrine {
namespace {

render::Pass fullscreen(std::string name, std::string fragment, std::string source, std::string target,
                        std::string reason)
{
    render::Pass pass;
    pass.name = std::move(name);
    pass.reason = std::move(reason);
    pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = std::move(fragment)};
    pass.inputs = {{UNIT_SOURCE, std::move(source)}};
    pass.colors = {render::Attachment::whole(std::move(target))};
    pass.draws = {render::Draw{}};
    return pass;
}

/// Returns the function of shaders/lib/tonemap.glsl.
std::string_view functionOf(ToneCurve curve)
{
    static constexpr std::string_view functions[] = {"toneVitrine", "toneAgx", "toneAces", "toneNeutral", "toneNone"};
    return functions[static_cast<std::size_t>(curve)];
}

}  // namespace

void planToneMapping(const HallScene& scene, const SceneLighting& lighting, const FrameRequest& request,
                     const FrameHistory& history, render::FramePlan& plan)
{
    const bool averaged = request.samples > 1;
    const bool toneMapped = request.averageIn == AverageIn::display;
    const bool exact = averaged || !toneMapped;
    plan.image(
        {.name = "frame", .format = exact ? render::Format::rgba32f : render::Format::rgba16f, .persistent = averaged});

    std::string source = radianceImage;
    if (toneMapped) {
        const bool further = averaged || isAveragedOverFrames(request, history);
        const std::string target = further ? displayImage : "frame";
        if (further) plan.image({.name = target, .format = render::Format::rgba16f});
        render::Pass tone =
            fullscreen("tone", "lib/tonemap.frag", source, target, "the screen shows less than the eye sees");
        tone.phase = render::PassPhase::resolve;
        tone.shader.defines.push_back("TONE_CURVE " + std::string(functionOf(scene.values[scene.table.toneCurve])));
        tone.blocks[BLOCK_LIGHT] = render::std140Bytes(lighting.light);  // For the exposure, without maps.
        tone.bound = {1, 1, {}};  // The displayed value is between 0 and 1, whatever the light.
        // Every pixel is written, so the previous content is not needed.
        tone.colors[0].load = render::Load::clear;
        plan.add(std::move(tone));
        source = target;
    } else {
        plan.skip("tone", "linear light is requested");
    }
    if (!averaged) {
        plan.skip("average", "one sample per pixel");
        if (toneMapped) return planAntialiasing(request, history, plan);
    }
    render::Pass average =
        fullscreen(averaged ? "average" : "copy", "lib/copy.frag", source, "frame",
                   averaged ? "sample " + std::to_string(request.sample + 1) + " of " + std::to_string(request.samples)
                            : "linear light is output unchanged");
    average.phase = render::PassPhase::present;
    if (!toneMapped) average.shader.defines.emplace_back("COVERAGE");
    if (averaged && request.sample > 0) {
        average.state.blend = render::Blend::mean;
        average.state.meanWeight = 1.0F / static_cast<float>(request.sample + 1);
    } else {
        average.colors[0].load = render::Load::clear;
    }
    plan.add(std::move(average));
    planAntialiasing(request, history, plan);
}

}  // namespace vitrine
