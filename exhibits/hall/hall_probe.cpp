#include "exhibits/hall/hall_scene.h"

#include "exhibits/kit/surface_draw.h"
#include "render/glsl/std140.h"
#include "render/hash.h"
#include "render/scene/cube_views.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace vitrine::hall {
namespace {

using render::Attachment;
using render::Pass;

#include "shaders/hall/probe_block.glsl"

constexpr int smallestFace = 4;  ///< Texels along a face of the mip level for the highest roughness.

/// Sizes of a captured cube, the hash of what it contains, and why its passes run.
struct ProbeCapture {
    int size = 0;            ///< Texels along a side of a face.
    int capturedLevels = 0;  ///< Number of levels of what is drawn.
    int levels = 0;          ///< Number of blurred levels.
    int samples = 0;         ///< Samples of each texel of a blurred level.
    std::uint64_t key = 0;
    const char* reason = "what the probe sees has changed";
};

/// Returns the sizes of both cubes, those of the hall and of the works.
ProbeCapture captureOf(const HallScene& scene)
{
    const int size = scene.values[scene.table.probeSize];
    return {.size = size,
            .capturedLevels = static_cast<int>(std::bit_width(static_cast<unsigned>(size))),
            .levels = probeLevels(size),
            .samples = scene.values[scene.table.probeSamples]};
}

Pass capturePass(const char* what, int face, const HallScene& scene, const ProbeCapture& capture)
{
    Pass pass;
    pass.name = std::string("probe/") + what + "/" + std::to_string(face);
    pass.reason = capture.reason;
    pass.phase = render::PassPhase::probe;
    pass.view = render::cubeFaceView(probePosition(scene), face, capture.size);
    pass.contentHash = capture.key;
    return pass;
}

/// Returns the light in which the probe is captured. The probe must not read itself, so surfaces without a lightmap get
/// the light in the air, even with baked light switched off. Shadows of exhibits and lamps selected by view are
/// omitted, because the probe's key does not contain them.
SceneLighting lightOfHallAlone(const HallScene& scene, const SceneLighting& light,
                               const std::optional<render::LocalLighting>& lamps)
{
    SceneLighting hallLight = light;
    hallLight.light.hasProbe = false;
    if (!hallLight.light.hasAirLight) lookUpAirLight(scene, hallLight);
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

/// Returns whether something surrounds the probe. It would hide everything else, and the probe must not see itself.
bool surroundsProbe(const HallScene& scene, const render::Box& box)
{
    constexpr double around = 0.5;  // Meters.
    return render::Box{box.low - around, box.high + around}.contains(probePosition(scene));
}

/// Returns the exhibits as the probe sees them: simple shapes in their mean colors.
std::vector<StandingShape> bodiesSeen(const HallScene& scene)
{
    std::vector<StandingShape> seen = scene.bodies;
    seen.insert(seen.end(), scene.besideFloor.begin(), scene.besideFloor.end());
    std::erase_if(seen, [&](const StandingShape& shape) { return surroundsProbe(scene, boundsOf(shape)); });
    return seen;
}

render::Draw bodyDraw(const StandingShape& shape)
{
    render::Material material;
    material.baseColor = glm::vec4(shape.color, 1);
    material.metalness = 0;
    const bool box = shape.kind == STANDING_BOX;
    const glm::dvec2 half(box ? shape.halfSize : glm::vec2(shape.halfSize.x));
    const auto height = static_cast<double>(shape.halfHeight);
    // A round shape is drawn as a dome on the same spot.
    const double up = box ? height : 2 * height;
    const glm::dvec3 foot = glm::dvec3(shape.center) - glm::dvec3(0, box ? 0 : height, 0);
    const glm::dvec3 first(shape.axis.x, 0, shape.axis.y);
    const glm::dmat4 world(glm::dvec4(first * half.x, 0), glm::dvec4(0, up, 0, 0),
                           glm::dvec4(-first.z * half.y, 0, first.x * half.y, 0), glm::dvec4(foot, 1));
    return surfaceDraw(box ? boxMesh() : domeMesh(), world, material);
}

/// Returns what stands and hangs in the hall, without rotation of the hangings.
std::vector<render::Draw> thingDraws(const HallScene& scene)
{
    std::vector<render::MeshInstance> parts = standingParts(scene);
    for (const auto& [number, place] : scene.model.places())
        if (isOccupied(scene, number)) parts.insert(parts.end(), place.hanging.begin(), place.hanging.end());
    std::vector<render::Draw> draws;
    for (const render::MeshInstance& part : parts)
        if (!surroundsProbe(scene, part.mesh->bounds.transformed(part.modelFromPart)))
            draws.push_back(partDraw(scene, part));
    for (const OwnObject& object : scene.objects) {
        if (surroundsProbe(scene, object.box)) continue;
        for (const render::MeshInstance& part : object.model->parts)
            draws.push_back(surfaceDraw(part.mesh, object.worldFromModel * part.modelFromPart,
                                        part.material ? *part.material : render::Material()));
    }
    for (const StandingShape& body : bodiesSeen(scene)) draws.push_back(bodyDraw(body));
    return draws;
}

/// Draws that are repeated for each face.
struct Surroundings {
    std::vector<render::Draw> walls, things;
};

/// Returns the draws of the works that the view may contain.
std::vector<render::Draw> workDraws(std::span<const ReflectedWork> works, const render::View& view)
{
    std::vector<render::Draw> draws;
    for (const ReflectedWork& work : works) {
        const render::Box flat{{-1, -1, 0}, {1, 1, 0}};
        if (!view.mayContain(flat.transformed(work.worldFromOpening))) continue;
        render::Draw draw;
        draw.mesh = boxMesh();
        draw.object = render::std140Bytes(
            ProbeWork{.worldFromBox = glm::mat4(glm::scale(work.worldFromOpening, glm::dvec3(1, 1, 1e-3))),
                      .pictureFromWorld = glm::mat4(work.clipFromWorld)});
        draw.inputs = {{UNIT_SOURCE, work.image}};
        draws.push_back(std::move(draw));
    }
    return draws;
}

void planFace(const HallScene& scene, const SceneLighting& hallLight, const Surroundings& around, int face,
              const ProbeCapture& capture, render::FramePlan& plan)
{
    Pass sky = capturePass("sky", face, scene, capture);
    sky.shader = {.vertex = "lib/fullscreen.vert", .fragment = "hall/sky.frag", .defines = {"CAPTURE"}};
    sky.colors = {Attachment::slice("probe.captured", face)};
    sky.draws = {render::Draw{}};
    sky.bound = hallLight.probeLight;
    hallLight.bindLight(sky);
    if (scene.alone && face == 5) sky.mipmaps = {"probe.captured"};
    plan.add(std::move(sky));
    if (scene.alone) return;

    Pass walls = capturePass("walls", face, scene, capture);
    walls.bound = hallLight.probeLight;
    walls.shader = {.vertex = "kit/surface.vert",
                    .fragment = "kit/surface.frag",
                    .defines = {"BASE_COLOR_MAP", "SURFACE_MAP", "FLAT_PROBE"}};
    walls.colors = {Attachment::slice("probe.captured", face)};
    walls.depth = Attachment::clearedSlice("probe.depth", face);
    walls.state = {.depthTest = render::DepthTest::nearer, .depthWrite = true, .cull = render::Cull::none};
    Pass things = walls;
    things.name = "probe/things/" + std::to_string(face);
    things.depth = Attachment::slice("probe.depth", face);
    walls.draws = around.walls;
    bindLightmaps(scene, hallLight, walls);
    hallLight.bindLighting(walls);
    walls.shaded.inView = true;
    walls.triangleSamples = scene.model.triangleSamples();
    plan.add(std::move(walls));
    things.draws = around.things;
    hallLight.bindLighting(things);
    things.shaded.inView = true;
    if (face == 5) things.mipmaps = {"probe.captured"};
    plan.add(std::move(things));
}

/// Images that a cube's blurred levels are made from, and written to.
struct BlurredCube {
    const char* name;             ///< Middle part of the names of its passes.
    const char* image;            ///< Cube of the levels.
    const char* works = nullptr;  ///< Cube of the works, which covers the captured hall.
};

/// Plans one pass for each level, for increasing roughness.
void planLevels(const BlurredCube& cube, const ProbeCapture& capture, const render::ContributionBound& bound,
                render::FramePlan& plan)
{
    for (int level = 0; level < capture.levels; ++level) {
        const int side = std::max(capture.size >> level, 1);
        const float t = capture.levels > 1 ? static_cast<float>(level) / static_cast<float>(capture.levels - 1) : 0.0F;
        Pass pass;
        pass.name = std::string("probe/") + cube.name + "/" + std::to_string(level);
        pass.reason = capture.reason;
        pass.phase = render::PassPhase::prepare;
        pass.work = render::Work::compute;
        pass.shader = {.compute = "hall/probe_prefilter.comp"};
        pass.storage = {{.image = cube.image, .level = level}};
        pass.inputs = {{UNIT_SOURCE, std::string("probe.captured")}};
        if (cube.works) {
            pass.shader.defines = {"WORKS"};
            pass.inputs.push_back({UNIT_EXHIBIT_A, std::string(cube.works)});
        }
        // The level is proportional to the square root of roughness (lib/light.glsl), so roughness is its square.
        pass.blocks[BLOCK_OBJECT] = render::std140Bytes(
            ProbeLevel{.roughness = t * t, .samples = level == 0 ? 1 : capture.samples, .capturedSize = capture.size});
        pass.groups = {(side + 7) / 8, (side + 7) / 8, 6};
        pass.bound = bound;
        pass.contentHash = capture.key;
        plan.add(std::move(pass));
    }
}

/// Adds a cube in which passes draw or write their results, which stay until the key changes.
void addCube(std::string name, int size, int levels, render::FramePlan& plan)
{
    plan.image({.name = std::move(name),
                .format = render::Format::rgba16f,
                .type = render::TextureType::cube,
                .size = glm::ivec2(size),
                .levels = levels,
                .persistent = true});
}

/// Plans what is visible of the works through their openings: premultiplied, with coverage in alpha.
void planWorks(const HallScene& scene, std::span<const ReflectedWork> works, const ProbeCapture& capture,
               const render::ContributionBound& bound, render::FramePlan& plan)
{
    for (int face = 0; face < 6; ++face) {
        Pass pass = capturePass("works", face, scene, capture);
        pass.bound = bound;
        pass.shader = {.vertex = "hall/probe_work.vert", .fragment = "hall/probe_work.frag"};
        pass.colors = {Attachment::clearedSlice("probe.works", face)};
        pass.depth = Attachment::slice("probe.depth", face);
        pass.state = {.depthTest = render::DepthTest::nearer, .cull = render::Cull::none};
        pass.draws = workDraws(works, *pass.view);
        if (face == 5) pass.mipmaps = {"probe.works"};
        plan.add(std::move(pass));
    }
}

/// Returns a hash of everything that the probe sees.
std::uint64_t keyOf(const HallScene& scene, const std::optional<render::LocalLighting>& lamps)
{
    render::Hash hash;
    const auto add = [&](const render::Bytes& bytes) {
        hash.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    hash.addValue(lightKey(scene));
    if (lamps) add(render::std140Bytes(lamps->block));
    if (!scene.alone)
        for (const StandingShape& body : bodiesSeen(scene)) add(render::std140Bytes(body));
    return hash.value();
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
    render::divideIntoCells(lighting.block, scene.model.bounds());
    return lighting;
}

std::optional<render::View> viewThrough(const HallScene& scene, const glm::dmat4& worldFromOpening)
{
    const glm::dvec3 eye = probePosition(scene), center(worldFromOpening[3]);
    const glm::dvec3 across(worldFromOpening[0]), up(worldFromOpening[1]);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(worldFromOpening[2]));
    const glm::dvec2 half(glm::length(across), glm::length(up));
    const double away = glm::dot(eye - center, normal);
    if (!(away > 0.5)) return std::nullopt;  // Meters.
    const glm::dvec2 aside(glm::dot(center - eye, across / half.x), glm::dot(center - eye, up / half.y));
    const double perMeter = scene.values[scene.table.probeSize] / away;
    render::Raster raster;
    raster.size = glm::clamp(glm::ivec2(glm::ceil(2.0 * half * perMeter)), glm::ivec2(1), glm::ivec2(1024));
    return render::makeView(
        {.eye = eye, .target = eye - normal, .fovY = 2 * std::atan(half.y / away), .lensShift = aside / away}, raster);
}

void planProbe(const HallScene& scene, const SceneLighting& light, render::FramePlan& plan)
{
    if (!scene.values[scene.table.reflectionProbe]) {
        plan.skip("probe", "the reflection probe is switched off");
        return;
    }
    if (!plan.includeIfEffective(light.probeLight, {"probe"})) return;
    ProbeCapture capture = captureOf(scene);
    const std::optional<render::LocalLighting> lamps = probeLamps(scene);
    capture.key = keyOf(scene, lamps);
    addCube("probe.captured", capture.size, capture.capturedLevels, plan);
    addCube("probe", capture.size, capture.levels, plan);
    plan.image({.name = "probe.irradiance",
                .format = render::Format::rgba32f,
                .size = {9, 1},
                .persistent = true,
                .nearest = true});
    if (!scene.alone)
        plan.image({.name = "probe.depth",
                    .format = render::Format::depth32f,
                    .type = render::TextureType::array,
                    .size = glm::ivec2(capture.size),
                    .layers = 6,
                    .persistent = true});
    const SceneLighting hallLight = lightOfHallAlone(scene, light, lamps);
    const Surroundings around = scene.alone ? Surroundings() : Surroundings{wallDraws(scene), thingDraws(scene)};
    for (int face = 0; face < 6; ++face) planFace(scene, hallLight, around, face, capture, plan);
    planLevels({.name = "blur", .image = "probe"}, capture, light.probeLight, plan);

    // A level of 16 texels contains everything that nine coefficients can represent.
    const int level = std::max(capture.capturedLevels - 5, 0);
    Pass sum;
    sum.name = "probe/irradiance";
    sum.reason = capture.reason;
    sum.phase = render::PassPhase::prepare;
    sum.work = render::Work::compute;
    sum.shader = {.compute = "hall/probe_irradiance.comp"};
    sum.storage = {Attachment::whole("probe.irradiance")};
    sum.inputs = {{UNIT_SOURCE, std::string("probe.captured")}};
    sum.blocks[BLOCK_OBJECT] =
        render::std140Bytes(ProbeLevel{.capturedLevel = level, .capturedSize = std::max(capture.size >> level, 1)});
    sum.contentHash = capture.key;
    sum.bound = light.probeLight;
    plan.add(std::move(sum));
}

void planMirroredWorks(const HallScene& scene, SceneLighting& light, std::span<const ReflectedWork> works,
                       render::FramePlan& plan)
{
    render::Hash hash;
    hash.addValue(keyOf(scene, probeLamps(scene)));
    for (const ReflectedWork& work : works) hash.addValue(work.worldFromOpening).addValue(work.key);
    ProbeCapture capture = captureOf(scene);
    capture.key = hash.value();
    capture.reason = "a mirror shows the works behind the openings";
    addCube("probe.works", capture.size, capture.capturedLevels, plan);
    addCube(mirroredWorksImage, capture.size, capture.levels, plan);
    planWorks(scene, works, capture, light.probeLight, plan);
    planLevels({.name = "mirrored", .image = mirroredWorksImage, .works = "probe.works"}, capture, light.probeLight,
               plan);
    light.hasMirroredWorks = true;
}

}  // namespace vitrine::hall
