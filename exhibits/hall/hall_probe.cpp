#include "exhibits/hall/hall_scene.h"

#include "exhibits/kit/surface_draw.h"
#include "render/glsl/std140.h"
#include "render/hash.h"
#include "render/scene/cube_views.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <bit>

namespace vitrine {
namespace {

using render::Attachment;
using render::Pass;

#include "shaders/hall/probe_block.glsl"

constexpr int smallestFace = 4;  ///< Texels along a face of the roughest level.

Pass capturePass(const char* what, int face, const glm::dvec3& eye, int size, std::uint64_t key)
{
    Pass pass;
    pass.name = std::string("probe/") + what + "/" + std::to_string(face);
    pass.reason = "what the probe sees has changed";
    pass.phase = render::PassPhase::probe;
    pass.view = render::cubeFaceView(eye, face, size);
    pass.key = key;
    return pass;
}

/// The probe must not read itself while it is being made; and it holds the hall alone, for its key does not tell where
/// the exhibits' shadows lie, nor which lamps a view reckons with.
SceneLighting lightOfHallAlone(const SceneLighting& light, const std::optional<render::LocalLighting>& lamps)
{
    SceneLighting hallLight = light;
    hallLight.light.exhibitsCastShadow = false;
    hallLight.glassCastsShadow = false;
    hallLight.localLights = lamps;
    std::erase_if(hallLight.inputs, [](const render::SampledTexture& input) {
        return input.unit == UNIT_PROBE || input.unit == UNIT_PROBE_IRRADIANCE || input.unit == UNIT_SHADOW_EXHIBITS ||
               input.unit == UNIT_SHADOW_GLASS;
    });
    return hallLight;
}

std::vector<render::Draw> wallDraws(const HallScene& scene)
{
    std::vector<render::Draw> draws;
    for (const render::MeshInstance& part : scene.model.walls()) draws.push_back(partDraw(scene, part));
    return draws;
}

void planFace(const HallScene& scene, const SceneLighting& hallLight, const std::vector<render::Draw>& draws, int face,
              int size, std::uint64_t key, render::FramePlan& plan)
{
    const glm::dvec3 eye = probePosition(scene);
    Pass sky = capturePass("sky", face, eye, size, key);
    sky.shader = {.vertex = "lib/fullscreen.vert", .fragment = "hall/sky.frag", .defines = {"CAPTURE"}};
    sky.colors = {Attachment::slice("probe.captured", face)};
    sky.draws = {render::Draw{}};
    sky.bound = hallLight.probeLight;
    hallLight.bindLighting(sky);
    if (scene.alone && face == 5) sky.mipmaps = {"probe.captured"};
    plan.add(std::move(sky));
    if (scene.alone) return;

    Pass walls = capturePass("walls", face, eye, size, key);
    walls.bound = hallLight.probeLight;
    walls.shader = {.vertex = "kit/surface.vert",
                    .fragment = "kit/surface.frag",
                    .defines = {"BASE_COLOR_MAP", "ORM_MAP", "FLAT_PROBE"}};
    walls.colors = {Attachment::slice("probe.captured", face)};
    walls.depth = Attachment::cleared("probe.depth");
    walls.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::none};
    walls.draws = draws;
    bindLightmaps(scene, hallLight, walls);
    hallLight.bindLighting(walls);
    if (face == 5) walls.mipmaps = {"probe.captured"};
    plan.add(std::move(walls));
}

void planLevel(int level, int levels, int size, int samples, const render::ContributionBound& bound, std::uint64_t key,
               render::FramePlan& plan)
{
    const int side = std::max(size >> level, 1);
    const float t = levels > 1 ? static_cast<float>(level) / static_cast<float>(levels - 1) : 0.0F;
    Pass pass;
    pass.name = "probe/blur/" + std::to_string(level);
    pass.reason = "what the probe sees has changed";
    pass.phase = render::PassPhase::prepare;
    pass.work = render::Work::compute;
    pass.shader = {.compute = "hall/probe_prefilter.comp"};
    pass.storage = {{.image = "probe", .level = level}};
    pass.inputs = {{UNIT_SOURCE, std::string("probe.captured")}};
    // Level follows the square root of roughness (lib/light.glsl), so roughness is its square.
    pass.blocks[BLOCK_OBJECT] =
        render::std140Bytes(ProbeLevel{.roughness = t * t, .samples = level == 0 ? 1 : samples, .capturedSize = size});
    pass.groups = {(side + 7) / 8, (side + 7) / 8, 6};
    pass.bound = bound;
    pass.key = key;
    plan.add(std::move(pass));
}

}  // namespace

int probeLevels(int size)
{
    const auto width = [](int n) { return static_cast<int>(std::bit_width(static_cast<unsigned>(n))); };
    return std::max(width(size) - width(smallestFace) + 1, 1);
}

glm::dvec3 probePosition(const HallScene& scene)
{
    return scene.alone ? glm::dvec3(0) : scene.model.probe();
}

std::optional<render::LocalLighting> probeLamps(const HallScene& scene)
{
    std::vector<render::LocalLight> lamps = scene.steadyLamps;
    for (render::LocalLight& lamp : lamps) lamp.castsShadow = false;
    render::LocalLighting lighting =
        render::localLighting(lamps, probePosition(scene), 2 * glm::length(scene.model.bounds().halfSize()));
    if (lighting.chosen.empty()) return std::nullopt;
    return lighting;
}

void planProbe(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    if (!scene.values[scene.table.reflectionProbe]) {
        plan.skip("probe", "the reflection probe is switched off");
        return;
    }
    if (!plan.includeIfEffective(light.probeLight, {"probe"})) return;
    const int size = scene.values[scene.table.probeSize];
    const int levels = probeLevels(size);
    const std::optional<render::LocalLighting> lamps = probeLamps(scene);
    const render::Bytes ofLamps = lamps ? render::std140Bytes(lamps->block) : render::Bytes();
    const std::uint64_t key = render::Hash()
                                  .addValue(lightKey(scene))
                                  .add({reinterpret_cast<const char*>(ofLamps.data()), ofLamps.size()})
                                  .value();
    const int allLevels = static_cast<int>(std::bit_width(static_cast<unsigned>(size)));
    plan.image({.name = "probe.captured",
                .format = render::Format::rgba16f,
                .type = render::TextureType::cube,
                .size = glm::ivec2(size),
                .levels = allLevels,
                .persistent = true});
    plan.image({.name = "probe",
                .format = render::Format::rgba16f,
                .type = render::TextureType::cube,
                .size = glm::ivec2(size),
                .levels = levels,
                .persistent = true});
    plan.image({.name = "probe.irradiance",
                .format = render::Format::rgba32f,
                .size = {9, 1},
                .persistent = true,
                .nearest = true});
    if (!scene.alone)
        plan.image(
            {.name = "probe.depth", .format = render::Format::depth32f, .size = glm::ivec2(size), .persistent = true});
    const SceneLighting hallLight = lightOfHallAlone(light, lamps);
    const std::vector<render::Draw> walls = scene.alone ? std::vector<render::Draw>() : wallDraws(scene);
    for (int face = 0; face < 6; ++face) planFace(scene, hallLight, walls, face, size, key, plan);
    for (int level = 0; level < levels; ++level)
        planLevel(level, levels, size, scene.values[scene.table.probeSamples], light.probeLight, key, plan);

    // A level of 16 texels holds all that nine coefficients can tell.
    const int level = std::max(allLevels - 5, 0);
    Pass sum;
    sum.name = "probe/irradiance";
    sum.reason = "what the probe sees has changed";
    sum.phase = render::PassPhase::prepare;
    sum.work = render::Work::compute;
    sum.shader = {.compute = "hall/probe_irradiance.comp"};
    sum.storage = {Attachment::whole("probe.irradiance")};
    sum.inputs = {{UNIT_SOURCE, std::string("probe.captured")}};
    sum.blocks[BLOCK_OBJECT] =
        render::std140Bytes(ProbeLevel{.capturedLevel = level, .capturedSize = std::max(size >> level, 1)});
    sum.key = key;
    sum.bound = light.probeLight;
    plan.add(std::move(sum));
}

}  // namespace vitrine
