#include "render/gl/screen.h"

#include <algorithm>
#include <cstddef>

namespace vitrine::render::gl {

void Screen::bind(glm::ivec2 size, glm::ivec2 offset, glm::ivec2 part)
{
    if (size_ != size) {
        GLuint name = 0;
        glCreateTextures(GL_TEXTURE_2D, 1, &name);
        texture_ = TextureName(name);
        glTextureStorage2D(name, 1, GL_RGBA8, size.x, size.y);
        glCreateFramebuffers(1, &name);
        framebuffer_ = FramebufferName(name);
        glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, texture_.name(), 0);
        size_ = size;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(offset.x, offset.y, part.x, part.y);
}

ScreenPixels Screen::read(glm::ivec2 offset, glm::ivec2 part)
{
    const auto row = static_cast<std::size_t>(part.x) * 4;
    const auto rows = static_cast<std::size_t>(part.y);
    ScreenPixels pixels{part.x, part.y, std::vector<std::uint8_t>(row * rows)};
    std::vector<std::uint8_t> fromBelow(pixels.rgba.size());
    glReadPixels(offset.x, offset.y, part.x, part.y, GL_RGBA, GL_UNSIGNED_BYTE, fromBelow.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (std::size_t y = 0; y < rows; ++y)
        std::copy_n(fromBelow.data() + (rows - 1 - y) * row, row, pixels.rgba.data() + y * row);
    return pixels;
}

void Screen::abandon()
{
    texture_.abandon();
    framebuffer_.abandon();
}

}  // namespace vitrine::render::gl
