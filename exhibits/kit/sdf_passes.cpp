#include "exhibits/kit/sdf_passes.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/kit/backdrop.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/pixel_blocks.h"
#include "exhibits/kit/surface_draw.h"
#include "render/glsl/std140.h"
#include "shaders/kit/sdf/shadow_methods.glsl"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <limits>

namespace vitrine {
namespace {

using render::Attachment;
using render::Pass;

constexpr int pixelsOfCone = 8;  ///< Side of the block that one cone covers.

struct SdfPlanner {
    const SdfScene& scene;
    render::FramePlan& plan;
    const SdfParameters& table = scene.table;
    const ParameterValues& values = scene.body.values;

    [[nodiscard]] std::string named(const char* step) const { return std::string(scene.exhibit) + '/' + step; }
    [[nodiscard]] glm::dmat4 worldFromBody() const
    {
        return scene.context.worldFromExhibit * scene.body.exhibitFromBody;
    }
    [[nodiscard]] Pass pass(const char* step, std::string reason, std::string vertex, std::string fragment) const
    {
        return sdfPass(scene, step, std::move(reason), std::move(vertex), std::move(fragment));
    }
    [[nodiscard]] render::Draw draw(std::shared_ptr<const render::Mesh> mesh) const
    {
        return sdfDraw(scene, std::move(mesh));
    }

    void shadow() const
    {
        Pass made = pass("shadow", shadowReason, "kit/sdf/box.vert",
                         scene.glass ? "kit/sdf/glass_shadow.frag" : "kit/sdf/shadow.frag");
        if (scene.glass)
            castGlassShadow(made, scene.context);
        else
            castShadow(made, scene.context);
        made.state.cull = render::Cull::front;
        made.draws = {draw(boxMesh())};
        plan.add(std::move(made));
    }

    [[nodiscard]] std::string coneImage() const { return std::string(scene.exhibit) + ".cone"; }
    [[nodiscard]] static std::string coneDefine() { return "CONE_PREPASS " + std::to_string(pixelsOfCone); }

    void cone() const
    {
        if (!values[table.conePrepass]) {
            plan.skip(named("cone"), "the cone pre-pass is switched off");
            return;
        }
        const render::ResourceId image = plan.image({.name = coneImage(),
                                                     .format = render::Format::rgba32f,
                                                     .size = PixelBlocks(plan.view.raster, pixelsOfCone).count,
                                                     .nearest = true});
        Pass made =
            pass("cone", "it shortens the way of every ray to the object", "lib/fullscreen.vert", "kit/sdf/cone.frag");
        made.phase = render::PassPhase::prepare;
        made.shader.defines.push_back(coneDefine());
        made.colors = {Attachment::cleared(image)};
        made.draws = {draw(nullptr)};
        plan.add(std::move(made));
    }

    /// Returns why an effect is off: `switchedOff`, or the body's own reason if the parameters ask for it.
    [[nodiscard]] std::string whyOff(bool asked, std::string_view switchedOff) const
    {
        return std::string(asked ? scene.body.switchedOff : switchedOff);
    }

    void occlusion(Pass& made, ParameterValues& needed, bool heat, double any) const
    {
        const double scattered = scene.glass && !heat ? 0 : 1;
        if (!values[table.ambientOcclusion])
            plan.skip(named("occlusion"),
                      whyOff(scene.context.values[table.ambientOcclusion], "ambient occlusion is switched off"));
        else if (!plan.includeIfEffective(
                     made,
                     {named("occlusion"),
                      render::boundOf(
                          any, 0, {scene.body.occluded, {scattered, "glass scatters nothing of the room's light"}})}))
            needed.set(table.ambientOcclusion, false);
    }

    /// Plans the effects of the shading. The pass gets values without the effects that would be invisible.
    void effects(Pass& made) const
    {
        const SceneLighting& around = scene.context.lighting;
        const bool heat = values[table.heatMap] != SdfHeatMap::none;
        // A heat map shows the cost of the effects, so no bound on light applies.
        const double any = heat ? std::numeric_limits<double>::infinity() : 1;
        const int bounces = values[table.bounces];
        const double own = scene.body.ownLight * mostReflected;
        const render::ContributionBound sun =
            scene.context.worldBox ? around.sunlightIn(*scene.context.worldBox) : around.sunShadow;
        ParameterValues needed = values;
        occlusion(made, needed, heat, any);

        if (values[table.shadowMethod] == SdfShadow::none)
            plan.skip(named("self-shadow"),
                      whyOff(scene.context.values[table.shadowMethod] != SdfShadow::none, "the shadow method is none"));
        else if (!plan.includeIfEffective(
                     made, {named("self-shadow"),
                            render::boundOf(0, any * (1 + bounces), {{sun.absolute + own, sun.whyNone}})}))
            needed.set(table.shadowMethod, SdfShadow::none);
        if (!plan.includeIfEffective(
                made, {named("sunlight"), render::boundOf(0, any * (1 + bounces), {{sun.absolute, sun.whyNone}})}))
            made.shader.defines.emplace_back("SUNLESS");

        // Each surface after the first adds the light that it reflects, and the last one adds the light of the room.
        const double shaded = bounces > 0 ? bounces * (sun.absolute + own) : 0;
        const double reflected = around.probeLight.absolute + shaded;
        (void)plan.includeIfEffective(
            made, {named("bounces"), render::boundOf(0, any,
                                                     {{bounces > 0 ? 1.0 : 0.0, "no bounce is requested"},
                                                      {reflected, "there is no light to reflect"}})});
        made.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(needed);
    }

    [[nodiscard]] bool everywhere() const { return values[table.drawnOver] == SdfDrawnOver::picture; }
    /// Back faces of the box exist even if the camera is inside it.
    [[nodiscard]] render::Cull culled() const { return everywhere() ? render::Cull::none : render::Cull::front; }

    /// Returns the shader that writes only depth: its permutations are those of the body and the `needed` ones, so that
    /// one program serves any light.
    [[nodiscard]] render::DepthOnly depthOf(render::ShaderKey shader, const std::vector<std::string>& needed) const
    {
        shader.defines = scene.body.defines;
        shader.defines.insert(shader.defines.end(), needed.begin(), needed.end());
        shader.defines.emplace_back("DEPTH_ONLY");
        if (scene.body.sources) shader.programFamily += " depth";
        return {.shader = std::move(shader)};
    }

    [[nodiscard]] Pass marchPass(const char* step, std::string reason) const
    {
        Pass made = pass(step, std::move(reason), everywhere() ? "lib/fullscreen.vert" : "kit/sdf/box.vert",
                         "kit/sdf/march.frag");
        made.draws = {draw(everywhere() ? nullptr : boxMesh())};
        if (values[table.conePrepass]) {
            made.shader.defines.push_back(coneDefine());
            made.inputs.push_back({UNIT_EXHIBIT_A, coneImage()});
        }
        made.shader.defines.push_back(shadowDefine(scene));
        if (values[table.bounces] > 0) made.shader.defines.emplace_back("BOUNCES");
        if (scene.glass) made.shader.defines.emplace_back("GLASS");
        if (values[table.heatMap] != SdfHeatMap::none) made.shader.defines.emplace_back("HEAT_MAP");
        scene.context.bindLighting(made);
        if (scene.mirrors) scene.context.lighting.mirrorWorks(made);
        // The body shades itself by rays. The exhibits' shadow map contains the shadows of others.
        if (scene.context.alone)
            std::erase_if(made.inputs,
                          [](const render::SampledTexture& input) { return input.unit == UNIT_SHADOW_EXHIBITS; });
        else
            made.shader.defines.emplace_back("OTHERS_SHADOWS");
        effects(made);
        return made;
    }

    void march() const
    {
        Pass made = marchPass("march", "in view");
        made.variant = scene.body.variant;
        drawSurface(made, scene.context.channels.withoutCounts());
        made.state.cull = culled();
        made.state.depthClamp = true;
        std::vector<std::string> needed{"SHADOW_METHOD " + std::to_string(SHADOW_METHOD_NONE)};
        if (values[table.conePrepass]) needed.push_back(coneDefine());
        made.depthOnly = depthOf(made.shader, needed);
        for (const render::SampledTexture& input : made.inputs)
            if (input.unit == UNIT_EXHIBIT_A) made.depthOnly->inputs.push_back(input);
        if (scene.glass && values[table.heatMap] == SdfHeatMap::none) seeThrough(made, plan, scene.rough);
        plan.add(std::move(made));
    }

    void count() const
    {
        if (!scene.context.channels.evaluations) {
            plan.skip(named("count"), "no counts are requested");
            return;
        }
        // Rays that miss write nothing into the picture, so they are counted in a separate pass.
        Pass made = marchPass("count", "the evaluations channel is requested");
        made.phase = render::PassPhase::resolve;
        made.shader.defines.emplace_back("COUNT");
        made.colors = {Attachment::whole(evaluationsImage)};
        made.state = {.cull = culled(), .blend = render::Blend::add, .depthClamp = true};
        plan.add(std::move(made));
    }

    /// Returns whether the mesh is shown.
    [[nodiscard]] bool mesh(const render::Asset<render::Mesh>* found) const
    {
        if (values[table.shownAs] != SdfShown::mesh) {
            plan.skip(named("mesh"), "the field is shown");
            return false;
        }
        if (!found || !found->value) {
            plan.warn(named("mesh"), found ? found->failure.english() : "no mesh was made");
            return false;
        }
        Pass made = pass("mesh", "shown instead of the field", "kit/sdf/mesh.vert", "kit/sdf/mesh.frag");
        drawSurface(made, scene.context.channels.withoutCounts());
        scene.context.bindLighting(made);
        if (scene.mirrors) scene.context.lighting.mirrorWorks(made);
        made.draws = {draw(found->value)};
        made.depthOnly = depthOf(made.shader, {});
        plan.add(std::move(made));
        return true;
    }

    /// Plans the twelve edges of the box as thin bars.
    void overlay() const
    {
        if (!values[table.showBox]) {
            plan.skip(named("box"), "the overlay is switched off");
            return;
        }
        const bool clips = values[table.boxSize] < 1;
        render::Material glow;
        glow.baseColor = glm::vec4(0, 0, 0, 1);
        glow.emissive = clips ? glm::vec3(0.30F, 0.02F, 0.01F) : glm::vec3(0.34F, 0.13F, 0.02F);
        glow.metalness = 0;
        glow.roughness = 1;
        Pass made =
            surfacePass(named("box"), clips ? "the overlay is on; the box clips the object" : "the overlay is on",
                        scene.context.lighting, scene.context.channels.withoutCounts());
        const double thickness = 0.006 / glm::length(glm::dvec3(worldFromBody()[0]));
        const glm::dvec3 half = scene.box.halfSize();
        for (int axis = 0; axis < 3; ++axis) {
            for (int corner = 0; corner < 4; ++corner) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                glm::dvec3 center(0);
                glm::dvec3 size(thickness);
                size[axis] = half[axis] + thickness;
                center[u] = (corner & 1) != 0 ? half[u] : -half[u];
                center[v] = (corner & 2) != 0 ? half[v] : -half[v];
                const glm::dmat4 localFromBar =
                    glm::scale(glm::translate(glm::dmat4(1), scene.box.center() + center), size);
                made.draws.push_back(surfaceDraw(boxMesh(), worldFromBody() * localFromBar, glow));
            }
        }
        plan.add(std::move(made));
    }
};

}  // namespace

render::Pass sdfPass(const SdfScene& scene, const char* step, std::string reason, std::string vertex,
                     std::string fragment)
{
    Pass pass = exhibitPass(std::string(scene.exhibit) + '/' + step, std::move(reason), scene.body.values,
                            std::move(vertex), std::move(fragment));
    pass.shader.sources = scene.sources;
    if (scene.body.sources) pass.shader.programFamily = std::string(scene.exhibit) + '/' + step;
    pass.shader.defines = scene.body.defines;
    pass.blocks[BLOCK_EXHIBIT] = scene.body.block;
    pass.buffers = scene.body.buffers;
    return pass;
}

std::string shadowDefine(const SdfScene& scene)
{
    static_assert(SHADOW_METHOD_NONE == static_cast<int>(SdfShadow::none) &&
                  SHADOW_METHOD_HARD == static_cast<int>(SdfShadow::hard) &&
                  SHADOW_METHOD_CLASSIC == static_cast<int>(SdfShadow::classic) &&
                  SHADOW_METHOD_IMPROVED == static_cast<int>(SdfShadow::improved) &&
                  SHADOW_METHOD_SIGNED == static_cast<int>(SdfShadow::signedDistance) &&
                  SHADOW_METHOD_AREA == static_cast<int>(SdfShadow::area));
    return "SHADOW_METHOD " + std::to_string(static_cast<int>(scene.body.values[scene.table.shadowMethod]));
}

render::Draw sdfDraw(const SdfScene& scene, std::shared_ptr<const render::Mesh> mesh)
{
    const glm::dmat4 worldFromLocal = scene.context.worldFromExhibit * scene.body.exhibitFromBody;
    const glm::dmat3 linear(worldFromLocal);
    SdfObject object;
    object.worldFromLocal = glm::mat4(worldFromLocal);
    object.localFromWorld = glm::mat4(glm::affineInverse(worldFromLocal));
    object.boxLow = glm::vec3(scene.box.low);
    object.boxHigh = glm::vec3(scene.box.high);
    object.largestScale =
        static_cast<float>(std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])}));
    render::Draw draw;
    draw.mesh = std::move(mesh);
    draw.mirrored = isMirrored(worldFromLocal);
    draw.object = render::std140Bytes(object);
    return draw;
}

void planSdfShadow(const SdfScene& scene, render::FramePlan& plan)
{
    SdfPlanner{scene, plan}.shadow();
}

void planSdf(const SdfScene& scene, const render::Asset<render::Mesh>* mesh, render::FramePlan& plan)
{
    const SdfPlanner planner{scene, plan};
    if (planner.mesh(mesh)) {
        for (const char* step : {"cone", "march", "count"})
            plan.skip(planner.named(step), "a mesh is shown instead of the field");
    } else {
        planner.cone();
        planner.march();
        planner.count();
    }
    planner.overlay();
}

}  // namespace vitrine
