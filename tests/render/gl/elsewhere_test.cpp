// A mirror in a picture: what it shows lies where rays say.

#include "render/plan/elsewhere.h"
#include "render/scene/ray.h"
#include "tests/render/gl/box_mesh.h"
#include "tests/render/gl/renderer_bench.h"

namespace vitrine {
namespace {

using namespace render;
using Mirror = test::RendererTest;

/// The box, faces colored by their normals: 0.5 + 0.5 n.
FramePlan sceneOf(const View& view, const Box& box)
{
    FramePlan plan;
    plan.view = view;
    plan.image({.name = "radiance", .format = Format::rgba32f});
    plan.image({.name = "depth", .format = Format::depth32f});
    Pass pass;
    pass.name = "box";
    pass.phase = PassPhase::opaque;
    pass.shader = {"box.vert", "box.frag", "", {}};
    pass.shader.sources = std::make_shared<const ShaderSources>(std::map<std::string, std::string>{
        {"box.vert", "#include \"lib/frame.glsl\"\nlayout(location = 0) in vec3 position;\nlayout(location = 1) in "
                     "vec3 normal;\nout vec3 tint;\n"
                     "void main()\n{\n    tint = 0.5 + 0.5 * normal;\n    gl_Position = frame.clipFromWorld * "
                     "vec4(position, 1.0);\n    gl_ClipDistance[0] = frameClipDistance(position);\n}\n"},
        {"box.frag",
         "in vec3 tint;\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    color = vec4(tint, 1.0);\n}\n"}});
    pass.state = {.depthTest = DepthTest::nearer, .depthWrite = true, .cull = Cull::back};
    pass.colors = {Attachment::cleared("radiance")};
    pass.depth = Attachment::cleared("depth");
    pass.draws = {{.mesh = test::boxOf(box)}};
    plan.add(std::move(pass));
    return plan;
}

/// What a ray sees of the box: the color of its face, black where it misses.
glm::dvec3 seenBy(const Ray& ray, const Box& box)
{
    const double t = firstHit(ray, box);
    if (!std::isfinite(t)) return glm::dvec3(0);
    const glm::dvec3 p = (ray.at(t) - box.center()) / box.halfSize();
    glm::dvec3 normal(0);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(p[i]) > std::abs(p[axis])) axis = i;
    normal[axis] = p[axis] > 0 ? 1 : -1;
    return 0.5 + 0.5 * normal;
}

TEST_F(Mirror, ShowsABoxWhereReflectedRaysMeetIt)
{
    const glm::ivec2 size(128, 84);
    const View view = makeView({{1.5, 1.2, 4}, {0.2, 0.2, 0}}, {.size = size});
    const Box box{{-0.7, -0.6, -0.5}, {0.4, 0.9, 0.3}};  // Reaches below the mirror, where it must not be seen.
    const glm::dvec4 plane(glm::normalize(glm::dvec3(0.1, 1, 0.05)), 0.0);

    FramePlan plan = sceneOf(view, box);
    plan.image({.name = "frame", .format = Format::rgba32f});
    Elsewhere mirror{
        .name = "mirror", .reason = "the floor mirrors it", .view = mirroredView(view, plane), .mirrored = true};
    const auto names = addElsewhere(plan, sceneOf(mirror.view, box), mirror);
    Pass show = fill("show", "frame", "color = texelFetch(source, ivec2(gl_FragCoord.xy), 0);",
                     "#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_SOURCE) uniform sampler2D source;\n");
    show.phase = PassPhase::resolve;
    show.inputs = {{12, names.at("radiance")}};
    plan.add(std::move(show));
    (void)draw(plan);

    const Image shown = renderer().read("frame");
    int compared = 0;
    int covered = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            // A pixel whose four corners see what its middle sees is no edge.
            glm::dvec3 expected[5];
            bool inMirror = true;
            for (int i = 0; i < 5; ++i) {
                const glm::dvec2 offset = i == 4 ? glm::dvec2(0.5) : glm::dvec2(i & 1, i >> 1);
                const glm::dvec3 direction =
                    view.direction((glm::dvec2(x, size.y - 1 - y) + offset) / glm::dvec2(size) * 2.0 - 1.0);
                const glm::dvec3 normal(plane);
                const double t = -glm::dot(plane, glm::dvec4(view.eye, 1)) / glm::dot(normal, direction);
                inMirror = inMirror && t > 0;
                inMirror = inMirror && !box.contains(view.eye + t * direction);  // There the box itself is cut.
                if (inMirror) expected[i] = seenBy({view.eye + t * direction, glm::reflect(direction, normal)}, box);
            }
            if (!inMirror) continue;
            bool edge = false;
            for (const glm::dvec3& e : expected) edge = edge || e != expected[4];
            if (edge) continue;
            ++compared;
            covered += expected[4] != glm::dvec3(0);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown.at(x, y, c), expected[4][c], 1e-6) << x << ',' << y;
        }
    }
    EXPECT_GT(compared, 2000);
    EXPECT_GT(covered, 150) << "the box is seen in it";
}

}  // namespace
}  // namespace vitrine
