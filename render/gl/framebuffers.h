#pragma once

#include "render/gl/object.h"
#include "render/gl/texture.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace vitrine::render::gl {

/// Render target: a texture, or one layer of it (-1: all layers).
struct TargetImage {
    const Texture* texture = nullptr;
    int layer = -1;
    int level = 0;
};

/// Cache of framebuffer objects by their attachments: created on first use, kept until one of their textures is
/// deleted.
class Framebuffers {
public:
    /// Color attachments by location; `depth.texture` may be null.
    [[nodiscard]] GLuint use(const std::vector<TargetImage>& colors, const TargetImage& depth);
    /// Deletes all framebuffers that the texture is attached to. Call it before the texture is deleted.
    void forget(const Texture&);
    [[nodiscard]] std::int64_t made() const { return made_; }  ///< Number created so far.
    [[nodiscard]] std::size_t size() const { return framebuffers_.size(); }
    void abandon();

private:
    using Point = std::tuple<GLuint, int, int>;  ///< Texture, layer, level.
    std::map<std::vector<Point>, FramebufferName> framebuffers_;
    std::int64_t made_ = 0;
};

/// Restores the caller's draw framebuffer when it goes out of scope.
class CallersFramebuffer {
public:
    CallersFramebuffer() { glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name_); }
    ~CallersFramebuffer() { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(name_)); }
    CallersFramebuffer(const CallersFramebuffer&) = delete;
    CallersFramebuffer& operator=(const CallersFramebuffer&) = delete;

private:
    GLint name_ = 0;
};

}  // namespace vitrine::render::gl
