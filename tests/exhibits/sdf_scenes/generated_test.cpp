// Generated shaders against the evaluator: 1,024 points each, drawn into a picture of floats.

#include "exhibits/sdf_scenes/scene_glsl.h"
#include "render/gl/program.h"
#include "render/glsl/cpu.h"
#include "tests/exhibits/sdf_scenes/support.h"
#include "tests/support/gallery.h"

#include <epoxy/gl.h>

#include <filesystem>

namespace vitrine {
namespace {

using SceneShaders = test::GlTest;

constexpr int side = 32;

/// Points of a cube of 8 m, the same to the bit on both sides; distance by both functions, and two of the material's
/// numbers.
const char* const pointsShader = R"(
#include "lib/hash.glsl"
#include "sdf_scenes/generated_field.glsl"
layout(location = 0) out vec4 found;
void main()
{
    uvec3 bits = hashCell(ivec3(int(gl_FragCoord.x), int(gl_FragCoord.y), 0), 7u);
    vec3 p = vec3(unitFromBits(bits.x), unitFromBits(bits.y), unitFromBits(bits.z)) * 8.0 - vec3(4.0);
    SceneSurface surface = sceneSurface(p);
    // In a loop, as a march asks it: outside of one, LLVM 15 takes minutes over many repetitions.
    float distance = 0.0;
    for (float i = 0.0; i < min(gl_FragCoord.x, 0.5); i += 1.0) distance += fieldDistance(p);
    found = vec4(distance, surface.distance, surface.material.color.r, surface.material.roughness);
}
)";

/// All of it is exact in float32 but the last subtraction, which rounds as on the GPU.
glm::dvec3 pointOf(int x, int y)
{
    const glm::uvec3 bits = glsl::hashCell({x, y, 0}, 7);
    const auto coordinate = [](unsigned b) {
        return static_cast<double>(static_cast<float>(glsl::unitFromBits(b) * 8.0 - 4.0));
    };
    return {coordinate(bits.x), coordinate(bits.y), coordinate(bits.z)};
}

struct Found {
    float distance, surfaceDistance, red, roughness;
};

std::vector<Found> drawn(const std::string& glsl, const std::vector<std::byte>& block)
{
    const render::ShaderKey key{.vertex = "lib/fullscreen.vert",
                                .fragment = "sdf_scenes/points.frag",
                                .sources =
                                    std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
                                        {scenes::generatedField, glsl}, {"sdf_scenes/points.frag", pointsShader}})};
    const render::gl::BuiltProgram built = render::gl::buildProgram(render::ShaderSource(), key);
    EXPECT_TRUE(built.program) << built.problem.file << ':' << built.problem.line << ' ' << built.problem.text << '\n'
                               << glsl;
    std::vector<Found> found(side * side);
    if (!built.program) return found;
    GLuint buffer = 0, texture = 0, target = 0, vertices = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferData(buffer, static_cast<GLsizeiptr>(std::max<std::size_t>(block.size(), 16)), nullptr,
                      GL_STATIC_DRAW);
    glNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(block.size()), block.data());
    constexpr GLuint exhibitBlock = 6;
    glBindBufferBase(GL_UNIFORM_BUFFER, exhibitBlock, buffer);
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA32F, side, side);
    glCreateFramebuffers(1, &target);
    glNamedFramebufferTexture(target, GL_COLOR_ATTACHMENT0, texture, 0);
    glCreateVertexArrays(1, &vertices);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, side, side);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(built.program.name());
    glBindVertexArray(vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, found.data());
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteVertexArrays(1, &vertices);
    glDeleteFramebuffers(1, &target);
    glDeleteTextures(1, &texture);
    glDeleteBuffers(1, &buffer);
    return found;
}

/// The largest difference of the distances, and of what materials differ by more than rounding.
void compare(const scenes::SceneField& field, const std::string& glsl, const std::vector<std::byte>& block,
             const std::string& what)
{
    const std::vector<Found> found = drawn(glsl, block);
    int unlike = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 p = pointOf(x, y);
            const scenes::SceneSample truth = field.sample(p);
            const Found& pixel = found[static_cast<std::size_t>(y * side + x)];
            const double tolerance = 1e-5 * std::max(1.0, std::abs(truth.distance));
            ASSERT_NEAR(pixel.distance, truth.distance, tolerance) << what << p.x << ' ' << p.y << ' ' << p.z << '\n'
                                                                   << glsl;
            ASSERT_NEAR(pixel.surfaceDistance, truth.distance, tolerance) << what;
            const bool like =
                std::abs(pixel.red - truth.material[0]) < 1e-3 && std::abs(pixel.roughness - truth.material[9]) < 1e-3;
            unlike += like ? 0 : 1;
        }
    }
    // Where two shapes are as near, rounding decides.
    EXPECT_LE(unlike, 2) << what << glsl;
}

void compareBothWays(const std::shared_ptr<const scenes::Scene>& scene, double time, const std::string& what)
{
    const scenes::SceneField field(scene, time);
    compare(field, scenes::sceneGlsl(field.program()), scenes::sceneBlock(field.words()), what + " from the block: ");
    compare(field, scenes::foldedSceneGlsl(field.program(), field.words()), {}, what + " folded: ");
}

TEST_F(SceneShaders, OfTheShippedScenesAreTheEvaluator)
{
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes")) {
        if (entry.path().filename() == "scene.schema.json") continue;
        const scenes::ReadScene read = scenes::readSceneFile(entry.path());
        ASSERT_TRUE(read.scene) << test::findingsText(read);
        const std::string name = entry.path().stem().string();
        compareBothWays(read.scene, 1.25, name);
    }
}

/// Numbers of another moment are seen.
TEST_F(SceneShaders, WithOtherNumbersAreNotTheEvaluator)
{
    const auto scene = test::sceneOf(R"json({"kind": "sphere", "radius": "0.5 + 0.0001 * t"})json");
    const scenes::SceneField field(scene, 0);
    const scenes::SceneField later(scene, 1);
    const std::vector<Found> found = drawn(scenes::sceneGlsl(field.program()), scenes::sceneBlock(later.words()));
    EXPECT_NEAR(found.front().distance, later.distance(pointOf(0, 0)), 1e-5);
    EXPECT_GT(std::abs(found.front().distance - field.distance(pointOf(0, 0))), 5e-5);
}

TEST_F(SceneShaders, OfEveryKindOfNodeAreTheEvaluator)
{
    const std::string head = R"("materials": {"red": {"model": "pbr", "color": [1, 0, 0], "roughness": 1},
        "blue": {"model": "pbr", "color": [0, 0, 1]}},)";
    test::Random random(61);
    std::vector<std::string> nodes;
    for (const scenes::NodeKind& kind : scenes::nodeKinds()) {
        std::string further = test::randomPlace(random, false);
        if (kind.form == scenes::Form::modifier || kind.form == scenes::Form::repeater)
            further += R"(, "child": {"kind": "capsule", "start": [0.3, 0, 0], "radius": 0.2})";
        else if (kind.form != scenes::Form::shape)
            further += R"(, "children": [{"kind": "sphere", "material": "red"}, {"kind": "box", "material": "blue"}])";
        std::string node = test::randomNode(kind, random, further);
        while (!test::readText(test::sceneText(node, head)).scene) node = test::randomNode(kind, random, further);
        nodes.push_back(node);
    }
    constexpr std::size_t together = 6;
    for (std::size_t first = 0; first < nodes.size(); first += together) {
        std::string root = R"({"kind": "union", "blend": "circular", "blendWidth": 0.1, "children": [)";
        for (std::size_t i = first; i < std::min(first + together, nodes.size()); ++i)
            root += (i > first ? ", " : "") + nodes[i];
        compareBothWays(test::sceneOf(root + "]}", head), 0, root);
    }
}

TEST_F(SceneShaders, OfRandomTreesAreTheEvaluator)
{
    test::Random random(62);
    for (int sample = 0; sample < 10; ++sample) {
        const std::string root = test::randomTree(random, 3);
        compareBothWays(test::sceneOf(root), 0, root);
    }
}

TEST_F(SceneShaders, HaveNothingThatTheSceneHasNot)
{
    const auto glslOf = [](const std::string& root) {
        return scenes::sceneGlsl(scenes::SceneProgram(test::sceneOf(root)));
    };
    const std::string ball = glslOf(R"({"kind": "sphere"})");
    for (const char* word : {"noise.glsl", "shapes.glsl", "sceneTurned", "for (", "sceneBlend", "sceneUnion"})
        EXPECT_EQ(ball.find(word), std::string::npos) << word << '\n' << ball;
    EXPECT_NE(glslOf(R"({"kind": "noise"})").find("noise.glsl"), std::string::npos);
    EXPECT_NE(glslOf(R"({"kind": "pyramid"})").find("shapes.glsl"), std::string::npos);
    // A slider changes numbers of the block and not the text.
    const auto with = [&](const char* radius) {
        return glslOf(std::string(R"({"kind": "sphere", "radius": )") + radius + "}");
    };
    EXPECT_EQ(with("0.25"), with("0.75"));
}

}  // namespace
}  // namespace vitrine
