#include "exhibits/sdf_morph/sdf_morph.h"

#include "exhibits/framework/derive.h"
#include "exhibits/kit/surface_draw.h"
#include "exhibits/sdf_morph/sdf_shape.h"
#include "render/scene/held_bytes.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using render::Attachment;
using render::Load;
using render::Pass;

constexpr int blockOfCone =
    8;  ///< Pixels along a side of the block that one cone covers; shaders/sdf_morph/cone.frag agrees.

struct PreparedMesh final : PreparedPart {
    render::Asset<render::Mesh> mesh;
};

/// Everything that the passes of one frame share.
struct Scene {
    const SdfMorphTable& table;
    const PlanContext& context;
    ParameterValues values;  ///< With the morph as animated.
    SdfMoment moment;
    render::Box box;  ///< The rays are marched in it.
    SdfObject object;

    [[nodiscard]] render::Draw proxy() const
    {
        render::Draw draw;
        draw.mesh = boxMesh();
        draw.mirrored = glm::determinant(glm::dmat3(context.worldFromExhibit)) < 0;
        draw.object = render::bytesOf(object);
        return draw;
    }
    [[nodiscard]] Pass pass(std::string name, std::string reason, std::string vertex, std::string fragment) const
    {
        Pass pass;
        pass.name = "sdf_morph/" + name;
        pass.reason = std::move(reason);
        pass.shader = {std::move(vertex), std::move(fragment), "", {}, derive::uniformBlock(table)};
        pass.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
        return pass;
    }
};

/// The sun's own rays find the object, and write where they did: its shadow has its true outline.
void planShadow(const Scene& s, render::FramePlan& plan)
{
    if (!s.context.noShadowBecause.empty()) {
        plan.skip("sdf_morph/shadow", s.context.noShadowBecause);
        return;
    }
    Pass pass = s.pass("shadow", "the sun reaches it and its shadow may be seen", "sdf_morph/proxy.vert",
                       "sdf_morph/shadow.frag");
    pass.stage = render::Stage::shadow;
    pass.view = s.context.surroundings.exhibitShadowView;
    pass.key = s.context.surroundings.exhibitShadowKey;
    pass.bound = s.context.surroundings.sunShadow;
    pass.depth = Attachment{exhibitShadowImage, Load::keep, {}, -1, 0};
    pass.state = {
        .depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::front, .depthClamp = true};
    pass.draws = {s.proxy()};
    plan.add(std::move(pass));
}

void planCone(const Scene& s, render::FramePlan& plan)
{
    if (!s.values[s.table.conePrepass]) {
        plan.skip("sdf_morph/cone", "the cone pre-pass is switched off");
        return;
    }
    // Blocks lie on the grid of the whole picture, so that tiles join to the bit: a tile may begin within one.
    const render::Raster& raster = plan.view.raster;
    const glm::ivec2 blocks = (raster.offset % blockOfCone + raster.drawn() + blockOfCone - 1) / blockOfCone;
    plan.image({.name = "sdf_morph.cone",
                .format = render::Format::rgba32f,
                .size = glm::max(blocks, glm::ivec2(1)),
                .nearest = true});
    Pass pass =
        s.pass("cone", "it saves every ray the way to the object", "lib/fullscreen.vert", "sdf_morph/cone.frag");
    pass.stage = render::Stage::prepare;
    pass.colors = {{"sdf_morph.cone", Load::clear, {}, -1, 0}};
    pass.draws = {render::Draw{}};
    pass.draws[0].object = render::bytesOf(s.object);
    plan.add(std::move(pass));
}

/// What the shading does beside the plain surface; the values are left as what is called for.
void planEffects(const Scene& s, Pass& pass, ParameterValues& values, render::FramePlan& plan)
{
    const SdfMorphTable& table = s.table;
    const Surroundings& around = s.context.surroundings;
    const bool glass = values[table.material] == SdfMaterial::glass;
    const bool heat = values[table.heatMap] != SdfHeatMap::none;
    // A heat map shows what the effects cost, which no light bounds.
    const double any = heat ? std::numeric_limits<double>::infinity() : 1;
    const int bounces = values[table.bounces];

    if (!values[table.ambientOcclusion])
        plan.skip("sdf_morph/occlusion", "ambient occlusion is switched off");
    else if (!plan.needs(
                 pass, {"sdf_morph/occlusion",
                        render::boundOf(any, 0,
                                        {{glass && !heat ? 0.0 : 1.0, "glass scatters nothing of the room's light"}})}))
        values.set(table.ambientOcclusion, false);

    if (values[table.shadowMethod] == SdfShadow::none)
        plan.skip("sdf_morph/self-shadow", "the shadow method is none");
    else if (!plan.needs(pass, {"sdf_morph/self-shadow",
                                render::boundOf(0, any * (1 + bounces),
                                                {{around.sunShadow.radiance, around.sunShadow.whyNone}})}))
        values.set(table.shadowMethod, SdfShadow::none);

    // Beyond the first surface, each one adds its own light, and the last one the room's.
    const double reflected = around.probeLight.radiance + bounces * around.sunShadow.radiance;
    (void)plan.needs(pass, {"sdf_morph/bounces", render::boundOf(0, any,
                                                                 {{bounces > 0 ? 1.0 : 0.0, "no bounce is asked for"},
                                                                  {reflected, "there is no light to reflect"}})});
    pass.blocks[BLOCK_PARAMETERS] = derive::uniformBytes(values);
}

Pass marchPass(const Scene& s, const char* name, std::string reason, render::FramePlan& plan)
{
    Pass pass = s.pass(name, std::move(reason), "sdf_morph/proxy.vert", "sdf_morph/march.frag");
    pass.draws = {s.proxy()};
    // Back faces: they are there even when the camera is inside the box.
    pass.state = {
        .depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::front, .depthClamp = true};
    if (s.values[s.table.conePrepass]) {
        pass.shader.defines.emplace_back("CONE_PREPASS");
        pass.inputs.push_back({UNIT_EXHIBIT_A, std::string("sdf_morph.cone")});
    }
    if (s.values[s.table.material] == SdfMaterial::glass) pass.shader.defines.emplace_back("GLASS");
    if (s.values[s.table.heatMap] != SdfHeatMap::none) pass.shader.defines.emplace_back("HEAT_MAP");
    s.context.surroundings.illuminate(pass);
    // It shades itself by rays of its own; the exhibits' shadow map is for what others keep from it.
    if (s.context.alone)
        std::erase_if(pass.inputs, [](const render::Input& input) { return input.unit == UNIT_SHADOW_EXHIBITS; });
    else
        pass.shader.defines.emplace_back("OTHERS_SHADOWS");
    ParameterValues values = s.values;
    planEffects(s, pass, values, plan);
    return pass;
}

void planMarch(const Scene& s, render::FramePlan& plan)
{
    Pass march = marchPass(s, "march", "in view", plan);
    march.colors = {{radianceImage, Load::keep, {}, -1, 0}};
    march.depth = Attachment{depthImage, Load::keep, {}, -1, 0};
    if (s.context.channels.normal) {
        march.shader.defines.emplace_back("WRITE_NORMAL");
        march.colors.push_back({normalImage, Load::keep, {}, -1, 0});
    }
    plan.add(std::move(march));

    if (!s.context.channels.evaluations) {
        plan.skip("sdf_morph/count", "nobody asks for counts");
        return;
    }
    // Rays that miss leave nothing in the picture, so they are counted in a pass of their own.
    Pass count = marchPass(s, "count", "the evaluations channel is asked for", plan);
    count.stage = render::Stage::resolve;
    count.shader.defines.emplace_back("COUNT");
    count.colors = {{evaluationsImage, Load::keep, {}, -1, 0}};
    count.state = {.cull = render::Cull::front, .blend = render::Blend::add, .depthClamp = true};
    plan.add(std::move(count));
}

render::Material materialOf(const Scene& s)
{
    render::Material material;
    material.baseColor = glm::vec4(glm::vec3(s.values[s.table.baseColor].value), 1);
    material.metalness = static_cast<float>(s.values[s.table.metalness]);
    material.roughness = static_cast<float>(s.values[s.table.roughness]);
    return material;
}

Pass meshPass(const Scene& s, const char* name, std::string reason, std::vector<std::string> defines)
{
    Pass pass;
    pass.name = std::string("sdf_morph/") + name;
    pass.reason = std::move(reason);
    pass.shader = {"hall/surface.vert", "hall/surface.frag", "", std::move(defines), {}};
    pass.colors = {{radianceImage, Load::keep, {}, -1, 0}};
    if (s.context.channels.normal) {
        pass.shader.defines.emplace_back("WRITE_NORMAL");
        pass.colors.push_back({normalImage, Load::keep, {}, -1, 0});
    }
    pass.depth = Attachment{depthImage, Load::keep, {}, -1, 0};
    pass.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::back};
    s.context.surroundings.illuminate(pass);
    return pass;
}

void planMesh(const Scene& s, std::shared_ptr<const render::Mesh> mesh, float wipe, render::FramePlan& plan)
{
    Pass pass = meshPass(s, "mesh", "compared with the marched object", {"WIPE"});
    render::Draw draw = surfaceDraw(std::move(mesh), s.context.worldFromExhibit, materialOf(s));
    SurfaceObject object = surfaceObject(s.context.worldFromExhibit, materialOf(s));
    object.wipeColumn = wipe;
    object.specular = static_cast<float>(s.values[s.table.specular]);
    draw.object = render::std140Bytes(object);
    pass.draws = {std::move(draw)};
    plan.add(std::move(pass));
}

/// The twelve edges of the box, as thin bars.
void planOverlay(const Scene& s, render::FramePlan& plan)
{
    if (!s.values[s.table.showBox]) {
        plan.skip("sdf_morph/box", "the overlay is switched off");
        return;
    }
    const bool clips = s.values[s.table.boxSize] < 1;
    render::Material glow;
    glow.baseColor = glm::vec4(0, 0, 0, 1);
    glow.emissive = clips ? glm::vec3(0.30F, 0.02F, 0.01F) : glm::vec3(0.34F, 0.13F, 0.02F);
    glow.metalness = 0;
    glow.roughness = 1;
    Pass pass = meshPass(s, "box", clips ? "the overlay is on; the box clips the object" : "the overlay is on", {});
    const double thickness = 0.006 / glm::length(glm::dvec3(s.context.worldFromExhibit[0]));
    const glm::dvec3 half = s.box.halfSize();
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 center(0);
            glm::dvec3 size(thickness);
            size[axis] = half[axis] + thickness;
            center[(axis + 1) % 3] = (corner & 1) != 0 ? half[(axis + 1) % 3] : -half[(axis + 1) % 3];
            center[(axis + 2) % 3] = (corner & 2) != 0 ? half[(axis + 2) % 3] : -half[(axis + 2) % 3];
            const glm::dmat4 world =
                s.context.worldFromExhibit * glm::scale(glm::translate(glm::dmat4(1), s.box.center() + center), size);
            pass.draws.push_back(surfaceDraw(boxMesh(), world, glow));
        }
    }
    plan.add(std::move(pass));
}

}  // namespace

double morphAt(double morph, double speed, double time)
{
    if (time == 0 || !std::isfinite(time)) return morph;
    // Phase on a triangle wave of period 2 that starts at `morph`; the remainder is exact at any time.
    const double phase = std::fmod(morph + std::fmod(2 * speed * time, 2.0), 2.0);
    const double positive = phase < 0 ? phase + 2 : phase;
    return positive <= 1 ? positive : 2 - positive;
}

render::Box SdfMorph::bounds(const ParameterValues& values) const
{
    const SdfMoment moment{table_, values, values[table_.morph]};
    return resized(values[table_.animate] ? boxOverMorph(moment) : momentaryBox(moment), values[table_.boxSize]);
}

ParameterValues SdfMorph::melted(const ParameterValues& values, double time) const
{
    ParameterValues now = values;
    if (values[table_.animate]) now.set(table_.morph, morphAt(values[table_.morph], values[table_.speed], time));
    return now;
}

std::shared_ptr<const PreparedPart> SdfMorph::prepare(const PrepareContext& context) const
{
    if (!context.seen || !context.values[table_.compareMesh]) return nullptr;
    const ParameterValues values = melted(context.values, context.time);
    const auto& t = table_;
    const std::string key = derive::keyOf(values, {t.morph.row, t.majorRadius.row, t.minorRadius.row, t.mugRadius.row,
                                                   t.mugHeight.row, t.wallThickness.row, t.handleRadius.row,
                                                   t.handleThickness.row, t.blend.row, t.tessellation.row});
    auto part = std::make_shared<PreparedMesh>();
    part->mesh = context.assets.made<render::Mesh>("sdf_morph.mesh", key, [&] {
        auto mesh = meshOf({table_, values, values[t.morph]}, values[t.tessellation]);
        const std::uint64_t bytes = heldBytes(*mesh);
        return render::AssetStore::Made<render::Mesh>{std::move(mesh), bytes};
    });
    return part;
}

double SdfMorph::firstHit(const ExhibitState& state, const render::Ray& ray) const
{
    const ParameterValues values = melted(state.values, state.time);
    return firstHitOf({table_, values, values[table_.morph]}, ray);
}

render::Camera SdfMorph::bestView(const ParameterValues& values) const
{
    const double reach = glm::length(boxOverMorph({table_, values, values[table_.morph]}).halfSize());
    return {glm::dvec3(0.70, 0.19, 1.22) * (reach / 0.75), {0.04, -0.02, 0}, 0.698132};
}

double SdfMorph::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] && values[table_.speed] > 0 ? 0 : std::numeric_limits<double>::infinity();
}

bool SdfMorph::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

std::vector<StudyView> SdfMorph::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    ParameterValues mug = still;
    mug.set(table_.morph, 1.0);
    ParameterValues torus = still;
    torus.set(table_.morph, 0.0);
    const render::Camera best = bestView(values);
    const double size = glm::length(best.eye);
    const auto from = [&](glm::dvec3 direction, double distance) {
        return render::Camera{best.target + glm::normalize(direction) * (size * distance), best.target, best.fovY};
    };
    // Rays that graze the lip and the inside of the wall take the most steps; a torus edge-on hides its hole.
    return {{"best view", best, 0, still},
            {"into the mug, along its wall", from({0.25, 0.62, 0.45}, 0.75), 0, mug},
            {"the torus, nearly edge-on", from({1.0, 0.06, 0.10}, 0.8), 0, torus},
            {"the handle, from near", from({0.9, 0.1, 0.35}, 0.5), 0, mug},
            {"melting, from behind", from({-0.6, 0.3, -1.0}, 0.9), 0, still}};
}

void SdfMorph::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const ParameterValues values = melted(context.values, context.time);
    const SdfMoment moment{table_, values, values[table_.morph]};
    const render::Box box = resized(momentaryBox(moment), values[table_.boxSize]);
    Scene scene{table_, context,
                values, {table_, values, values[table_.morph]},
                box,    sdfObject(moment, box, context.worldFromExhibit)};

    planShadow(scene, plan);
    if (!context.hiddenBecause.empty()) {
        for (const char* pass : {"sdf_morph/cone", "sdf_morph/march", "sdf_morph/mesh", "sdf_morph/box"})
            plan.skip(pass, context.hiddenBecause);
        return;
    }
    const bool compare = values[table_.compareMesh];
    const auto wipe = static_cast<float>(values[table_.wipe] * plan.view.raster.size.x);
    if (compare) {
        scene.object.wipe.x = wipe;
        const render::Asset<render::Mesh>& found = static_cast<const PreparedMesh&>(*context.prepared).mesh;
        if (found.value)
            planMesh(scene, found.value, wipe, plan);
        else
            plan.complain("sdf_morph/mesh", found.failure);
    } else {
        plan.skip("sdf_morph/mesh", "the comparison is switched off");
    }
    planCone(scene, plan);
    planMarch(scene, plan);
    planOverlay(scene, plan);
}

}  // namespace vitrine
