#include "exhibits/crepuscular_rays/blue_noise.h"
#include "exhibits/crepuscular_rays/rays_scene.h"
#include "render/glsl/cpu.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <set>

namespace vitrine {
namespace {

using render::Attachment;
using render::Load;
using render::Pass;

constexpr int passesOfTaps = 3;

std::int64_t pixels(glm::ivec2 size)
{
    return static_cast<std::int64_t>(size.x) * size.y;
}

/// Whether every fragment of it hides what is behind: then its mesh tells all, and its material nothing.
bool isSolidMesh(const Pass& pass)
{
    const auto& defines = pass.shader.defines;
    return pass.shader.vertex == "hall/surface.vert" &&
           std::none_of(defines.begin(), defines.end(),
                        [](const std::string& d) { return d == "ALPHA_MASK" || d == "WIPE"; });
}

/// Draws everything once more that hides the sky, seen in the whole picture: meshes in one pass by their positions
/// alone, whatever finds its own depth (marched, or cut out) by its own shaders.
void planOccluders(const RaysScene& s, render::FramePlan& plan)
{
    constexpr const char* own = "crepuscular_rays.occluders";
    plan.image({.name = own, .format = render::Format::depth32f, .size = s.maskSize, .nearest = true});
    Pass pass;
    pass.name = "crepuscular_rays/occluders";
    pass.reason = s.tile ? "a tile does not show the whole sky" : "the mask is made of the occluders";
    pass.stage = render::Stage::prepare;
    pass.shader = {"hall/depth.vert", "hall/depth.frag", "", {}};
    pass.view = s.wholeView;
    pass.depth = Attachment{own, Load::clear, glm::vec4(0), -1, 0};
    pass.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true};

    const render::FramePlan seen = s.context.seenFrom(s.wholeView);
    std::vector<Pass> others;
    std::set<std::string> renamed;
    const auto ownName = [&](const std::string& image) { return std::string(own) + '.' + image; };
    for (const Pass& drawn : seen.passes()) {
        const bool hides = drawn.stage == render::Stage::opaque && drawn.depth && drawn.depth->image == depthImage &&
                           drawn.state.depthWrite;
        if (hides && isSolidMesh(drawn)) {
            pass.draws.insert(pass.draws.end(), drawn.draws.begin(), drawn.draws.end());
            continue;
        }
        // What another pass of the same view prepares, a cone for every block of pixels, is prepared anew, too.
        const bool prepares = drawn.stage == render::Stage::prepare && !drawn.key;
        if (!hides && !prepares) continue;
        Pass copy = drawn;
        copy.name = pass.name + '/' + drawn.name;
        copy.reason = pass.reason;
        copy.stage = render::Stage::prepare;
        copy.view = s.wholeView;
        if (hides) {
            copy.shader.defines.emplace_back("DEPTH_ONLY");
            copy.colors.clear();
            copy.depth = Attachment{own, Load::keep, glm::vec4(0), -1, 0};
        }
        for (std::vector<Attachment>* attachments : {&copy.colors, &copy.storage}) {
            for (Attachment& attachment : *attachments) {
                renamed.insert(attachment.image);
                attachment.image = ownName(attachment.image);
            }
        }
        for (render::Input& input : copy.inputs)
            if (auto* image = std::get_if<std::string>(&input.source); image && renamed.contains(*image))
                *image = ownName(*image);
        others.push_back(std::move(copy));
    }
    for (const std::string& image : renamed) {
        render::ImageInfo info = seen.images().at(image);
        info.name = ownName(image);
        if (info.size == glm::ivec2(0))
            info.size = glm::max(glm::ivec2(glm::dvec2(s.maskSize) * info.scale), glm::ivec2(1));
        plan.image(std::move(info));
    }
    for (render::Draw& draw : pass.draws) draw.inputs.clear();
    plan.add(std::move(pass));
    for (Pass& other : others) plan.add(std::move(other));
}

void planLoop(const RaysScene& s, render::FramePlan& plan)
{
    const bool plain = s.values[s.table.sum] == RaySum::plain;
    // Without a way to go, one look tells all, and the mask comes through to the bit.
    const int samples = !plain && s.block.gathered <= 0 ? 1 : s.values[s.table.samples];
    const bool inPlaceOfPasses = s.tile && !plain && s.values[s.table.method] == RayMethod::threePasses;
    Pass pass = s.pass("loop",
                       inPlaceOfPasses ? "a tile cannot look into its neighbors' passes, so one loop takes their place"
                                       : "the sky shines into the picture",
                       "crepuscular_rays/loop.frag");
    pass.stage = render::Stage::volume;
    if (plain) pass.shader.defines.emplace_back("PLAIN_SUM");
    pass.colors = {{"crepuscular_rays.rays", Load::clear, {}, -1, 0}};
    pass.inputs = {{UNIT_EXHIBIT_A, std::string("crepuscular_rays.mask")},
                   {UNIT_EXHIBIT_C, blueNoise()},
                   {UNIT_SOURCE, std::string(depthImage)}};
    RaysBlock block = s.block;
    block.samples = samples;
    block.ratio = static_cast<float>(s.values[s.table.decay]);
    pass.draws[0].object = render::std140Bytes(block);
    pass.counts["fetches"] = pixels(s.coarseSize) * samples;
    plan.add(std::move(pass));
}

void planTaps(const RaysScene& s, render::FramePlan& plan)
{
    const double taps = std::max(std::round(std::cbrt(s.values[s.table.samples])), 1.0);
    const double ratio = glsl::shaftRatio(s.block.gathered, s.block.exponent, taps, passesOfTaps);
    const char* names[passesOfTaps] = {"taps/1", "taps/2", "taps/3"};
    const char* images[passesOfTaps] = {"crepuscular_rays.near", "crepuscular_rays.middle", "crepuscular_rays.rays"};
    for (int i = 0; i < passesOfTaps; ++i) {
        if (i < passesOfTaps - 1)
            plan.image({.name = images[i], .format = render::Format::rgba16f, .size = s.coarseSize});
        Pass pass = s.pass(names[i], "the sky shines into the picture", "crepuscular_rays/taps.frag");
        pass.stage = render::Stage::volume;
        pass.colors = {{images[i], Load::clear, {}, -1, 0}};
        pass.inputs = {{UNIT_EXHIBIT_A, std::string(i == 0 ? "crepuscular_rays.mask" : images[i - 1])},
                       {UNIT_EXHIBIT_C, blueNoise()},
                       {UNIT_SOURCE, std::string(depthImage)}};
        RaysBlock block = s.block;
        block.samples = static_cast<int>(taps);
        block.ratio = static_cast<float>(std::pow(ratio, std::pow(taps, i)));
        block.isFirstPass = i == 0;
        pass.draws[0].object = render::std140Bytes(block);
        pass.counts["fetches"] = pixels(s.coarseSize) * static_cast<std::int64_t>(taps);
        plan.add(std::move(pass));
    }
}

void planPolar(RaysScene& s, render::FramePlan& plan)
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
    plan.image({.name = "crepuscular_rays.polar",
                .format = render::Format::rgba16f,
                .size = {grid.radii, grid.angles},
                .repeat = true});
    Pass pass = s.pass("polar", "the sky shines into the picture", "");
    pass.work = render::Work::compute;
    pass.stage = render::Stage::volume;
    pass.shader.vertex.clear();
    pass.shader.compute = "crepuscular_rays/polar.comp";
    pass.storage = {{"crepuscular_rays.polar", Load::keep, {}, -1, 0}};
    pass.inputs = {{UNIT_EXHIBIT_A, std::string("crepuscular_rays.mask")}};
    pass.draws.clear();
    pass.blocks[BLOCK_OBJECT] = render::std140Bytes(s.block);
    pass.groups = {(grid.angles + 31) / 32, 1, 1};
    pass.counts["fetches"] = static_cast<std::int64_t>(grid.radii) * grid.angles;
    plan.add(std::move(pass));
}

}  // namespace

RayMethod methodOf(const RaysScene& s)
{
    if (s.values[s.table.sum] == RaySum::plain) return RayMethod::loop;
    const RayMethod method = s.values[s.table.method];
    // The running sum gives a short stretch of the way as a small difference of large numbers.
    const double stretch = 1 - glsl::shaftWeightBelow(1.0 - s.block.gathered, s.block.exponent);
    if (method == RayMethod::polar && stretch < 0.1) return RayMethod::loop;
    return s.tile && method == RayMethod::threePasses ? RayMethod::loop : method;
}

void planMask(const RaysScene& s, render::FramePlan& plan)
{
    const bool occluders = s.tile || s.values[s.table.mask] == RayMask::occluders;
    const bool alpha = !occluders && s.values[s.table.mask] == RayMask::alpha;
    if (occluders) planOccluders(s, plan);
    plan.image({.name = "crepuscular_rays.mask", .format = render::Format::rgba16f, .size = s.maskSize});
    Pass pass = s.pass("mask", "the sky is in view", "crepuscular_rays/mask.frag");
    // What is not covered tells the sky only as long as the sky is not drawn; depth is ready when all is.
    pass.stage = alpha ? render::Stage::opaque : render::Stage::volume;
    if (alpha) pass.shader.defines.emplace_back("FROM_ALPHA");
    if (occluders) pass.view = s.wholeView;
    pass.colors = {{"crepuscular_rays.mask", Load::clear, {}, -1, 0}};
    pass.inputs = {{UNIT_SOURCE, std::string(occluders ? "crepuscular_rays.occluders"
                                             : alpha   ? radianceImage
                                                       : depthImage)}};
    pass.blocks[BLOCK_LIGHT] = render::std140Bytes(s.context.surroundings.light);
    for (const render::Input& input : s.context.surroundings.inputs)
        if (input.unit == UNIT_ENVIRONMENT) pass.inputs.push_back(input);
    pass.counts["fetches"] = pixels(s.maskSize);
    plan.add(std::move(pass));
}

void planGathering(RaysScene& s, render::FramePlan& plan)
{
    const RayMethod method = methodOf(s);
    if (method == RayMethod::polar) return planPolar(s, plan);
    plan.image({.name = "crepuscular_rays.rays", .format = render::Format::rgba16f, .size = s.coarseSize});
    if (method == RayMethod::loop)
        planLoop(s, plan);
    else
        planTaps(s, plan);
}

}  // namespace vitrine
