#include "render/gl/framebuffers.h"

#include <algorithm>
#include <cassert>

namespace vitrine::render::gl {
namespace {

void attach(GLuint framebuffer, GLenum point, const TargetImage& image)
{
    if (image.layer < 0)
        glNamedFramebufferTexture(framebuffer, point, image.texture->name(), image.level);
    else
        glNamedFramebufferTextureLayer(framebuffer, point, image.texture->name(), image.level, image.layer);
}

FramebufferName makeFramebuffer(const std::vector<TargetImage>& colors, const TargetImage& depth)
{
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    FramebufferName framebuffer(name);
    std::vector<GLenum> buffers;
    for (const TargetImage& color : colors) {
        const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
        attach(name, point, color);
        buffers.push_back(point);
    }
    if (depth.texture) attach(name, GL_DEPTH_ATTACHMENT, depth);
    if (buffers.empty())
        glNamedFramebufferDrawBuffer(name, GL_NONE);
    else
        glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(buffers.size()), buffers.data());
    assert(glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    return framebuffer;
}

}  // namespace

GLuint Framebuffers::use(const std::vector<TargetImage>& colors, const TargetImage& depth)
{
    std::vector<Point> key;
    for (const TargetImage& color : colors) key.emplace_back(color.texture->name(), color.layer, color.level);
    key.emplace_back(depth.texture ? depth.texture->name() : 0, depth.layer, depth.level);  // Always the last one.
    auto found = framebuffers_.find(key);
    if (found == framebuffers_.end()) {
        found = framebuffers_.emplace(std::move(key), makeFramebuffer(colors, depth)).first;
        ++made_;
    }
    return found->second.name();
}

void Framebuffers::forget(const Texture& texture)
{
    std::erase_if(framebuffers_, [&](const auto& entry) {
        return std::any_of(entry.first.begin(), entry.first.end(),
                           [&](const Point& point) { return std::get<0>(point) == texture.name(); });
    });
}

void Framebuffers::abandon()
{
    for (auto& [key, framebuffer] : framebuffers_) framebuffer.abandon();
}

}  // namespace vitrine::render::gl
