#include "exhibits/kit/exhibit_pass.h"

#include "exhibits/framework/table/derive.h"
#include "shaders/lib/bindings.glsl"

#include <utility>

namespace vitrine {

using render::Attachment;

render::Pass exhibitPass(std::string name, std::string reason, const ParameterValues& values, std::string vertex,
                         std::string fragment)
{
    render::Pass pass;
    pass.name = std::move(name);
    pass.reason = std::move(reason);
    pass.shader = {
        .vertex = std::move(vertex), .fragment = std::move(fragment), .prelude = derive::uniformBlock(values.table())};
    pass.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
    return pass;
}

void drawSurface(render::Pass& pass, const Channels& channels, render::Load load)
{
    const auto target = [load](const char* image) {
        return load == render::Load::clear ? Attachment::cleared(image) : Attachment::whole(image);
    };
    pass.colors = {target(radianceImage)};
    if (channels.normal) {
        pass.shader.defines.emplace_back("WRITE_NORMAL");
        pass.colors.push_back(target(normalImage));
    }
    if (channels.evaluations) {
        pass.shader.defines.push_back("WRITE_EVALUATIONS " + std::to_string(pass.colors.size()));
        pass.colors.push_back(target(evaluationsImage));
    }
    if (channels.albedo) writeAlbedo(pass, load);
    pass.depth = target(depthImage);
    pass.state.depthTest = render::DepthTest::nearer;
    pass.state.depthWrite = true;
    pass.state.cull = render::Cull::back;
}

void writeAlbedo(render::Pass& pass, render::Load load)
{
    pass.shader.defines.push_back("WRITE_ALBEDO " + std::to_string(pass.colors.size()));
    pass.colors.push_back(load == render::Load::clear ? Attachment::cleared(albedoImage)
                                                      : Attachment::whole(albedoImage));
}

render::Pass surfacePass(std::string name, std::string reason, const SceneLighting& light, const Channels& channels,
                         std::vector<std::string> defines, render::Load load)
{
    render::Pass pass;
    pass.name = std::move(name);
    pass.reason = std::move(reason);
    pass.shader = {.vertex = "kit/surface.vert", .fragment = "kit/surface.frag", .defines = std::move(defines)};
    drawSurface(pass, channels, load);
    light.bindLighting(pass);
    pass.shaded.inView = true;
    pass.depthOnly = meshDepth();
    return pass;
}

render::DepthOnly meshDepth()
{
    return {.shader = {.vertex = "kit/depth.vert", .fragment = "kit/depth.frag"}};
}

namespace {

/// Sets the view of the sun and the key, which changes with the shadow of any exhibit.
void seenBySun(render::Pass& pass, const SceneLighting& around)
{
    pass.phase = render::PassPhase::shadow;
    pass.view = around.exhibitShadowView;
    pass.contentHash = around.exhibitShadowKey;
    pass.bound = around.sunShadow;
}

}  // namespace

void castShadow(render::Pass& pass, const PlanContext& context)
{
    seenBySun(pass, context.lighting);
    pass.depth = Attachment::whole(exhibitShadowImage);
    pass.state.depthTest = render::DepthTest::nearer;
    pass.state.depthWrite = true;
    pass.state.depthClamp = true;
}

void castGlassShadow(render::Pass& pass, const PlanContext& context)
{
    seenBySun(pass, context.lighting);
    pass.colors = {Attachment::whole(glassShadowImage)};
}

render::Pass meshShadow(std::string name, const PlanContext& context)
{
    render::Pass pass;
    pass.name = std::move(name);
    pass.reason = shadowReason;
    pass.shader = meshDepth().shader;
    castShadow(pass, context);
    pass.state.depthBias = {1.5F, 2};
    return pass;
}

}  // namespace vitrine
