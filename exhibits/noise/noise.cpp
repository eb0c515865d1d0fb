#include "exhibits/noise/noise.h"

#include "exhibits/kit/blue_noise.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/pixel_blocks.h"
#include "exhibits/kit/portal.h"
#include "exhibits/noise/noise_charts.h"
#include "exhibits/noise/noise_scene.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace vitrine::noise {
namespace {

/// Returns the light of the work, in its world. Alone, there is no hall whose evening it could share.
NoiseLight lightOf(const NoiseTable& t, const PlanContext& context)
{
    const glm::dvec3& hallSun = context.lighting.towardsSun;
    if (context.values[t.sunBy] != NoiseSun::hall)
        return noiseLight(t, context.values,
                          context.alone ? std::numbers::pi / 2 : std::asin(std::clamp(hallSun.y, -1.0, 1.0)));
    const glm::dvec3 towards = glm::normalize(glm::transpose(glm::dmat3(context.worldFromExhibit)) * hallSun);
    return {towards, std::asin(std::clamp(towards.y, -1.0, 1.0))};
}

/// Plans a pass that bakes noise into a volume, which repeats; kept once made.
render::ResourceId planVolume(const char* name, render::Format format, int size, render::Pass pass,
                              render::FramePlan& plan)
{
    const render::ResourceId volume = plan.image({.name = name,
                                                  .format = format,
                                                  .type = render::TextureType::volume,
                                                  .size = glm::ivec2(size),
                                                  .layers = size,
                                                  .persistent = true,
                                                  .repeat = true});
    pass.work = render::Work::compute;
    pass.phase = render::PassPhase::prepare;
    pass.storage = {render::Attachment::whole(volume)};
    pass.groups = glm::ivec3((size + 3) / 4);
    plan.add(std::move(pass));
    return volume;
}

render::ResourceId planCloudBake(const NoiseTable& t, const ParameterValues& values, render::FramePlan& plan)
{
    const int size = values[t.bakeSize];
    render::Pass pass = exhibitPass("noise/bake", "the clouds use baked noise", values, "", "");
    pass.shader.compute = "noise/cloud_bake.comp";
    render::Hash key;
    pass.contentHash = key.addValue(size).addValue(values[t.seed]).addValue(values[t.cloudOctaves]).value();
    return planVolume("noise.clouds", render::Format::rg16f, size, std::move(pass), plan);
}

std::string kindDefine(const NoiseTable& t, const ParameterValues& values)
{
    return "FIELD_KIND " + std::to_string(static_cast<int>(values[t.kind]));
}

render::ResourceId planFieldBake(const NoiseTable& t, const ParameterValues& values, render::FramePlan& plan)
{
    render::Pass pass = exhibitPass("noise/bake", "rays use baked noise in empty space", values, "", "");
    pass.shader.compute = "noise/field_bake.comp";
    pass.shader.defines = {kindDefine(t, values)};
    render::Hash key;
    pass.contentHash = key.addValue(values[t.seed]).addValue(values[t.kind]).value();
    return planVolume("noise.field", render::Format::r16f, FIELD_REPEAT * FIELD_TEXELS, std::move(pass), plan);
}

struct WorkShader {
    const char* name;
    const char* fragment;
};

WorkShader shaderOf(NoiseWork work)
{
    switch (work) {
    case NoiseWork::field: return {"noise/field", "noise/field.frag"};
    case NoiseWork::fractal: return {"noise/fractal", "noise/field.frag"};
    case NoiseWork::sea: return {"noise/sea", "noise/sea.frag"};
    case NoiseWork::clouds: break;
    }
    return {"noise/clouds", "noise/clouds.frag"};
}

/// Returns the parameter by which the work uses baked noise; nullopt if it uses none.
std::optional<Choice<NoiseLookup>> bakedBy(const NoiseTable& t, const ParameterValues& values)
{
    if (values[t.look] != NoiseLook::physical || values[t.work] == NoiseWork::sea) return std::nullopt;
    const bool clouds = values[t.work] == NoiseWork::clouds;
    if (!clouds && values[t.march] != NoiseMarch::bounded) return std::nullopt;
    const Choice<NoiseLookup> lookup = clouds ? t.cloudNoise : t.fieldNoise;
    return values[lookup] == NoiseLookup::baked ? std::optional(lookup) : std::nullopt;
}

bool hasPhysicalClouds(const NoiseTable& t, const ParameterValues& values)
{
    return values[t.work] == NoiseWork::clouds && values[t.look] == NoiseLook::physical;
}

/// Returns whether clouds are interpolated between the rays of a picture of half the size where they are smooth.
bool isInterpolated(const NoiseTable& t, const ParameterValues& values)
{
    return hasPhysicalClouds(t, values) && values[t.march] == NoiseMarch::bounded && values[t.cloudTolerance] > 0;
}

/// Returns whether steps through clouds are shifted by blue noise.
bool isJittered(const NoiseTable& t, const ParameterValues& values)
{
    return hasPhysicalClouds(t, values) && values[t.jitter];
}

/// Adds the defines that save the shader decisions at every step.
void addPermutation(const NoiseTable& t, const ParameterValues& values, render::Pass& pass)
{
    const auto define = [&](std::string text) { pass.shader.defines.push_back(std::move(text)); };
    const NoiseWork work = values[t.work];
    const bool physical = values[t.look] == NoiseLook::physical;
    if (!physical) define("REFERENCE");
    const bool halved = physical && values[t.march] == NoiseMarch::halved;
    if (halved && work == NoiseWork::sea) define("HEIGHT_STEPS");
    if (halved && work == NoiseWork::clouds) define("EVEN_STEPS");
    if (isJittered(t, values)) define("JITTER");
    if (bakedBy(t, values)) define("BAKED");
    if (work != NoiseWork::field && work != NoiseWork::fractal) return;
    const bool fractal = work == NoiseWork::fractal;
    define(kindDefine(t, values));
    define("FIELD_SUM " + std::to_string(fractal ? static_cast<int>(values[t.sum]) : 0));
    if (!physical) return;
    if (fractal && values[t.warp] > 0) define("WARP");
    if (halved) define("HALVED");
    if (values[t.normals] == NoiseNormal::derivative) define("DERIVATIVE");
}

/// Sets the position of the picture of half the size in the tile.
void setHalf(const PixelBlocks& blocks, const render::Raster& raster, NoiseBlock& block)
{
    const glm::dvec2 origin(blocks.side * blocks.first - raster.offset);
    const glm::dvec2 covered(blocks.side * blocks.count);
    block.halfOrigin = glm::vec2(origin);
    block.halfFromTile =
        glm::vec4(glm::dvec2(raster.drawn()) / covered, (glm::dvec2(raster.drawn()) - 2.0 * origin) / covered - 1.0);
}

/// Plans the picture of half the size, of `size` rays, and lets `pass`, which draws the clouds, interpolate between
/// them.
void planHalf(const NoiseTable& t, const PlanContext& context, const glm::ivec2& size, render::Pass& pass,
              render::FramePlan& plan)
{
    render::Pass half =
        exhibitPass("noise/clouds/half", "clouds are smooth in most places, so a quarter of the rays is enough there",
                    context.values, "noise/clouds_half.vert", "noise/clouds_half.frag");
    half.phase = render::PassPhase::prepare;
    half.blocks = pass.blocks;
    half.inputs = pass.inputs;
    half.draws = pass.draws;
    half.state.cull = pass.state.cull;
    if (context.alone) half.shader.defines.emplace_back("ALONE");
    addPermutation(t, context.values, half);
    const auto target = [&](const char* name, render::Format format, int unit, const glm::vec4& clear) {
        const render::ResourceId image = plan.image({.name = name, .format = format, .size = size, .nearest = true});
        half.colors.push_back(render::Attachment::cleared(image, clear));
        pass.inputs.push_back({unit, image});
    };
    target("noise.half", render::Format::rgba16f, UNIT_EXHIBIT_C, {0, 0, 0, -1});
    pass.shader.defines.emplace_back("INTERPOLATE");
    if (context.alone || context.channels.evaluations) {
        target("noise.halfDistance", render::Format::rgba32f, UNIT_SOURCE, glm::vec4(0));
        half.shader.defines.emplace_back("WITH_DISTANCE");
        pass.shader.defines.emplace_back("WITH_DISTANCE");
    }
    plan.add(std::move(half));
}

}  // namespace

render::Box Noise::bounds(const ParameterValues& values) const
{
    return portalBounds(noisePortal(table_, values));
}

render::Camera Noise::bestView(const ParameterValues& values) const
{
    return portalView(noisePortal(table_, values));
}

double Noise::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] ? 0 : std::numeric_limits<double>::infinity();
}

bool Noise::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

std::vector<StudyView> Noise::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    ParameterValues later = still;
    later.set(table_.moment, values[table_.moment] + 40);
    ParameterValues noon = still;
    noon.set(table_.sunElevation, 0.9);
    render::Camera aside = bestView(values), near = aside;
    aside.eye += glm::dvec3(0.9, -0.2, 0.1);
    near.eye += 0.6 * (near.target - near.eye);
    return {{"best view", bestView(values), 0, still},
            {"from the side", aside, 0, still},
            {"from near, later", near, 0, later},
            {"under a high sun", bestView(values), 0, noon}};
}

std::vector<Chart> Noise::charts(const ParameterValues& values) const
{
    return noiseCharts(table_, values);
}

ParameterValues Noise::standAloneValues(const ParameterValues& values) const
{
    if (const auto lookup = bakedBy(table_, values))
        refuseToStandAlone(title(), values.rows()[lookup->row], static_cast<double>(NoiseLookup::baked),
                           static_cast<double>(NoiseLookup::evaluated));
    if (isJittered(table_, values)) refuseToStandAlone(title(), values.rows()[table_.jitter.row], 1, 0);
    ParameterValues alone = values;
    // A shader that stands alone draws in one pass.
    alone.set(table_.cloudTolerance, 0.0);
    return alone;
}

StandAloneNumbers Noise::standAloneNumbers(const ParameterValues& values) const
{
    return {.assignments = noiseMotionGlsl(table_, values), .assigned = {"work.amplitudes"}};
}

void Noise::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const Table& t = table_;
    const ParameterValues& values = context.values;
    const NoiseWork work = values[t.work];
    for (const NoiseWork other : {NoiseWork::field, NoiseWork::fractal, NoiseWork::sea, NoiseWork::clouds})
        if (other != work) plan.skip(shaderOf(other).name, "another work is shown");
    const bool clouds = work == NoiseWork::clouds;
    // Noise is baked only for parameters that have an effect, so that no unused volume is kept.
    const bool baked = bakedBy(t, values).has_value();
    const WorkShader shader = shaderOf(work);
    render::Pass pass = portalPass(shader.name, "in view", values, shader.fragment, noisePortal(t, values), context);
    const NoiseLight light = lightOf(t, context);
    NoiseBlock block = noiseBlock(t, values, noiseTime(t, values, context.time), light.towards, plan.sample);
    const std::shared_ptr<const SkyView> sky = noiseSky(t, values, light);
    lightBy(*sky, light, values[t.brightness], block);
    // Each block of pixels has a ray, as have those of the neighbors that pixels at the tile's edge need.
    const PixelBlocks blocks{plan.view.raster, 2, 1};
    const bool interpolated = isInterpolated(t, values);
    if (interpolated) setHalf(blocks, plan.view.raster, block);
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    pass.inputs.push_back({UNIT_ENVIRONMENT, sky->radiance});
    addPermutation(t, values, pass);
    if (isJittered(t, values)) pass.inputs.push_back({UNIT_EXHIBIT_B, blueNoise()});
    if (baked) {
        pass.inputs.push_back(
            {UNIT_EXHIBIT_A, clouds ? planCloudBake(t, values, plan) : planFieldBake(t, values, plan)});
    } else {
        plan.skip("noise/bake", "no work uses baked noise", render::Work::compute);
    }
    if (interpolated)
        planHalf(t, context, blocks.count, pass, plan);
    else
        plan.skip("noise/clouds/half", clouds ? "a ray is marched through every pixel" : "another work is shown");
    plan.add(std::move(pass));
}

}  // namespace vitrine::noise
