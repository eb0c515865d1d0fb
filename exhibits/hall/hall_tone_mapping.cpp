// The end of every frame: glare, tone mapping and averages.
#include "exhibits/framework/scene/glare.h"
#include "exhibits/hall/hall_scene.h"

#include "render/glsl/std140.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <bit>

namespace vitrine::hall {

#include "shaders/lib/glare_block.glsl"

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

constexpr const char* glareSourcePass = "glare";
constexpr const char* glareSourceImage = "glare.source";

/// Share of a light that a healthy eye scatters into each octave of angles (Holladay 1926: the luminance of the veil is
/// 10 / degrees^2 times the illuminance): 10 * 2 pi * ln 2 * (pi / 180)^2.
constexpr double shareOfEye = 0.0133;

/// Returns the number of levels that fit into the picture: a texel of the last one is at most half as high.
int levelsIn(glm::ivec2 picture)
{
    const int texels = std::max(std::min(picture.x, picture.y) / (2 * GLARE_DIVISOR), 1);
    return static_cast<int>(std::bit_width(static_cast<unsigned>(texels)));
}

/// Returns the part of the pass that both steps of the glare have in common.
render::Pass glarePass(const char* name, const char* fragment, render::SampledTexture source, const char* target)
{
    render::Pass pass = fullscreen(name, fragment, {}, target, "light is brighter than the screen's white");
    pass.phase = render::PassPhase::resolve;
    pass.inputs = {std::move(source)};
    pass.colors[0].load = render::Load::clear;  // Every pixel is written.
    return pass;
}

/// Lets the pass `tone` add these halos.
template <typename Source> void addHalos(render::Pass& tone, const GlareBlock& block, Source halos)
{
    tone.shader.defines.emplace_back("GLARE");
    tone.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    tone.inputs.push_back({UNIT_EXHIBIT_A, std::move(halos)});
}

/// Plans the halos around light that is brighter than the screen's white, which the pass `tone` then adds.
void planGlare(const HallScene& scene, const SceneLighting& lighting, double brightest, const FrameRequest& request,
               render::Pass& tone, render::FramePlan& plan)
{
    const auto skip = [&](const char* why) {
        plan.skip(glareSourcePass, why);
        plan.skip(glareSpreadPass, why);
    };
    if (request.transparent || request.cutOut) return skip("a transparent background is requested");
    const glm::ivec2 picture = request.raster.drawn();
    const bool isPart = picture != request.raster.size;
    if (isPart && !request.halos) return skip("the picture is drawn in tiles, and halos reach beyond them");
    GlareBlock block;
    block.levels = std::min(scene.values[scene.table.glareLevels], levelsIn(isPart ? request.halos->picture : picture));
    block.share = static_cast<float>(shareOfEye * scene.values[scene.table.glare]);
    if (isPart) {
        block.offset = request.raster.offset;
        const render::Texture& of = *request.halos->texture;
        block.scale = glm::vec2(request.halos->picture) / glm::vec2(request.raster.size) /
                      (static_cast<float>(GLARE_DIVISOR) * glm::vec2(of.width, of.height));
        addHalos(tone, block, request.halos->texture);
        return skip("the halos of the whole picture are used");
    }
    const double share = shareOfEye * block.levels;
    // Light that an exhibit sends has no known bound.
    const double above = brightest * lighting.exposure - 1;
    const render::ContributionBound bound =
        render::boundOf(0, share / std::max(lighting.exposure, 1e-9),
                        {{scene.values[scene.table.glare], "the strength of the glare is 0"},
                         {above, "nothing is brighter than the screen's white"}});
    if (!plan.includeIfEffective(bound, {glareSourcePass, glareSpreadPass})) return;

    // The size is rounded up, so that it can be halved exactly from level to level.
    const int step = GLARE_DIVISOR << (block.levels - 1);
    const glm::ivec2 size = (picture + step - 1) / step * (step / GLARE_DIVISOR);
    plan.image({.name = glareSourceImage, .format = render::Format::rgba16f, .size = size, .levels = block.levels});
    plan.image({.name = glareSpreadImage, .format = render::Format::rgba16f, .size = size});
    block.scale = 1.0F / (static_cast<float>(GLARE_DIVISOR) * glm::vec2(size));
    const render::Bytes bytes = render::std140Bytes(block);
    render::Pass source = glarePass(glareSourcePass, "hall/glare_source.frag",
                                    {UNIT_SOURCE, std::string(radianceImage)}, glareSourceImage);
    source.blocks[BLOCK_LIGHT] = tone.blocks.at(BLOCK_LIGHT);
    source.blocks[BLOCK_EXHIBIT] = bytes;
    source.mipmaps = {glareSourceImage};
    source.bound = bound;
    plan.add(std::move(source));
    render::Pass spread = glarePass(glareSpreadPass, "hall/glare_spread.frag",
                                    {UNIT_EXHIBIT_A, std::string(glareSourceImage)}, glareSpreadImage);
    spread.blocks[BLOCK_EXHIBIT] = bytes;
    spread.bound = bound;
    plan.add(std::move(spread));
    addHalos(tone, block, std::string(glareSpreadImage));
}

}  // namespace

void planToneMapping(const HallScene& scene, const SceneLighting& lighting, double brightest,
                     const FrameRequest& request, const FrameHistory& history, render::FramePlan& plan)
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
        planGlare(scene, lighting, brightest, request, tone, plan);
        plan.add(std::move(tone));
        source = target;
    } else {
        plan.skip(glareSourcePass, "linear light is requested");
        plan.skip(glareSpreadPass, "linear light is requested");
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

}  // namespace vitrine::hall
