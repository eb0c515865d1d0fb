#pragma once

#include "render/gl/object.h"
#include "render/gl/screen_pixels.h"

#include <glm/glm.hpp>

namespace vitrine::render::gl {

/// What stands in for the window's screen where pictures are drawn on another thread: sRGB, 8 bits.
class Screen {
public:
    /// Makes it the target, of this size, and the part of it that begins at `offset` the viewport.
    void bind(glm::ivec2 size, glm::ivec2 offset, glm::ivec2 part);
    /// The pixels of a part of what is bound, which it ends.
    [[nodiscard]] ScreenPixels read(glm::ivec2 offset, glm::ivec2 part);
    void abandon();

private:
    TextureName texture_;
    FramebufferName framebuffer_;
    glm::ivec2 size_{0};
};

}  // namespace vitrine::render::gl
