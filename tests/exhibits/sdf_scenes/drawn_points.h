#pragma once

#include "exhibits/sdf_scenes/scene_glsl.h"
#include "render/gl/program.h"
#include "render/glsl/cpu.h"
#include "render/plan/frame_plan.h"
#include "tests/exhibits/sdf_scenes/support.h"
#include "tests/support/gallery.h"

#include <epoxy/gl.h>

namespace vitrine::test {

inline constexpr int side = 32;

/// Shader that evaluates points of a cube of 8 m, exactly the same as on the CPU: the distance by both functions, and
/// two numbers of the material.
inline const char* const pointsShader = R"(
#include "lib/hash.glsl"
#include "sdf_scenes/generated_field.glsl"
layout(location = 0) out vec4 found;
void main()
{
    uvec3 bits = hashCell(ivec3(int(gl_FragCoord.x), int(gl_FragCoord.y), 0), 7u);
    vec3 p = vec3(unitFromBits(bits.x), unitFromBits(bits.y), unitFromBits(bits.z)) * 8.0 - vec3(4.0);
    SceneSurface surface = sceneSurface(p);
    // Evaluated in a loop, like a march: without the loop, LLVM 15 compiles many repetitions for minutes.
    float distance = 0.0;
    for (float i = 0.0; i < min(gl_FragCoord.x, 0.5); i += 1.0) distance += fieldDistance(p);
    found = vec4(distance, surface.distance, surface.material.color.r, surface.material.roughness);
}
)";

/// Exact in float32 except for the last subtraction, which rounds like on the GPU.
inline glm::dvec3 pointOf(int x, int y)
{
    const glm::uvec3 bits = glsl::hashCell({x, y, 0}, 7);
    const auto coordinate = [](unsigned b) {
        return static_cast<double>(static_cast<float>(glsl::unitFromBits(b) * 8.0 - 4.0));
    };
    return {coordinate(bits.x), coordinate(bits.y), coordinate(bits.z)};
}

struct FoundAtPoint {
    float distance, surfaceDistance, red, roughness;
};

inline std::vector<FoundAtPoint> drawn(const std::string& glsl, const std::vector<std::byte>& block,
                                       const std::vector<render::BufferUse>& storage = {})
{
    const render::ShaderKey key{.vertex = "lib/fullscreen.vert",
                                .fragment = "sdf_scenes/points.frag",
                                .sources =
                                    std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
                                        {scenes::generatedField, glsl}, {"sdf_scenes/points.frag", pointsShader}})};
    const render::gl::BuiltProgram built = render::gl::buildProgram(render::ShaderSource(), key);
    EXPECT_TRUE(built.program) << built.problem.file << ':' << built.problem.line << ' ' << built.problem.text << '\n'
                               << glsl;
    std::vector<FoundAtPoint> found(side * side);
    if (!built.program) return found;
    GLuint buffer = 0, texture = 0, target = 0, vertices = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferData(buffer, static_cast<GLsizeiptr>(std::max<std::size_t>(block.size(), 16)), nullptr,
                      GL_STATIC_DRAW);
    glNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(block.size()), block.data());
    constexpr GLuint exhibitBlock = 6;
    glBindBufferBase(GL_UNIFORM_BUFFER, exhibitBlock, buffer);
    std::vector<GLuint> stored, texels;
    for (const render::BufferUse& use : storage) {
        const render::Bytes& bytes = *std::get<std::shared_ptr<const render::Bytes>>(use.source);
        GLuint& name = stored.emplace_back();
        glCreateBuffers(1, &name);
        glNamedBufferData(name, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
        const auto binding = static_cast<GLuint>(use.binding);
        if (use.texels == render::Texels::none) {
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name);
            continue;
        }
        glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels.emplace_back());
        glTextureBuffer(texels.back(), use.texels == render::Texels::vec4 ? GL_RGBA32F : GL_RGBA32UI, name);
        glBindTextureUnit(binding, texels.back());
    }
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
    glDeleteTextures(static_cast<GLsizei>(texels.size()), texels.data());
    glDeleteBuffers(1, &buffer);
    glDeleteBuffers(static_cast<GLsizei>(stored.size()), stored.data());
    return found;
}

/// Allowed results of a field with cells outside of its grid and farther than `exactWithin` from every surface: a
/// smaller distance, or that to a box around all surfaces, and any material.
struct ByCells {
    double exactWithin = 1e30;
    render::Box grid, held;

    [[nodiscard]] bool isExact(const glm::dvec3& p, double truth) const
    {
        return std::abs(truth) <= exactWithin && (grid.empty() || grid.contains(p));
    }
    [[nodiscard]] double most(const glm::dvec3& p, double truth) const
    {
        if (held.empty()) return std::abs(truth);
        return std::max(std::abs(truth), glm::length(glm::max(glm::max(held.low - p, p - held.high), glm::dvec3(0))));
    }
};

/// Compares distances and materials with the evaluator.
inline void compareAtPoints(const scenes::SceneField& field, const std::string& glsl,
                            const std::vector<std::byte>& block, const std::string& what,
                            const std::vector<render::BufferUse>& storage = {}, const ByCells& byCells = {})
{
    const std::vector<FoundAtPoint> found = drawn(glsl, block, storage);
    int unlike = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 p = pointOf(x, y);
            const scenes::SceneSample truth = field.sample(p);
            const FoundAtPoint& pixel = found[static_cast<std::size_t>(y * side + x)];
            const double tolerance = 1e-5 * std::max(1.0, std::abs(truth.distance));
            if (!byCells.isExact(p, truth.distance)) {
                ASSERT_EQ(pixel.distance < 0, truth.distance < 0) << what << p.x << ' ' << p.y << ' ' << p.z;
                ASSERT_LE(std::abs(pixel.distance), byCells.most(p, truth.distance) + tolerance) << what;
                continue;
            }
            ASSERT_NEAR(pixel.distance, truth.distance, tolerance) << what << p.x << ' ' << p.y << ' ' << p.z << '\n'
                                                                   << glsl;
            ASSERT_NEAR(pixel.surfaceDistance, truth.distance, tolerance) << what;
            const bool like =
                std::abs(pixel.red - truth.material[0]) < 1e-3 && std::abs(pixel.roughness - truth.material[9]) < 1e-3;
            unlike += like ? 0 : 1;
        }
    }
    // If two shapes are equally near, rounding decides.
    EXPECT_LE(unlike, 2) << what << glsl;
}

}  // namespace vitrine::test
