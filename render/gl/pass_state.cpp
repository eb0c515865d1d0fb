#include "render/gl/pass_state.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace vitrine::render::gl {
namespace {

constexpr int endless = 1 << 20;  // Larger than any picture, in pixels.

GLenum depthFunction(DepthTest test)
{
    switch (test) {
    case DepthTest::none: return GL_ALWAYS;
    case DepthTest::nearer: return GL_GREATER;  // Depth is reversed: nearer is greater.
    case DepthTest::nearerOrEqual: return GL_GEQUAL;
    case DepthTest::equal: return GL_EQUAL;
    case DepthTest::farther: return GL_LESS;
    }
    return GL_ALWAYS;
}

void enable(GLenum capability, bool on)
{
    on ? glEnable(capability) : glDisable(capability);
}

void applyBlend(const RasterState& state)
{
    enable(GL_BLEND, state.blend != Blend::none);
    glBlendEquation(GL_FUNC_ADD);
    switch (state.blend) {
    case Blend::none: break;
    case Blend::add: glBlendFunc(GL_ONE, GL_ONE); break;
    case Blend::alpha: glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::premultiplied: glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::mean:
        glBlendColor(0, 0, 0, state.meanWeight);
        glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
        break;
    }
}

}  // namespace

void bindTarget(const Pass& pass, Resources& resources, bool clears)
{
    const GLuint name = resources.framebuffer(pass);
    glm::ivec2 size(1);
    for (const Attachment& color : pass.colors) size = resources.target(color.image).size(color.level);
    if (pass.depth) size = resources.target(pass.depth->image).size(pass.depth->level);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    glViewport(0, 0, size.x, size.y);

    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    if (!clears) return;
    for (std::size_t i = 0; i < pass.colors.size(); ++i)
        if (pass.colors[i].load == Load::clear)
            glClearNamedFramebufferfv(name, GL_COLOR, static_cast<GLint>(i), glm::value_ptr(pass.colors[i].clear));
    if (pass.depth && pass.depth->load == Load::clear)
        glClearNamedFramebufferfv(name, GL_DEPTH, 0, &pass.depth->clear.x);
}

void applyCulling(Cull cull)
{
    enable(GL_CULL_FACE, cull != Cull::none);
    glCullFace(cull == Cull::front ? GL_FRONT : GL_BACK);
}

void applyState(const RasterState& state)
{
    enable(GL_DEPTH_TEST, state.depthTest != DepthTest::none || state.depthWrite);
    glDepthFunc(depthFunction(state.depthTest));
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    enable(GL_DEPTH_CLAMP, state.depthClamp);
    applyCulling(state.cull);
    enable(GL_POLYGON_OFFSET_FILL, state.depthBias != glm::vec2(0));
    // Depth is reversed: away from the viewer means towards 0.
    glPolygonOffset(-state.depthBias.x, -state.depthBias.y);
    enable(GL_TEXTURE_CUBE_MAP_SEAMLESS, true);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    applyBlend(state);
}

void limitTo(const std::optional<glm::ivec2>& columns)
{
    if (columns) return limitTo(columns, glm::ivec2(0, endless));
    enable(GL_SCISSOR_TEST, false);
}

void limitTo(const std::optional<glm::ivec2>& columns, glm::ivec2 rows)
{
    enable(GL_SCISSOR_TEST, true);
    const glm::ivec2 across = columns.value_or(glm::ivec2(0, endless));
    const int first = std::max(across.x, 0);
    glScissor(first, rows.x, std::max(across.y - first, 0), rows.y - rows.x);
}

void dispatch(const Pass& pass, const Resources& resources)
{
    for (std::size_t i = 0; i < pass.storage.size(); ++i) {
        const Attachment& target = pass.storage[i];
        const Texture& texture = resources.target(target.image);
        glBindImageTexture(static_cast<GLuint>(i), texture.name(), target.level,
                           static_cast<GLboolean>(target.layer < 0), target.layer < 0 ? 0 : target.layer, GL_READ_WRITE,
                           internalFormat(texture.format()));
    }
    glDispatchCompute(static_cast<GLuint>(pass.groups.x), static_cast<GLuint>(pass.groups.y),
                      static_cast<GLuint>(pass.groups.z));
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace vitrine::render::gl
