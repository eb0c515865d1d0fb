#include "exhibits/crepuscular_rays/rays_cpu.h"
#include "exhibits/crepuscular_rays/rays_scene.h"
#include "exhibits/kit/backdrop.h"
#include "exhibits/kit/blue_noise.h"
#include "render/plan/secondary_view.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vitrine::crepuscular_rays {
namespace {

using render::Attachment;
using render::Pass;
using render::ResourceId;

constexpr int passesOfTaps = 3;

std::int64_t pixels(glm::ivec2 size)
{
    return static_cast<std::int64_t>(size.x) * size.y;
}

/// Plans a pass with the depth of everything that hides the sky, for the whole picture. Returns its depth image.
std::string planOccluders(const RaysScene& s, render::FramePlan& plan)
{
    const char* reason =
        s.tile ? "the picture is a tile and does not show the whole sky" : "the mask is made of the occluders";
    const std::map<std::string, std::string> images = render::addSecondaryView(
        plan, s.context.planOfView(s.wholeView),
        {.name = "crepuscular_rays/occluders", .reason = reason, .view = s.wholeView, .depthOnly = true});
    return images.at(depthImage);
}

void planLoop(const RaysScene& s, const ResourceId& mask, const ResourceId& rays, render::FramePlan& plan)
{
    const bool plain = s.values[s.table.sum] == RaySum::plain;
    // With a path of length 0, one sample is exact: the mask, bit for bit.
    const int samples = !plain && s.block.gathered <= 0 ? 1 : s.values[s.table.samples];
    const bool inPlaceOfPasses = s.tile && !plain && s.values[s.table.method] == RayMethod::threePasses;
    Pass pass = s.pass(
        "loop",
        inPlaceOfPasses ? "the picture is a tile, which cannot read the passes of its neighbors; one loop replaces them"
                        : "the sky shines into the picture",
        "crepuscular_rays/loop.frag");
    pass.phase = render::PassPhase::volume;
    if (plain) pass.shader.defines.emplace_back("PLAIN_SUM");
    pass.colors = {Attachment::cleared(rays)};
    pass.inputs = {{UNIT_EXHIBIT_A, mask}, {UNIT_EXHIBIT_C, blueNoise()}, {UNIT_SOURCE, depthBehindGlass(plan)}};
    RaysBlock block = s.block;
    block.samples = samples;
    block.ratio = static_cast<float>(s.values[s.table.decay]);
    pass.draws[0].object = render::std140Bytes(block);
    pass.counts["fetches"] = pixels(s.coarseSize) * samples;
    plan.add(std::move(pass));
}

void planTaps(const RaysScene& s, const ResourceId& mask, const ResourceId& rays, render::FramePlan& plan)
{
    const double taps = std::max(std::round(std::cbrt(s.values[s.table.samples])), 1.0);
    const double ratio = glsl::shaftRatio(s.block.gathered, s.block.exponent, taps, passesOfTaps);
    const char* names[passesOfTaps] = {"taps/1", "taps/2", "taps/3"};
    const auto between = [&](const char* name) {
        return plan.image({.name = name, .format = render::Format::rgba16f, .size = s.coarseSize});
    };
    const ResourceId images[passesOfTaps + 1] = {mask, between("crepuscular_rays.near"),
                                                 between("crepuscular_rays.middle"), rays};
    for (int i = 0; i < passesOfTaps; ++i) {
        Pass pass = s.pass(names[i], "the sky shines into the picture", "crepuscular_rays/taps.frag");
        pass.phase = render::PassPhase::volume;
        pass.colors = {Attachment::cleared(images[i + 1])};
        pass.inputs = {
            {UNIT_EXHIBIT_A, images[i]}, {UNIT_EXHIBIT_C, blueNoise()}, {UNIT_SOURCE, depthBehindGlass(plan)}};
        RaysBlock block = s.block;
        block.samples = static_cast<int>(taps);
        block.ratio = static_cast<float>(std::pow(ratio, std::pow(taps, i)));
        block.isFirstPass = i == 0;
        pass.draws[0].object = render::std140Bytes(block);
        pass.counts["fetches"] = pixels(s.coarseSize) * static_cast<std::int64_t>(taps);
        plan.add(std::move(pass));
    }
}

ResourceId planPolar(RaysScene& s, const ResourceId& mask, render::FramePlan& plan)
{
    const PolarGrid grid = polarGrid(glm::dvec2(s.block.sun), s.maskSize, s.values[s.table.samples]);
    const double span = std::log(grid.lastRadius / grid.firstRadius);
    s.block.firstAngle = static_cast<float>(grid.firstAngle);
    s.block.angleSpan = static_cast<float>(grid.span);
    s.block.logFirstRadius = static_cast<float>(std::log(grid.firstRadius));
    s.block.logRadiusSpan = static_cast<float>(span);
    s.block.radii = grid.radii;
    s.block.angles = grid.angles;
    s.block.keep = static_cast<float>(std::exp(-s.block.exponent * span / grid.radii));
    s.block.sunIsBeyondEdge = !grid.around;
    const ResourceId polar = plan.image({.name = "crepuscular_rays.polar",
                                         .format = render::Format::rgba16f,
                                         .size = {grid.radii, grid.angles},
                                         .repeat = true});
    Pass pass = s.pass("polar", "the sky shines into the picture", "");
    pass.work = render::Work::compute;
    pass.phase = render::PassPhase::volume;
    pass.shader.vertex.clear();
    pass.shader.compute = "crepuscular_rays/polar.comp";
    pass.storage = {Attachment::whole(polar)};
    pass.inputs = {{UNIT_EXHIBIT_A, mask}};
    pass.draws.clear();
    pass.blocks[BLOCK_OBJECT] = render::std140Bytes(s.block);
    pass.groups = {(grid.angles + 31) / 32, 1, 1};
    pass.counts["fetches"] = static_cast<std::int64_t>(grid.radii) * grid.angles;
    plan.add(std::move(pass));
    return polar;
}

}  // namespace

RayMethod methodOf(const RaysScene& s)
{
    if (s.values[s.table.sum] == RaySum::plain) return RayMethod::loop;
    const RayMethod method = s.values[s.table.method];
    // For a short path the running sum is a small difference of large numbers.
    const double stretch = 1 - glsl::shaftWeightBelow(1.0 - s.block.gathered, s.block.exponent);
    if (method == RayMethod::polar && stretch < 0.1) return RayMethod::loop;
    return s.tile && method == RayMethod::threePasses ? RayMethod::loop : method;
}

ResourceId planMask(const RaysScene& s, render::FramePlan& plan)
{
    const bool occluders = s.tile || s.values[s.table.mask] == RayMask::occluders;
    const bool alpha = !occluders && s.values[s.table.mask] == RayMask::alpha;
    const std::string hides = occluders ? planOccluders(s, plan) : alpha ? radianceImage : depthBehindGlass(plan);
    const ResourceId mask =
        plan.image({.name = "crepuscular_rays.mask", .format = render::Format::rgba16f, .size = s.maskSize});
    Pass pass = s.pass("mask", "the sky is in view", "crepuscular_rays/mask.frag");
    // Alpha distinguishes the sky only until the sky is drawn. Depth is complete once everything opaque is drawn.
    pass.phase = alpha ? render::PassPhase::opaque : render::PassPhase::volume;
    if (alpha) pass.shader.defines.emplace_back("FROM_ALPHA");
    if (occluders) pass.view = s.wholeView;
    pass.colors = {Attachment::cleared(mask)};
    pass.inputs = {{UNIT_SOURCE, hides}};
    pass.blocks[BLOCK_LIGHT] = render::std140Bytes(s.context.lighting.light);
    for (const render::SampledTexture& input : s.context.lighting.inputs)
        if (input.unit == UNIT_ENVIRONMENT) pass.inputs.push_back(input);
    pass.counts["fetches"] = pixels(s.maskSize);
    plan.add(std::move(pass));
    return mask;
}

ResourceId planGathering(RaysScene& s, const ResourceId& mask, render::FramePlan& plan)
{
    const RayMethod method = methodOf(s);
    if (method == RayMethod::polar) return planPolar(s, mask, plan);
    const ResourceId rays =
        plan.image({.name = "crepuscular_rays.rays", .format = render::Format::rgba16f, .size = s.coarseSize});
    if (method == RayMethod::loop)
        planLoop(s, mask, rays, plan);
    else
        planTaps(s, mask, rays, plan);
    return rays;
}

}  // namespace vitrine::crepuscular_rays
