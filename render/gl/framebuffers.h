#pragma once

#include "render/gl/object.h"
#include "render/gl/texture.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace vitrine::render::gl {

/// A texture, or a layer of it (-1: all), that is drawn into.
struct TargetImage {
    const Texture* texture = nullptr;
    int layer = -1;
    int level = 0;
};

/// Framebuffer objects by what is attached to them: made when first used, kept until one of their textures goes.
class Framebuffers {
public:
    /// Color attachments by location; `depth.texture` may be null.
    [[nodiscard]] GLuint use(const std::vector<TargetImage>& colors, const TargetImage& depth);
    /// Deletes all that this texture is attached to: it is about to be deleted itself.
    void forget(const Texture&);
    [[nodiscard]] std::int64_t made() const { return made_; }  ///< So far.
    [[nodiscard]] std::size_t size() const { return framebuffers_.size(); }
    void abandon();

private:
    using Point = std::tuple<GLuint, int, int>;  ///< Texture, layer, level.
    std::map<std::vector<Point>, FramebufferName> framebuffers_;
    std::int64_t made_ = 0;
};

/// Whoever calls gets his framebuffer back, whatever happens meanwhile.
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
