#include "exhibits/hall/hall_scene.h"

#include "exhibits/hall/sun.h"
#include "exhibits/kit/surface_draw.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>

namespace vitrine::hall {
namespace {

#include "shaders/hall/air_light_block.glsl"
#include "shaders/hall/bounce_block.glsl"

using render::Attachment;
using render::Pass;

constexpr const char* bouncedAirImage = "light.bounced.air";
constexpr const char* airImage = "light.air";
constexpr const char* chartsImage = "light.bounced.charts";
constexpr const char* bouncedImage = "light.bounced";
constexpr const char* airPass = "hall/bounced light in the air";
constexpr const char* wallsPass = "hall/bounced light";
constexpr const char* edgesPass = "hall/bounced light/edges";

Pass keptPass(const char* name, const SceneLighting& light, const render::Hash& key)
{
    Pass pass;
    pass.name = name;
    pass.reason = "the sun has moved";
    pass.phase = render::PassPhase::shadow;
    pass.bound = light.bouncedLight;
    pass.contentHash = key.value();
    return pass;
}

/// Completes a pass that writes the six sides of all points in the air.
void fillAir(const char* image, const char* shader, const SunTransfer& transfer, Pass& pass, render::FramePlan& plan)
{
    const glm::ivec3 size = transfer.grid().size;
    plan.image({.name = image,
                .type = render::TextureType::volume,
                .size = glm::ivec2(size),
                .layers = 6 * size.z,
                .persistent = true});
    pass.work = render::Work::compute;
    pass.shader = {.compute = shader};
    pass.storage = {Attachment::whole(image)};
    pass.inputs = {{UNIT_SOURCE, transfer.picture()}};
    pass.groups = {(size.x + 3) / 4, (size.y + 3) / 4, (6 * size.z + 3) / 4};
}

void planAir(const SunTransfer& transfer, const std::vector<SunTransfer::Source>& sources, Pass pass,
             render::FramePlan& plan)
{
    BounceBlock block;
    block.size = transfer.grid().size;
    block.sources = static_cast<int>(std::min(sources.size(), block.shining.size()));
    for (std::size_t i = 0; i < sources.size() && i < block.shining.size(); ++i)
        block.shining[i] = glm::vec4(sources[i].row, sources[i].light * transfer.scale(sources[i].row), 0, 0);
    const std::size_t tint = transfer.sourceCount() + 3;
    block.tintRow = static_cast<int>(tint);
    block.tintScale = glm::vec3(transfer.scale(tint), transfer.scale(tint + 1), transfer.scale(tint + 2));
    fillAir(bouncedAirImage, "hall/bounced_air.comp", transfer, pass, plan);
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    plan.add(std::move(pass));
}

}  // namespace

std::vector<SunTransfer::Source> bounceOf(const HallScene& scene)
{
    const Sun sun = sunOf(scene.table, scene.values);
    return scene.model.surfaces().lightmaps().sun.at(sun.azimuth, sun.elevation);
}

render::ContributionBound boundOfBounce(const HallScene& scene, double most)
{
    if (scene.alone) return render::boundOf(0, 1, {{0.0, "there is no hall to bounce it"}});
    const Sun sun = sunOf(scene.table, scene.values);
    return render::boundOf(0, sun.strength * scene.model.surfaces().lightmaps().sun.surfaceScale(),
                           {{sun.strength, sun.elevation > 0 ? "the sun's strength is 0" : "the sun has set"},
                            {most, "too little sunlight comes in through window and oculus"}});
}

void planBouncedLight(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    if (!plan.includeIfEffective(light.bouncedLight, {wallsPass}) || scene.alone) return;
    const SunTransfer& transfer = scene.model.surfaces().lightmaps().sun;
    const std::vector<SunTransfer::Source> sources = bounceOf(scene);
    render::Hash key;
    for (const SunTransfer::Source& source : sources) key.addValue(source.row).addValue(source.light);
    planAir(transfer, sources, keptPass(airPass, light, key), plan);

    const glm::ivec2 size(transfer.surfaces()->width, transfer.surfaces()->height);
    plan.image({.name = chartsImage, .size = size, .persistent = true, .nearest = true});
    plan.image({.name = bouncedImage, .size = size, .persistent = true});
    AirOnWalls block;
    block.low = glm::vec3(transfer.grid().box.low);
    block.high = glm::vec3(transfer.grid().box.high);
    block.scale = static_cast<float>(transfer.surfaceScale());
    Pass walls = keptPass(wallsPass, light, key);
    walls.shader = {.vertex = "hall/lightmap.vert", .fragment = "hall/bounced_light.frag"};
    walls.colors = {Attachment::cleared(chartsImage)};
    walls.inputs = {{UNIT_EXHIBIT_A, std::string(bouncedAirImage)}, {UNIT_SOURCE, transfer.surfaces()}};
    walls.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    for (const render::MeshInstance& part : scene.model.walls())
        walls.draws.push_back(surfaceDraw(part.mesh, part.modelFromPart, {}));
    plan.add(std::move(walls));

    Pass edges = keptPass(edgesPass, light, key);
    edges.shader = {.vertex = "lib/fullscreen.vert", .fragment = "hall/lightmap_edges.frag"};
    edges.colors = {Attachment::cleared(bouncedImage)};
    edges.inputs = {{UNIT_SOURCE, std::string(chartsImage)}};
    edges.draws = {render::Draw{}};
    plan.add(std::move(edges));
}

void lookUpAirLight(const HallScene& scene, SceneLighting& light)
{
    if (scene.alone) return;
    const render::Box& box = scene.model.surfaces().lightmaps().sun.grid().box;
    light.light.hasAirLight = true;
    light.light.airLow = glm::vec3(box.low);
    light.light.airHigh = glm::vec3(box.high);
    light.inputs.push_back({UNIT_AIR_LIGHT, std::string(airImage)});
}

void planAirLight(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    const bool forProbe = light.light.hasProbe && !scene.alone;
    if (!light.light.hasAirLight && !forProbe) {
        plan.skip("hall/light in the air", scene.alone ? "there is no hall" : "baked light is switched off");
        return;
    }
    const SunTransfer& transfer = scene.model.surfaces().lightmaps().sun;
    const std::size_t row = transfer.sourceCount();
    AirLightBlock block;
    block.size = transfer.grid().size;
    block.skyRow = static_cast<int>(row);
    // The sky counts as one color here, as on the walls (kit/surface.frag).
    block.sky = glm::mix(light.light.skyHorizon, light.light.skyZenith, 0.4F) *
                glm::vec3(transfer.scale(row), transfer.scale(row + 1), transfer.scale(row + 2));
    block.sun = light.light.sunIrradiance;
    const LampLight& lamps = scene.model.surfaces().lightmaps().lamps;
    block.lamps = glm::vec3(vaultLampsOf(scene.table, scene.values).radiance * lamps.airScale());
    render::Hash key;
    for (const glm::vec3& color : {block.sky, block.sun, block.lamps})
        key.addValue(color.x).addValue(color.y).addValue(color.z);
    if (light.hasBouncedLight)
        for (const SunTransfer::Source& source : bounceOf(scene)) key.addValue(source.row).addValue(source.light);
    Pass pass;
    pass.name = "hall/light in the air";
    pass.reason = "sun, sky or lamps have changed";
    pass.phase = render::PassPhase::shadow;
    pass.contentHash = key.value();
    fillAir(airImage, "hall/air_light.comp", transfer, pass, plan);
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    if (light.hasBouncedLight) {
        pass.shader.defines.emplace_back("BOUNCED_LIGHT");
        pass.inputs.push_back({UNIT_EXHIBIT_A, std::string(bouncedAirImage)});
    }
    if (light.hasLampLight) {
        pass.shader.defines.emplace_back("LAMP_LIGHT");
        pass.inputs.push_back({UNIT_EXHIBIT_B, lamps.air()});
    }
    plan.add(std::move(pass));
}

void bindLightmaps(const HallScene& scene, const SceneLighting& light, render::Pass& pass)
{
    pass.shader.defines.emplace_back("LIGHTMAP");
    pass.inputs.push_back({UNIT_SKY_LIGHTMAP, scene.model.surfaces().lightmaps().sky});
    if (light.hasLampLight) pass.shader.defines.emplace_back("LAMP_LIGHT");
    if (!light.hasBouncedLight) return;
    pass.shader.defines.emplace_back("BOUNCED_LIGHT");
    pass.inputs.push_back({UNIT_BOUNCED_LIGHT, std::string(bouncedImage)});
}

}  // namespace vitrine::hall
