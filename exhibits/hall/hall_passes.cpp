#include "exhibits/hall/hall_scene.h"

#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace vitrine::hall {
namespace {

using render::Attachment;
using render::Draw;
using render::MeshInstance;
using render::Pass;

double turnAt(const HallScene& scene, int place)
{
    for (std::size_t i = 0; i < scene.exhibits.size() && i < scene.poses.size(); ++i)
        if (scene.exhibits[i].place == place) return scene.poses[i].rotation;
    return 0;
}

/// Returns what hangs at occupied places, rotated about its vertical axis by its current angle.
std::vector<MeshInstance> hanging(const HallScene& scene)
{
    std::vector<MeshInstance> parts;
    for (const auto& [number, place] : scene.model.places()) {
        if (!isOccupied(scene, number)) continue;
        for (MeshInstance part : place.hanging) {
            part.modelFromPart = glm::rotate(part.modelFromPart, turnAt(scene, number), glm::dvec3(0, 1, 0));
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

/// Returns the box around a part at any rotation about its vertical axis: world from a box from -1 to 1.
glm::dmat4 worldFromSwept(const MeshInstance& part)
{
    const render::Box& box = part.mesh->bounds;
    const glm::dvec2 reach =
        glm::max(glm::abs(glm::dvec2(box.low.x, box.low.z)), glm::abs(glm::dvec2(box.high.x, box.high.z)));
    const double radius = 1.01 * glm::length(reach);
    const double height = 0.5 * (box.high.y - box.low.y);
    return glm::scale(glm::translate(part.modelFromPart, glm::dvec3(0, box.low.y + height, 0)),
                      glm::dvec3(radius, 1.01 * height + 1e-3, radius));
}

std::string materialName(const MeshInstance& part)
{
    return part.material ? part.material->name : std::string();
}

void planButtons(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    Pass pass = surfacePass("hall/buttons", "", light, channels);
    int moving = 0;
    for (std::size_t i = 0; i < scene.exhibits.size(); ++i) {
        const ExhibitSlot& slot = scene.exhibits[i];
        const Place* place = slot.hasButton ? scene.model.place(slot.place) : nullptr;
        if (!place || !place->worldFromButton) continue;
        const glm::dvec3 at((*place->worldFromButton)[3]);
        if (!plan.view.mayContain({at - 0.06, at + 0.06})) continue;
        const double squash = i < scene.poses.size() ? buttonScale(scene.poses[i].sincePress) : 1;
        moving += squash < 1;
        const glm::dmat4 world = *place->worldFromButton * glm::scale(glm::dmat4(1), 0.035 * glm::dvec3(1, squash, 1));
        pass.draws.push_back(surfaceDraw(domeMesh(), world, redPaint()));
    }
    if (pass.draws.empty()) {
        plan.skip(pass.name, "no button is in view");
        return;
    }
    pass.reason = moving > 0 ? "a button was pressed" : "a button is in view";
    plan.add(std::move(pass));
}

/// Plans the shadow map with hangings that rotate. The map of the static parts is drawn once. When the hangings have
/// rotated, it is restored in their area, and they are drawn over it.
void planTurningShadow(const HallScene& scene, const Pass& still, const std::vector<MeshInstance>& turning,
                       render::FramePlan& plan)
{
    const auto follow = [&](const char* name, const char* reason, Attachment depth) {
        Pass pass;
        pass.name = name;
        pass.reason = reason;
        pass.phase = still.phase;
        pass.shader = {.vertex = "kit/depth.vert", .fragment = "hall/restore.frag"};
        pass.view = still.view;
        pass.depth = std::move(depth);
        pass.state = {
            .depthTest = render::DepthTest::none, .depthWrite = true, .cull = render::Cull::front, .depthClamp = true};
        pass.inputs = {{UNIT_SOURCE, std::string("shadow.hall.still")}};
        pass.contentHash = still.contentHash;
        pass.bound = still.bound;
        return pass;
    };
    Pass copy = follow("hall/shadow/copy", still.reason.c_str(), Attachment::cleared("shadow.hall"));
    copy.shader.vertex = "lib/fullscreen.vert";
    copy.state.cull = render::Cull::none;
    copy.draws = {Draw{}};

    render::Hash key;
    key.addValue(*still.contentHash);
    for (const ExhibitPose& pose : scene.poses) key.addValue(pose.rotation);
    Pass restore = follow("hall/shadow/restore", "the hanging objects have turned", Attachment::whole("shadow.hall"));
    restore.contentHash = key.value();
    Pass hangings = follow("hall/shadow/hangings", "the hanging objects have turned", Attachment::whole("shadow.hall"));
    hangings.contentHash = key.value();
    // The probe is kept when they rotate, so they must not be in its shadows: it is captured before they are drawn.
    restore.phase = hangings.phase = render::PassPhase::prepare;
    hangings.shader.fragment = "kit/depth.frag";
    hangings.state = still.state;
    hangings.inputs.clear();
    for (const MeshInstance& part : turning) {
        restore.draws.push_back(surfaceDraw(boxMesh(), worldFromSwept(part), {}));
        hangings.draws.push_back(partDraw(scene, part));
    }
    plan.add(still);
    for (Pass* pass : {&copy, &restore, &hangings}) plan.add(std::move(*pass));
}

/// Returns whether the pass shades opaque triangles of the picture and discards no fragment: each fragment nearer than
/// those before it is shaded.
bool isOpaqueSurface(const Pass& pass)
{
    const render::RasterState& state = pass.state;
    return pass.phase == render::PassPhase::opaque && pass.depth && pass.depth->image == depthImage &&
           !pass.colors.empty() && pass.colors.front().image == radianceImage && pass.depthOnly &&
           pass.depthOnly->shader.vertex == meshDepth().shader.vertex && state.depthWrite &&
           state.depthTest == render::DepthTest::nearer && state.blend == render::Blend::none &&
           state.depthBias == glm::vec2(0);
}

}  // namespace

const render::Material& redPaint()
{
    static const render::Material red = [] {
        render::Material m;
        m.baseColor = {0.62F, 0.035F, 0.025F, 1};
        m.metalness = 0;
        m.roughness = 0.28F;
        return m;
    }();
    return red;
}

std::vector<MeshInstance> standingParts(const HallScene& scene)
{
    std::vector<MeshInstance> parts;
    for (const auto& [number, place] : scene.model.places())
        for (const MeshInstance& part : isOccupied(scene, number) ? place.stand : place.cloth) parts.push_back(part);
    for (const OwnObject& object : scene.objects)
        if (object.plinth) parts.push_back(*object.plinth);
    return parts;
}

bool isOccupied(const HallScene& scene, int place)
{
    return std::any_of(scene.exhibits.begin(), scene.exhibits.end(),
                       [&](const ExhibitSlot& g) { return g.place == place; });
}

render::Draw partDraw(const HallScene& scene, const render::MeshInstance& part)
{
    const HallMaterial& material = scene.model.surfaces().material(materialName(part));
    if (part.name != "hall_brass") return surfaceDraw(part.mesh, part.modelFromPart, material.material, material.tile);
    render::Material lamp = material.material;
    lamp.emissive = glm::vec3(vaultLampsOf(scene.table, scene.values).radiance);
    return surfaceDraw(part.mesh, part.modelFromPart, lamp, material.tile);
}

double buttonScale(double seconds)
{
    constexpr double half = buttonTime / 2;
    if (!(seconds >= 0) || seconds >= buttonTime) return 1;
    const double t = seconds < half ? seconds / half : (buttonTime - seconds) / half;
    return 1 - 0.9 * t;
}

std::vector<MeshInstance> partsAt(const HallScene& scene, const Place& place)
{
    if (!isOccupied(scene, place.number)) return place.cloth;
    std::vector<MeshInstance> parts = place.stand;
    for (MeshInstance part : place.hanging) {
        part.modelFromPart = glm::rotate(part.modelFromPart, turnAt(scene, place.number), glm::dvec3(0, 1, 0));
        parts.push_back(std::move(part));
    }
    return parts;
}

void planHallShadow(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    if (!light.hallCastsShadow) {
        plan.skip("hall/shadow", scene.alone ? "there is no hall to cast it" : "sun shadows are switched off");
        return;
    }
    const int size = scene.values[scene.table.shadowMapSize];
    plan.image({.name = "shadow.hall",
                .format = render::Format::depth32f,
                .size = glm::ivec2(size),
                .persistent = true,
                .comparison = true});
    const std::vector<MeshInstance> turning = hanging(scene);
    if (!turning.empty())
        plan.image({.name = "shadow.hall.still",
                    .format = render::Format::depth32f,
                    .size = glm::ivec2(size),
                    .persistent = true,
                    .nearest = true});
    Pass pass;
    pass.name = "hall/shadow";
    pass.reason = "the sun or the walls have changed";
    pass.phase = render::PassPhase::shadow;
    pass.shader = meshDepth().shader;
    pass.view = light.hallShadowView;
    pass.depth = Attachment::cleared(turning.empty() ? "shadow.hall" : "shadow.hall.still");
    pass.state = {.depthTest = render::DepthTest::nearer,
                  .depthWrite = true,
                  .cull = render::Cull::none,
                  .depthBias = {1.5F, 2},
                  .depthClamp = true};
    pass.contentHash = lightKey(scene);
    pass.bound = light.sunShadow;
    for (const MeshInstance& part : scene.model.walls()) pass.draws.push_back(partDraw(scene, part));
    for (const MeshInstance& part : standingParts(scene)) pass.draws.push_back(partDraw(scene, part));
    for (const OwnObject& object : scene.objects)
        for (const MeshInstance& part : object.model->parts)
            pass.draws.push_back(surfaceDraw(part.mesh, object.worldFromModel * part.modelFromPart, {}));
    if (!turning.empty())
        planTurningShadow(scene, pass, turning, plan);
    else
        plan.add(std::move(pass));
}

void planWalls(const HallScene& scene, const SceneLighting& light, const Channels& channels, render::FramePlan& plan)
{
    Pass walls = surfacePass("hall/walls", "the hall is around the visitor", light, channels,
                             {"BASE_COLOR_MAP", "NORMAL_MAP", "SURFACE_MAP"}, render::Load::clear);
    walls.triangleSamples = scene.model.triangleSamples();
    if (scene.values[scene.table.bakedLight]) bindLightmaps(scene, light, walls);
    (void)plan.includeIfEffective(walls, {"hall/lamps", light.lampLight});
    for (const MeshInstance& part : scene.model.walls())
        if (!isFloor(part)) walls.draws.push_back(partDraw(scene, part));
    plan.add(std::move(walls));
    planFloor(scene, light, channels, plan);

    Pass props = surfacePass("hall/props", "cloths cover the empty places", light, channels,
                             {"BASE_COLOR_MAP", "NORMAL_MAP", "SURFACE_MAP"});
    props.state.cull = render::Cull::none;
    for (const std::vector<MeshInstance>& parts : {standingParts(scene), hanging(scene)})
        for (const MeshInstance& part : parts)
            if (plan.view.mayContain(part.mesh->bounds.transformed(part.modelFromPart)))
                props.draws.push_back(partDraw(scene, part));
    if (props.draws.empty())
        plan.skip(props.name, "no cloth or stand is in view");
    else
        plan.add(std::move(props));

    planOwnObjects(scene, light, channels, plan);
    planButtons(scene, light, channels, plan);
    planPlaques(scene, light, channels, plan);
}

void planSky(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    for (const std::string& note : scene.environmentNotes) plan.warn("hall/environment", note);
    Pass sky;
    sky.name = "sky";
    sky.reason = scene.alone ? "the environment is behind the exhibit" : "it may be seen through window and oculus";
    // Drawn last of the opaque passes; what is translucent is blended over it.
    sky.phase = render::PassPhase::opaque;
    sky.shader = {.vertex = "lib/fullscreen.vert", .fragment = "hall/sky.frag"};
    sky.colors = {Attachment::whole(radianceImage)};
    sky.depth = Attachment::whole(depthImage);
    sky.state.depthTest = render::DepthTest::nearerOrEqual;  // The triangle is at depth 0, the far plane.
    sky.draws = {Draw{}};
    light.bindLight(sky);
    // Shadows and reflections do not fall on the sky. Reading them here would keep them alive where no other pass does.
    std::erase_if(sky.inputs, [](const render::SampledTexture& input) { return input.unit != UNIT_ENVIRONMENT; });
    plan.add(std::move(sky));
}

void planHeatMap(const HallScene& scene, const SceneLighting& light, const FrameRequest& request,
                 render::FramePlan& plan)
{
    constexpr const char* name = "hall/overdraw";
    constexpr const char* fragments = "hall.overdraw";
    constexpr const char* depth = "hall.overdraw.depth";
    if (scene.values[scene.table.heatMap] == HallHeatMap::none) return plan.skip(name, "no heat map is shown");
    if (request.transparent || request.cutOut) return plan.skip(name, "a transparent background is requested");
    Pass count;
    count.name = name;
    count.reason = "the heat map shows how often each pixel is shaded";
    count.shader = {.vertex = meshDepth().shader.vertex, .fragment = "hall/overdraw.frag"};
    count.colors = {Attachment::cleared(fragments)};
    count.depth = Attachment::cleared(depth);
    count.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .blend = render::Blend::add};
    count.countSamples = true;
    for (const Pass& pass : plan.passes()) {
        if (!isOpaqueSurface(pass)) continue;
        for (Draw draw : pass.draws) {
            draw.cull = draw.cull.value_or(pass.state.cull);
            draw.inputs.clear();
            count.draws.push_back(std::move(draw));
        }
    }
    if (count.draws.empty()) return plan.skip(name, "no surface of triangles is in view");
    plan.image({.name = fragments, .format = render::Format::r32f, .nearest = true});
    plan.image({.name = depth, .format = render::Format::depth32f});
    plan.add(std::move(count));
    Pass show = exhibitPass("hall/overdraw/map", "a heat map covers the picture", scene.values, "lib/fullscreen.vert",
                            "hall/heat_map.frag");
    show.phase = render::PassPhase::resolve;
    show.blocks[BLOCK_LIGHT] = render::std140Bytes(light.light);  // For the exposure.
    show.inputs = {{UNIT_SOURCE, std::string(fragments)}};
    show.colors = {Attachment::whole(radianceImage)};
    show.draws = {Draw{}};
    plan.add(std::move(show));
}

}  // namespace vitrine::hall
