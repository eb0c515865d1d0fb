#pragma once

#include "render/gl/object.h"
#include "render/gl/screen_pixels.h"

#include <glm/glm.hpp>

namespace vitrine::render::gl {

/// Off-screen substitute for the window's screen, for pictures drawn on another thread: sRGB, 8 bits.
class Screen {
public:
    /// Binds it as the render target with this size. The viewport is the part of `part` pixels from `offset` on.
    void bind(glm::ivec2 size, glm::ivec2 offset, glm::ivec2 part);
    /// Reads the pixels of a part of it and unbinds it.
    [[nodiscard]] ScreenPixels read(glm::ivec2 offset, glm::ivec2 part);
    void abandon();

private:
    TextureName texture_;
    FramebufferName framebuffer_;
    glm::ivec2 size_{0};
};

}  // namespace vitrine::render::gl
