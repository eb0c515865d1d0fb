// Local lights on the GPU: the uniform block as the driver has it, and their shadows.

#include "render/glsl/cpu.h"
#include "render/plan/local_lights.h"
#include "render/scene/cube_views.h"
#include "render/scene/ray.h"
#include "shaders/lib/bindings.glsl"
#include "tests/render/gl/box_mesh.h"
#include "tests/render/gl/renderer_bench.h"

namespace vitrine {
namespace {

using namespace render;
using LocalLightsOnTheDriver = test::RendererTest;

constexpr int side = 48;
constexpr double reach = 3;

/// Returns the point of a floor that a pixel shows: `reach` meters around the origin, seen from above.
glm::dvec3 placeOf(double x, double y)
{
    return {(x / side * 2 - 1) * reach, 0, (y / side * 2 - 1) * reach};
}

Pass floorPass(const Pass& filled, const LocalLighting& lighting, bool shadows)
{
    Pass pass = filled;
    if (shadows) {
        pass.shader.defines = {"LOCAL_SHADOWS"};
        pass.inputs = {{UNIT_LOCAL_SHADOWS, std::string("maps")}};
    }
    pass.blocks[BLOCK_LOCAL_LIGHTS] = std140Bytes(lighting.block);
    return pass;
}

/// Returns the light's entry at float64.
glsl::LocalLightEntry entryOf(const LocalLight& light)
{
    glsl::LocalLightEntry entry{
        light.position, light.radius, light.intensity, light.range, false, 0, 0, light.axis, 0, 0};
    entry.nearest = light.nearest;
    if (light.axis == glm::dvec3(0)) return entry;
    entry.coneCosine = std::cos(light.coneInner);
    entry.coneScale = 1 / (std::cos(light.coneInner) - std::cos(light.coneOuter));
    return entry;
}

constexpr const char* floorBody = "vec2 p = (gl_FragCoord.xy / 48.0 * 2.0 - 1.0) * 3.0;\ncolor = vec4(0.0);\n"
                                  "for (int i = 0; i < localLights.count; ++i) color.rgb += "
                                  "localLit(localLights.lights[i], vec3(p.x, 0.0, p.y), vec3(0.0, 1.0, 0.0));";

TEST_F(LocalLightsOnTheDriver, AddUpAsAtFloat64)
{
    const std::vector<LocalLight> lights{
        {.position = {0.5, 1, 0.2}, .intensity = {1, 2, 3}},
        {.position = {1.5, 0.3, 1}, .intensity = {0.4, 0.2, 0.3}, .nearest = 0.8},
        {.position = {-1, 0.2, 0.5}, .radius = 0.4, .intensity = {3, 1, 0.5}},
        {.position = {2, 0.6, -2}, .radius = 0.05, .intensity = {0.2, 4, 1}, .range = 2},
        {.position = {-2, 2, -1},
         .intensity = {5, 0.3, 2},
         .axis = glm::normalize(glm::dvec3(0.4, -1, 0.1)),
         .coneInner = 0.2,
         .coneOuter = 0.6}};
    FramePlan plan = planOf({side, side});
    plan.add(floorPass(fill("floor", "frame", floorBody, "#include \"lib/local_lights.glsl\"\n"),
                       localLighting(lights, {0, 0, 0}, 5), false));
    (void)draw(plan);
    const Image frame = renderer().read("frame");
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            glm::dvec3 sum(0);
            for (const LocalLight& light : lights)
                sum += glsl::localIrradiance(entryOf(light), placeOf(x + 0.5, side - y - 0.5), {0, 1, 0});
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(frame.at(x, y, c), sum[c], 2e-3 * sum[c] + 1e-5) << x << ',' << y;
        }
    }
}

TEST_F(LocalLightsOnTheDriver, ThrowShadowsWhereRaysAreStopped)
{
    const Box box{{-0.4, 0.5, -0.3}, {0.5, 0.9, 0.4}};
    const std::vector<LocalLight> lights{{.position = {0.3, 2, -0.2}, .castsShadow = true}};
    const LocalLighting lighting = localLighting(lights, {0, 0, 0}, 5);
    FramePlan plan = planOf({side, side});
    plan.image({.name = "maps",
                .format = Format::depth32f,
                .type = TextureType::array,
                .size = glm::ivec2(512),
                .layers = 6,
                .comparison = true});
    for (int face = 0; face < 6; ++face) {
        Pass map;
        map.name = "map" + std::to_string(face);
        map.phase = PassPhase::shadow;
        map.shader = {"box.vert", "box.frag", "", {}};
        map.shader.sources = std::make_shared<const ShaderSources>(std::map<std::string, std::string>{
            {"box.vert", "#include \"lib/frame.glsl\"\nlayout(location = 0) in vec3 position;\nvoid main()\n{\n    "
                         "gl_Position = frame.clipFromWorld * vec4(position, 1.0);\n}\n"},
            {"box.frag", "void main()\n{\n}\n"}});
        map.view = cubeFaceView(lights[0].position, face, 512, localShadowNear);
        map.depth = Attachment::clearedSlice("maps", face);
        map.state = {.depthTest = DepthTest::nearer, .depthWrite = true};
        map.draws = {{.mesh = test::boxOf(box)}};
        plan.add(std::move(map));
    }
    Pass floor = floorPass(fill("floor", "frame", floorBody, "#include \"lib/local_lights.glsl\"\n"), lighting, true);
    floor.phase = PassPhase::opaque;
    plan.add(std::move(floor));
    (void)draw(plan);
    const Image frame = renderer().read("frame");
    const auto isLit = [&](double x, double y) {
        const glm::dvec3 place = placeOf(x, side - y);
        return !(firstHit({lights[0].position, place - lights[0].position}, box) < 1);
    };
    int dark = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool lit = isLit(x + 0.5, y + 0.5);
            bool edge = false;
            for (const glm::ivec2 c : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
                edge = edge || isLit(x + c.x, y + c.y) != lit;
            if (edge) continue;
            EXPECT_EQ(frame.at(x, y, 0) > 0, lit) << x << ',' << y;
            dark += !lit;
        }
    }
    EXPECT_GT(dark, 20);
}

}  // namespace
}  // namespace vitrine
